#pragma once
// A session's events, the frames that it sends, and its state and counters, as golden traces.

#include <deque>
#include <functional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "session_rig.h"
#include "support/golden_trace.h"

namespace tp100::link {

class SessionTrace {
 public:
  SessionTrace(const std::string& name, int sampled_ms,
               const SessionSettings& settings = SessionRig::settings())
      : rig(settings),
        happened_("link/" + name + "_events.csv",
                  {"ms", "kind", "a", "b", "c", "d", "e", "f", "g", "h"}),
        states_("link/" + name + "_states.csv", columns()),
        sampled_ms_(sampled_ms) {
    rig.port_takes = false;
    rig.mangle = [this](std::vector<std::uint8_t>& bytes) { delay(bytes); };
  }

  void run(int ms) {
    for (int i = 0; i < ms; ++i) step();
  }

  /// Bytes of the robot, now.
  template <class Message>
  void receive(const Message& message) {
    receive_bytes(frame_of(message));
  }
  void receive_bytes(const std::vector<std::uint8_t>& bytes) {
    rig.session.receive(bytes, rig.now);
    collect();
  }
  /// A frame of this type with a payload of any size.
  void receive_frame(wire::Type type, std::vector<std::uint8_t> payload) {
    payload.resize(std::max<std::size_t>(payload.size(), 1));
    std::vector<std::uint8_t> frame(wire::kMaxFrame);
    frame.resize(wire::encode_frame(static_cast<std::uint8_t>(type), payload.data(), payload.size(),
                                    frame.data()));
    receive_bytes(frame);
  }
  void request(RobotRequest request) {
    rig.session.request(request, rig.now);
    collect();
  }
  /// A row of the state and counters.
  void state() {
    const Session& session = rig.session;
    const ClockState& clock = session.clock();
    std::vector<double> row{
        ms(),
        static_cast<double>(session.state()),
        session.session_number() * 1.0,
        static_cast<double>(session.request_pending()),
        static_cast<double>(session.expects_reply(rig.now)),
        static_cast<double>(session.has_samples()),
        static_cast<double>(session.output().size()),
        session.hello().boot_nonce * 1.0,
        session.hello().protocol * 1.0,
        static_cast<double>(clock.valid),
        clock.uncertainty_us,
        clock.valid ? static_cast<double>(
                          clock.to_host(rig.samples.empty() ? 0 : rig.samples.back().device_us) -
                          (rig.samples.empty() ? 0 : rig.samples.back().measured_ns)) *
                          1e-3
                    : 0.0,
        static_cast<double>(rig.samples.size()),
        static_cast<double>(lost_)};
    each_counter(session.counters(), [&](const char*, std::uint64_t counter) {
      row.push_back(static_cast<double>(counter));
    });
    states_.row(std::move(row));
  }

  std::string difference() const { return happened_.difference() + states_.difference(); }

  SessionRig rig;
  int delay_ms = 0;          ///< of the robot's bytes
  bool port_takes = true;    ///< whether the port takes the session's bytes
  bool robot_hears = true;   ///< whether they reach the robot
  bool writes_down = false;  ///< whether samples are rows too

 private:
  static std::vector<std::string> columns() {
    std::vector<std::string> names{
        "ms",    "state",    "session", "pending",        "expects",  "samples?", "out",
        "nonce", "protocol", "valid",   "uncertainty_us", "moved_us", "taken",    "lost_before"};
    LinkCounters none;
    each_counter(none, [&](const char* name, std::uint64_t) { names.push_back(name); });
    return names;
  }

  double ms() const { return to_s(rig.now - kNsPerS) * 1e3; }

  void step() {
    const std::size_t taken = rig.samples.size();
    rig.step();
    at_ns_ = rig.now;
    for (std::size_t i = taken; i < rig.samples.size(); ++i) {
      const Sample& sample = rig.samples[i];
      lost_ += sample.lost_before;
      if (writes_down)
        row(50, sample.sequence, sample.lost_before, low(sample.device_us),
            static_cast<double>(rig.now - sample.measured_ns) * 1e-3, low(sample.left_counts),
            low(sample.right_counts), sample.last_command, static_cast<double>(sample.state));
    }
    collect();
    if (++steps_ % sampled_ms_ == 0) state();
    if (!port_takes) return;
    const std::vector<std::uint8_t> sent(rig.session.output().begin(), rig.session.output().end());
    rig.session.written(sent.size());
    for (const std::uint8_t byte : sent)
      if (decoder_.push(byte) == wire::DecodeResult::kFrame) on_sent(sent.size());
    if (robot_hears) rig.robot.receive(sent, rig.now);
  }

  void collect() {
    rig.collect();
    for (; written_ < rig.events.size(); ++written_) {
      at_ns_ = rig.events[written_].at_ns;
      std::visit([this](const auto& what) { note(what); }, rig.events[written_].what);
    }
    at_ns_ = rig.now;
    if (const RequestAnswer answer = rig.session.take_answer(); answer != RequestAnswer::kNone)
      row(30, static_cast<double>(answer));
    if (rig.session.take_rebooted()) row(31);
  }

