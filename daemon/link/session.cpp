#include "link/session.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/arithmetic.h"
#include "core/board.h"
#include "core/sample.h"
#include "shared/number.h"

namespace tp100::link {
namespace {

using wire::Result;
using wire::Type;

// A session counts as lasting after this many samples, one second.
constexpr std::uint32_t kLasted = 200;
constexpr HostNs kFirstRetryNs = 200 * kNsPerMs;
constexpr HostNs kLongestRetryNs = 5 * kNsPerS;
constexpr HostNs kHelloRequestPeriodNs = 200 * kNsPerMs;
constexpr HostNs kParametersPeriodNs = 100 * kNsPerMs;
// After kHostSilenceMs of silence the robot considers the host lost.
constexpr HostNs kKeepAliveNs = 400 * kNsPerMs;
constexpr HostNs kArmLifeNs = kAnswerNs;
// A sequence that is 2^15 ahead of the last accepted one counts as old.
constexpr std::int16_t kFurthestAhead = 1 << 14;
// The robot refuses a yaw beyond 1000 rad, and needs only the difference of the two.
constexpr double kFarYawRad = 100.0;

double fastest_of(const wire::Parameters& parameters) {
  return max_counts_per_s(static_cast<double>(parameters.max_track_mps),
                          static_cast<double>(parameters.counts_per_metre));
}

}  // namespace

std::optional<wire::Hello> read_hello(const std::uint8_t* payload, std::size_t size) {
  constexpr std::size_t kPrefix = 9;
  if (size < kPrefix) return std::nullopt;
  wire::Hello hello{};
  wire::Reader prefix(payload);
  prefix.field("", hello.protocol);
  prefix.field("", hello.firmware);
  prefix.field("", hello.schema);
  if (is_ours(hello) && !wire::read_payload(payload, size, hello)) return std::nullopt;
  return hello;
}

bool is_ours(const wire::Hello& hello) {
  return hello.protocol == wire::kProtocolVersion && hello.schema == wire::kSchemaHash;
}

Session::Session(const SessionSettings& settings)
    : settings_(settings),
      intake_(counters_, fastest_of(settings.parameters)),
      clock_(settings.baud, settings.clock_answer_ns, output_, counters_) {}

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

void Session::use(const wire::Parameters& parameters, HostNs now) {
  settings_.parameters = parameters;
  intake_.set_limit(fastest_of(parameters));
  // A board that refused the old ones may take these.
  if (!connected() && !(state_ == SessionState::kRefused && known_boot_)) return;
  // Without back_off(): the robot is not to blame, and latches a fault after 200 ms without
  // commands.
  end_session(now);
  next_hello_ns_ = not_before_ns_ = now;
  enter(SessionState::kHello, now);
}

void Session::receive(std::span<const std::uint8_t> bytes, HostNs now) {
  counters_.bytes_in += bytes.size();
  if (state_ == SessionState::kClosed) return;
  for (const std::uint8_t byte : bytes) {
    if (reader_.push(byte)) on_frame(now);
  }
}

template <class Message>
void Session::read(void (Session::*take)(const Message&, HostNs), HostNs now) {
  Message message;
  if (!wire::read_payload(reader_.payload(), reader_.size(), message)) {
    ++counters_.wrong_size;
    return;
  }
  (this->*take)(message, now);
}

void Session::on_frame(HostNs now) {
  // Within a session only samples count as a sign of life, whatever else the robot sends.
  if (!in_session()) last_good_ns_ = now;
  const Type type{reader_.type()};
  if (state_ == SessionState::kListening) {
    requests_.restart_stop(now);
    if (type != Type::kHello) ask_hello(now);
  }
  switch (type) {
    case Type::kHello:
      return on_hello(now);
    case Type::kSample:
      return read(&Session::on_sample, now);
    case Type::kAcknowledge:
      return read(&Session::on_acknowledge, now);
    case Type::kSyncReply:
      return read(&Session::on_sync_reply, now);
    case Type::kFaultReport:
      return read(&Session::on_fault, now);
    case Type::kLog:
      return read(&Session::on_log, now);
    default:
      ++counters_.unknown_type;
  }
}

void Session::on_hello(HostNs now) {
  const std::optional<wire::Hello> read = read_hello(reader_.payload(), reader_.size());
  if (!read) {
    ++counters_.wrong_size;
    return;
  }
  const wire::Hello& hello = *read;
  if (!is_ours(hello)) return on_other_hello(hello, now);
  if (hello.boot_nonce == 0 || hello.state > static_cast<std::uint8_t>(wire::State::kFaulted))
    return on_bad_hello(hello, now);
  const bool same_boot = known_boot_ && hello.boot_nonce == hello_.boot_nonce;
  // A hello that was in transit when the parameters were sent, or of a boot that refused them.
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
    clock_.forget_boot();
  }
  if (reboot) events_.note(Rebooted{}, now);
  events_.note(HelloReceived{}, now);
  if (!is_known_board(hello.board)) {
    ++counters_.unknown_board;
    events_.note(UnknownBoard{hello.board}, now);
  }
  if (same_boot) back_off(now);
  end_session(now);
  settings_.parameters.boot_nonce = hello.boot_nonce;
  settings_.parameters.token = tokens_.next(now);
  next_parameters_ns_ = now;
  enter(SessionState::kParameters, now);
}

