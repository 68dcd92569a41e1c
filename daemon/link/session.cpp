#include "link/session.h"

#include <algorithm>
#include <utility>

#include "core/belt_speed.h"

namespace tp100::link {
namespace {

using wire::Result;
using wire::Type;

// Tokens of an earlier daemon in the same boot of the robot lie below: 10 ms a step, wraps after
// 497 days.
constexpr HostNs kTokenTickNs = 10 * kNsPerMs;
constexpr std::uint32_t kTokenLeap = 1U << 24U;
// Protocol, firmware version and schema open every hello, whatever its version.
constexpr std::size_t kHelloPrefix = 9;

// After so many samples, a second, a session has lasted.
constexpr std::uint32_t kLasted = 200;
constexpr HostNs kFirstRetryNs = 200 * kNsPerMs;
constexpr HostNs kLongestRetryNs = 5 * kNsPerS;

std::int32_t number(SessionState state) { return static_cast<std::int32_t>(state); }
std::int32_t number(Type type) { return static_cast<std::int32_t>(type); }

/// Whether this version knows the kind of board. An unknown one may drive if it speaks the
/// protocol, after a warning.
bool known(std::uint8_t board) {
  return board == static_cast<std::uint8_t>(wire::Board::kMega2560) ||
         board == static_cast<std::uint8_t>(wire::Board::kNative);
}

double max_counts_per_s(const wire::Parameters& parameters) {
  return kFastestBelt * static_cast<double>(parameters.max_track_mps) *
         static_cast<double>(parameters.counts_per_metre);
}

}  // namespace

Session::Session(const SessionSettings& settings)
    : settings_(settings), intake_(counters_, max_counts_per_s(settings.parameters)) {}

void Session::open(HostNs now) {
  end_session(now);
  reader_.reset();
  output_.reset();
  last_good_ns_ = now;
  next_hello_ns_ = now;
  enter(SessionState::kListening, now);
}

void Session::close(HostNs now) {
  end_session(now);
  reader_.reset();
  output_.reset();
  enter(SessionState::kClosed, now);
}

void Session::receive(std::span<const std::uint8_t> bytes, HostNs now) {
  counters_.bytes_in += bytes.size();
  if (state_ == SessionState::kClosed) return;
  for (const std::uint8_t byte : bytes) {
    if (reader_.push(byte)) on_frame(now);
  }
}

template <class Message>
bool Session::read(Message& message) {
  if (wire::read_payload(reader_.payload(), reader_.size(), message)) return true;
  ++counters_.wrong_size;
  return false;
}

void Session::on_frame(HostNs now) {
  // In a session it is samples that are waited for, whatever else the robot sends.
  if (!in_session()) last_good_ns_ = now;
  const Type type{reader_.type()};
  if (state_ == SessionState::kListening) {
    if (stop_.pending()) stop_.start(next_token(now), now);
    if (type != Type::kHello) ask_hello(now);
  }
  switch (type) {
    case Type::kHello:
      return on_hello(now);
    case Type::kSample: {
      wire::Sample sample;
      if (read(sample)) on_sample(sample, now);
      return;
    }
    case Type::kAcknowledge: {
      wire::Acknowledge acknowledge;
      if (read(acknowledge)) on_acknowledge(acknowledge, now);
      return;
    }
    case Type::kSyncReply: {
      wire::SyncReply reply;
      if (read(reply)) on_sync_reply(reply, now);
      return;
    }
    case Type::kFaultReport: {
      wire::FaultReport report;
      if (read(report)) on_fault(report, now);
      return;
    }
    case Type::kLog: {
      wire::Log log;
      if (read(log)) on_log(log, now);
      return;
    }
    default:
      ++counters_.unknown_type;
  }
}

void Session::on_hello(HostNs now) {
  wire::Hello hello;
  if (!wire::read_payload(reader_.payload(), reader_.size(), hello)) return on_other_hello(now);
  if (hello.protocol != wire::kProtocolVersion || hello.schema != wire::kSchemaHash) {
    return on_other_hello(now);
  }
  if (hello.boot_nonce == 0 || hello.state > static_cast<std::uint8_t>(wire::State::kFaulted))
    return on_bad_hello(hello, now);
  const bool same_boot = known_boot_ && hello.boot_nonce == hello_.boot_nonce;
  // A hello that was under way when the parameters were sent, or of a boot that refused them.
  if (same_boot && (state_ == SessionState::kParameters || state_ == SessionState::kRefused))
    return;
  if (known_boot_ && !same_boot) {
    ++counters_.reboots;
    rebooted_ = true;
  }
  const bool reboot = known_boot_ && !same_boot;
  hello_ = hello;
  known_boot_ = true;
  if (!same_boot) {
    new_boot_ = true;
    device_clock_.forget();
  }
  if (reboot) note(SessionEvent::Kind::kReboot, now, 0, 0, hello.boot_nonce);
  note(SessionEvent::Kind::kHello, now);
  if (!known(hello.board)) {
    ++counters_.unknown_board;
    note(SessionEvent::Kind::kUnknownBoard, now, hello.board);
  }
  if (same_boot) back_off(now);
  end_session(now);
  settings_.parameters.boot_nonce = hello.boot_nonce;
  settings_.parameters.token = next_token(now);
  next_parameters_ns_ = now;
  enter(SessionState::kParameters, now);
}

void Session::on_other_hello(HostNs now) {
  if (reader_.size() < kHelloPrefix) {
    ++counters_.wrong_size;
    return;
  }
  wire::Hello hello{};
  wire::Reader prefix(reader_.payload());
  prefix.field("", hello.protocol);
  prefix.field("", hello.firmware);
  prefix.field("", hello.schema);
  if (hello.protocol == wire::kProtocolVersion && hello.schema == wire::kSchemaHash) {
    ++counters_.wrong_size;
    return;
  }
  const bool repeated = state_ == SessionState::kRefused && hello.protocol == hello_.protocol &&
                        hello.schema == hello_.schema;
  if (repeated) return;
  end_session(now);
  hello_ = hello;
  known_boot_ = false;
  ++counters_.refused;
  enter(SessionState::kRefused, now);
  note(SessionEvent::Kind::kVersionMismatch, now, hello.protocol, wire::kProtocolVersion,
       hello.schema);
}

// Its nonce guards nothing, or its state is not one of ours: it is not spoken to.
void Session::on_bad_hello(const wire::Hello& hello, HostNs now) {
  if (state_ == SessionState::kRefused && hello.boot_nonce == hello_.boot_nonce &&
      hello.state == hello_.state)
    return;
  end_session(now);
  hello_ = hello;
  known_boot_ = false;
  ++counters_.refused;
  enter(SessionState::kRefused, now);
  note(SessionEvent::Kind::kBadHello, now, static_cast<std::int32_t>(hello.boot_nonce),
       hello.state);
}

void Session::on_sample(const wire::Sample& sample, HostNs now) {
  if (!in_session()) {
    ++counters_.early;
    return;
  }
  if (!sequence_known_) {
    command_sequence_ = sample.last_command;
    sequence_known_ = true;
  }
  const DeviceUs device_us = device_clock_.extend(sample.device_us, now);
  const ClockState clock = state_ == SessionState::kReady ? sync_.state() : ClockState{};
  if (intake_.push(sample, device_us, clock, now)) {
    last_good_ns_ = now;
    ++taken_;
  }
  if (intake_.nonsense()) ask_hello(now);
}

void Session::on_acknowledge(const wire::Acknowledge& acknowledge, HostNs now) {
  const auto result = static_cast<std::int32_t>(acknowledge.result);
  const bool accepted = acknowledge.result == static_cast<std::uint8_t>(Result::kAccepted);
  const Type type{acknowledge.request};
  if (type == Type::kParameters) return on_parameters_answer(acknowledge, now);
  if (type == Type::kStop) {
    if (!stop_.acknowledge(acknowledge.token)) return;
  } else if (type == motion_type_ && motion_.acknowledge(acknowledge.token)) {
    answer_ = accepted ? RequestAnswer::kAcknowledged : RequestAnswer::kFailed;
    if (acknowledge.result == static_cast<std::uint8_t>(Result::kStaleToken)) token_ += kTokenLeap;
  } else if (type == Type::kArm && accepted && acknowledge.token == overdue_arm_token_) {
    // Armed after all, but nobody waits for it any more.
    overdue_arm_token_ = 0;
    if (!motion_.pending()) request(RobotRequest::kDisarm, now);
    return;
  } else {
    return;
  }
  note(SessionEvent::Kind::kAcknowledged, now, number(type), result, acknowledge.detail);
}

void Session::on_parameters_answer(const wire::Acknowledge& acknowledge, HostNs now) {
  if (state_ != SessionState::kParameters || acknowledge.token != settings_.parameters.token)
    return;
  note(SessionEvent::Kind::kAcknowledged, now, number(Type::kParameters), acknowledge.result,
       acknowledge.detail);
  switch (Result{acknowledge.result}) {
    case Result::kAccepted:
      return begin_session(now);
    case Result::kStaleToken:
      token_ += kTokenLeap;
      settings_.parameters.token = next_token(now);
      return;
    case Result::kOutOfRange:
      ++counters_.refused;
      return enter(SessionState::kRefused, now);
    default:
      return ask_hello(now);
  }
}

void Session::on_sync_reply(const wire::SyncReply& reply, HostNs now) {
  if (!in_session()) {
    ++counters_.sync_rejected;
    return;
  }
  count_robots_own(reply);
  const DeviceUs received_us = device_clock_.extend(reply.received_us, now);
  const DeviceUs sent_us = device_clock_.extend(reply.sent_us, now);
  const auto verdict =
      sync_.answered(reply.id, received_us, sent_us, now, wire_ns(reader_.frame_bytes()));
  if (verdict == ClockSync::Verdict::kAccepted || verdict == ClockSync::Verdict::kRestarted) {
    ++counters_.sync_replies;
  } else {
    ++counters_.sync_rejected;
  }
  clock_ = sync_.state_at(now);
  if (state_ == SessionState::kSyncing && clock_.valid) {
    if (++session_number_ > 1) ++counters_.reconnects;
    enter(SessionState::kReady, now);
  }
}

// What the robot counted before the session is another's, or the bootloader's; an old reply may
// come late.
void Session::count_robots_own(const wire::SyncReply& reply) {
  const wire::SyncReply before = last_reply_.value_or(reply);
  const auto damaged = wrapped_difference(reply.damaged, before.damaged);
  const auto missed = wrapped_difference(reply.missed_edges, before.missed_edges);
  if (damaged < 0 || missed < 0) return;
  counters_.robot_damaged += static_cast<std::uint64_t>(damaged);
  counters_.missed_edges += static_cast<std::uint64_t>(missed);
  last_reply_ = reply;
}

void Session::on_fault(const wire::FaultReport& report, HostNs now) {
  ++counters_.robot_faults;
  if (SessionEvent* event = new_event(SessionEvent::Kind::kRobotFault, now, kMaxEvents / 2)) {
    event->a = report.fault;
    event->b = report.detail;
    event->detail = report.device_us;
  }
}

void Session::on_log(const wire::Log& log, HostNs now) {
  SessionEvent* event = new_event(SessionEvent::Kind::kRobotLog, now, kMaxEvents / 2);
  if (event == nullptr) return;
  event->a = log.level;
  event->detail = log.device_us;
  for (std::size_t i = 0; i < wire::Log::kTextSize && log.text[i] != 0; ++i) {
    const auto character = static_cast<char>(log.text[i]);
    event->text[i] = character >= ' ' && character <= '~' ? character : '?';
  }
}

void Session::ask_hello(HostNs now) {
  back_off(now);
  end_session(now);
  enter(SessionState::kHello, now);
}

void Session::begin_session(HostNs now) {
  intake_.begin(new_boot_);
  new_boot_ = false;
  sequence_known_ = false;
  last_reply_.reset();
  taken_ = 0;
  sync_.reset(now);
  clock_ = {};
  enter(SessionState::kSyncing, now);
}

void Session::end_session(HostNs now) {
  fail_arm(now);
  motion_.cancel();
  clock_ = {};
}

void Session::back_off(HostNs now) {
  if (!in_session()) return;
  if (taken_ >= kLasted) {
    retry_ns_ = 0;
  } else {
    retry_ns_ = std::clamp(2 * retry_ns_, kFirstRetryNs, kLongestRetryNs);
  }
  not_before_ns_ = now + retry_ns_;
}

void Session::fail_arm(HostNs now) {
  if (!motion_.pending() || motion_type_ != Type::kArm) return;
  overdue_arm_token_ = motion_.token();
  motion_.cancel();
  answer_ = RequestAnswer::kFailed;
  note(SessionEvent::Kind::kNotAcknowledged, now, number(Type::kArm));
}

std::span<const Sample> Session::take_samples() { return intake_.take(); }

std::span<const SessionEvent> Session::take_events() {
  const std::span<const SessionEvent> result(events_.data(), event_count_);
  event_count_ = 0;
  return result;
}

std::span<const std::uint8_t> Session::output() const { return output_.bytes(); }
void Session::written(std::size_t n) { output_.written(n); }
void Session::drop_output() { output_.drop(); }

SessionState Session::state() const { return state_; }
const LinkCounters& Session::counters() const { return counters_; }
const ClockState& Session::clock() const { return clock_; }
const wire::Hello& Session::hello() const { return hello_; }
std::uint32_t Session::session_number() const { return session_number_; }

bool Session::take_rebooted() { return std::exchange(rebooted_, false); }
RequestAnswer Session::take_answer() { return std::exchange(answer_, RequestAnswer::kNone); }

void Session::enter(SessionState state, HostNs now) {
  if (state == state_) return;
  note(SessionEvent::Kind::kState, now, number(state_), number(state));
  if (!in_handshake()) handshake_ns_ = now;
  state_ = state;
}

bool Session::connected() const {
  return in_session() || state_ == SessionState::kHello || state_ == SessionState::kParameters;
}

bool Session::in_handshake() const { return connected() && state_ != SessionState::kReady; }

bool Session::in_session() const {
  return state_ == SessionState::kSyncing || state_ == SessionState::kReady;
}

std::uint32_t Session::next_token(HostNs now) {
  const auto tick = static_cast<std::uint32_t>(now / kTokenTickNs);
  token_ = std::max(token_, tick) + 1;
  return token_;
}

HostNs Session::wire_ns(std::size_t bytes) const {
  constexpr HostNs kBitsPerByte = 10;
  if (settings_.baud == 0) return 0;
  return static_cast<HostNs>(bytes) * kBitsPerByte * kNsPerS / settings_.baud;
}

void Session::note(SessionEvent::Kind kind, HostNs now, std::int32_t a, std::int32_t b,
                   std::uint32_t detail) {
  if (SessionEvent* event = new_event(kind, now, kMaxEvents)) {
    event->a = a;
    event->b = b;
    event->detail = detail;
  }
}

SessionEvent* Session::new_event(SessionEvent::Kind kind, HostNs now, std::size_t room) {
  if (event_count_ >= room) return nullptr;
  SessionEvent& event = events_[event_count_++];
  event = {};
  event.kind = kind;
  event.at_ns = now;
  return &event;
}

}  // namespace tp100::link