  void delay(std::vector<std::uint8_t>& bytes) {
    if (!bytes.empty()) on_the_way_.emplace_back(rig.now + delay_ms * kNsPerMs, bytes);
    bytes.clear();
    while (!on_the_way_.empty() && on_the_way_.front().first <= rig.now) {
      const auto& arrived = on_the_way_.front().second;
      bytes.insert(bytes.end(), arrived.begin(), arrived.end());
      on_the_way_.pop_front();
    }
  }

  void row(double kind, double a = 0, double b = 0, double c = 0, double d = 0, double e = 0,
           double f = 0, double g = 0, double h = 0) {
    happened_.row({to_s(at_ns_ - kNsPerS) * 1e3, kind, a, b, c, d, e, f, g, h});
  }
  static double low(std::int64_t value) { return static_cast<double>(value & 0xFFFF); }
  static double high(std::int64_t value) { return static_cast<double>(value >> 16 & 0xFFFF); }

  void note(const StateChanged& event) {
    row(1, static_cast<double>(event.from), static_cast<double>(event.to));
  }
  void note(const HelloReceived&) {
    const wire::Hello& hello = rig.session.hello();
    row(2, low(hello.boot_nonce), hello.board, hello.state, hello.faults);
  }
  void note(const VersionMismatch&) {
    const wire::Hello& hello = rig.session.hello();
    row(3, hello.protocol, low(hello.schema), high(hello.schema), hello.firmware[0],
        hello.firmware[1], hello.firmware[2]);
  }
  void note(const BadHello& event) { row(4, low(event.boot_nonce), event.state); }
  void note(const UnknownBoard& event) { row(5, event.board); }
  void note(const Rebooted&) { row(6); }
  void note(const RobotFault& event) { row(7, event.fault, low(event.value), high(event.value)); }
  void note(const RobotLog& event) {
    int sum = 0, size = 0;
    for (const char c : event.text) sum += ++size * c;
    row(8, low(event.device_us), high(event.device_us), sum);
  }
  void note(const Acknowledged& event) {
    row(9, static_cast<double>(event.request), static_cast<double>(event.result), event.detail);
  }
  void note(const NotAcknowledged& event) { row(10, static_cast<double>(event.request)); }
  void note(const Silence& event) { row(11, static_cast<double>(event.state)); }
  void note(const Unanswered& event) {
    row(12, static_cast<double>(event.state), to_s(event.too_late_ns) * 1e3);
  }

  template <class Message>
  Message sent() const {
    Message message{};
    wire::read_payload(decoder_.payload(), decoder_.size(), message);
    return message;
  }
  void on_sent(std::size_t bytes) {
    const auto size = static_cast<double>(bytes);
    const wire::Type type{decoder_.type()};
    const double kind = 100.0 + decoder_.type();
    if (type == wire::Type::kHelloRequest) {
      const auto m = sent<wire::HelloRequest>();
      row(kind, m.protocol, low(m.schema), high(m.schema), size);
    } else if (type == wire::Type::kParameters) {
      const auto m = sent<wire::Parameters>();
      row(kind, low(m.boot_nonce), high(m.boot_nonce), low(m.token), high(m.token),
          static_cast<double>(m.wheelbase_m), static_cast<double>(m.counts_per_metre), size);
    } else if (type == wire::Type::kCommand) {
      const auto m = sent<wire::Command>();
      row(kind, low(m.boot_nonce), m.sequence, m.answers, low(m.expiry_us), high(m.expiry_us),
          size);
      row(kind + 0.5, static_cast<double>(m.x_m), static_cast<double>(m.y_m),
          static_cast<double>(m.yaw_rad), static_cast<double>(m.desired_yaw_rad),
          static_cast<double>(m.yaw_rate_radps), static_cast<double>(m.speed_mps),
          static_cast<double>(m.gyro_bias_radps));
    } else if (type == wire::Type::kArm) {
      const auto m = sent<wire::Arm>();
      row(kind, low(m.boot_nonce), high(m.boot_nonce), low(m.token), high(m.token),
          low(m.expiry_us), high(m.expiry_us), size);
    } else if (type == wire::Type::kSyncRequest) {
      row(kind, sent<wire::SyncRequest>().id, size);
    } else {
      const auto m = sent<wire::Stop>();
      row(kind, low(m.token), high(m.token), size);
    }
  }

  test::GoldenTrace happened_, states_;
  int sampled_ms_;
  int steps_ = 0;
  HostNs at_ns_ = 0;
  std::size_t written_ = 0;
  std::uint64_t lost_ = 0;
  std::deque<std::pair<HostNs, std::vector<std::uint8_t>>> on_the_way_;
  wire::FrameDecoder decoder_;
};

}  // namespace tp100::link