void Session::on_other_hello(const wire::Hello& hello, HostNs now) {
  const bool repeated = state_ == SessionState::kRefused && hello.protocol == hello_.protocol &&
                        hello.schema == hello_.schema;
  if (repeated) return;
  refuse(hello, now);
  events_.note(VersionMismatch{}, now);
}

// The hello's nonce is 0 or its state unknown.
void Session::on_bad_hello(const wire::Hello& hello, HostNs now) {
  if (state_ == SessionState::kRefused && hello.boot_nonce == hello_.boot_nonce &&
      hello.state == hello_.state)
    return;
  refuse(hello, now);
  events_.note(BadHello{hello.boot_nonce, hello.state}, now);
}

// From now on nothing is sent to a board with such a hello.
void Session::refuse(const wire::Hello& hello, HostNs now) {
  end_session(now);
  hello_ = hello;
  known_boot_ = false;
  ++counters_.refused;
  enter(SessionState::kRefused, now);
}

void Session::on_sample(const wire::Sample& sample, HostNs now) {
  if (!in_session()) {
    ++counters_.early;
    return;
  }
  const auto ahead = shared::wrapped_difference(command_sequence_, sample.last_command);
  if (!std::exchange(sequence_known_, true) || ahead < 0 || ahead > kFurthestAhead)
    command_sequence_ = sample.last_command;
  const DeviceUs device_us = clock_.extend(sample.device_us, now);
  const ClockState clock = state_ == SessionState::kReady ? clock_.fitted() : ClockState{};
  if (intake_.push(sample, device_us, clock, now)) {
    last_good_ns_ = now;
    ++taken_;
  }
  if (intake_.nonsense()) ask_hello(now);
}

void Session::on_acknowledge(const wire::Acknowledge& acknowledge, HostNs now) {
  if (Type{acknowledge.request} == Type::kParameters) return on_parameters_answer(acknowledge, now);
  if (requests_.on_acknowledge(acknowledge, now)) request(RobotRequest::kDisarm, now);
}

void Session::on_parameters_answer(const wire::Acknowledge& acknowledge, HostNs now) {
  if (state_ != SessionState::kParameters || acknowledge.token != settings_.parameters.token)
    return;
  const Result result{acknowledge.result};
  events_.note(Acknowledged{Type::kParameters, result, acknowledge.detail}, now);
  switch (result) {
    case Result::kAccepted:
      return begin_session(now);
    case Result::kStaleToken:
      tokens_.leap();
      settings_.parameters.token = tokens_.next(now);
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
  clock_.on_reply(reply, reader_.frame_bytes(), now);
  if (state_ == SessionState::kSyncing && clock_.state().valid) {
    if (++session_number_ > 1) ++counters_.reconnects;
    enter(SessionState::kReady, now);
  }
}

void Session::on_fault(const wire::FaultReport& report, HostNs now) {
  ++counters_.robot_faults;
  events_.note_from_robot(RobotFault{report.fault, report.detail}, now);
}

void Session::on_log(const wire::Log& log, HostNs now) {
  RobotLog clean{log.device_us, {}};
  for (std::size_t i = 0; i < wire::Log::kTextSize && log.text[i] != 0; ++i) {
    const auto character = static_cast<char>(log.text[i]);
    clean.text[i] = character >= ' ' && character <= '~' ? character : '?';
  }
  events_.note_from_robot(clean, now);
}

void Session::poll(HostNs now) {
  poll_timeout(now);
  poll_unanswered(now);
  if (requests_.poll(connected(), now)) last_sent_ns_ = now;
  poll_handshake(now);
  if (in_session() && clock_.request(now - last_sent_ns_ >= kKeepAliveNs, now)) last_sent_ns_ = now;
  clock_.age(now);
}

void Session::poll_timeout(HostNs now) {
  if (state_ == SessionState::kClosed) return;
  const bool listening = state_ == SessionState::kListening;
  const HostNs limit = listening ? settings_.first_frame_timeout_ns : settings_.timeout_ns;
  if (now - last_good_ns_ < limit) return;
  ++counters_.silences;
  events_.note(Silence{state_}, now);
  last_good_ns_ = now;
  if (listening) return;
  back_off(now);
  end_session(now);
  output_.reset();
  enter(SessionState::kListening, now);
}

// The link may work in one direction only.
void Session::poll_unanswered(HostNs now) {
  const HostNs since = std::max(handshake_ns_, not_before_ns_);
  if (!in_handshake() || now - since < settings_.first_frame_timeout_ns) return;
  ++counters_.unanswered;
  const bool late = state_ == SessionState::kSyncing && clock_.late() > 0;
  events_.note(Unanswered{state_, late ? clock_.answer_ns() : 0}, now);
  handshake_ns_ = now;
}

void Session::poll_handshake(HostNs now) {
  if (now < not_before_ns_) return;
  if (state_ == SessionState::kHello && now >= next_hello_ns_) {
    output_.push(wire::HelloRequest{wire::kProtocolVersion, wire::kSchemaHash});
    next_hello_ns_ = now + kHelloRequestPeriodNs;
    last_sent_ns_ = now;
  }
  if (state_ == SessionState::kParameters && now >= next_parameters_ns_) {
    output_.push(settings_.parameters);
    next_parameters_ns_ = now + kParametersPeriodNs;
    last_sent_ns_ = now;
  }
}

void Session::send(const Command& command, HostNs now) {
  if (!in_session()) return;
  wire::Command out{};
  out.boot_nonce = hello_.boot_nonce;
  out.sequence = ++command_sequence_;
  out.answers = command.answers;
  out.x_m = static_cast<float>(command.pose.x_m);
  out.y_m = static_cast<float>(command.pose.y_m);
  const double yaw_rad = command.pose.yaw_rad;
  const double turns_rad = std::abs(yaw_rad) <= kFarYawRad ? 0.0 : yaw_rad - wrap_angle(yaw_rad);
  out.yaw_rad = static_cast<float>(yaw_rad - turns_rad);
  out.desired_yaw_rad = static_cast<float>(command.desired_yaw_rad - turns_rad);
  out.yaw_rate_radps = static_cast<float>(command.yaw_rate_radps);
  out.speed_mps = static_cast<float>(command.speed_mps);
  out.expiry_us = static_cast<std::uint32_t>(command.expiry_us);
  out.gyro_bias_radps = static_cast<float>(command.gyro_bias_radps);
  if (output_.push(out) > 0) last_sent_ns_ = now;
}

void Session::request(RobotRequest request, HostNs now) {
  switch (request) {
    case RobotRequest::kNone:
      return;
    case RobotRequest::kStop:
      return requests_.stop(now);
    case RobotRequest::kDisarm:
      if (!connected()) return requests_.refuse(Type::kDisarm, now);
      return requests_.disarm(now);
    case RobotRequest::kArm: {
      if (state_ != SessionState::kReady) return requests_.refuse(Type::kArm, now);
      const DeviceUs expiry_us = clock_.state().to_device(now + kArmLifeNs);
      return requests_.arm(hello_.boot_nonce, static_cast<std::uint32_t>(expiry_us), now);
    }
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
  taken_ = 0;
  clock_.begin_session(now);
  enter(SessionState::kSyncing, now);
}

void Session::end_session(HostNs now) {
  requests_.end_session(now);
  clock_.end_session();
}

void Session::back_off(HostNs now) {
  if (!in_session()) return;
  retry_ns_ = taken_ >= kLasted ? 0 : std::clamp(2 * retry_ns_, kFirstRetryNs, kLongestRetryNs);
  not_before_ns_ = now + retry_ns_;
}

void Session::enter(SessionState state, HostNs now) {
  if (state == state_) return;
  events_.note(StateChanged{state_, state}, now);
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

}  // namespace tp100::link
