#include "worlds/peer.h"

#include <algorithm>
#include <cmath>

namespace tp100::worlds {
namespace {

constexpr HostNs kHelloEveryNs = 250 * kNsPerMs;
constexpr double kSmoothing = 0.01;

double ms(HostNs ns) { return static_cast<double>(ns) * 1e-6; }

}  // namespace

Peer::Peer(PeerSettings settings)
    : settings_(std::move(settings)), session_(settings_.hello.session) {}

std::optional<std::string> Peer::step(const StepRecord& record, HostNs now) {
  passed_.left_mps += record.snapshot.left_mps;
  passed_.right_mps += record.snapshot.right_mps;
  ++passed_.steps;
  const RunState state = record.snapshot.run_state;
  if (state == RunState::kRunning && run_state_ != RunState::kRunning) ++run_;
  run_state_ = state;
  if (welcomed_ && now - received_ns_ > from_s(settings_.hello.timeout_s)) {
    welcomed_ = false;
    ++counters_.losses;
    ++session_;
    began_ = false;
    note_ = "world: " + name_ + " is silent";
  }
  if (began_ && now < next_ns_) return std::nullopt;
  const HostNs period_ns = welcomed_ ? from_s(1.0 / settings_.hello.rate_hz) : kHelloEveryNs;
  // Steps are not exactly on time: keep the mean rate unless much was missed.
  next_ns_ = began_ && now - next_ns_ < period_ns ? next_ns_ + period_ns : now + period_ns;
  began_ = true;
  if (welcomed_) return pose(record, now);
  ++counters_.hellos;
  Hello hello = settings_.hello;
  hello.session = session_;
  return encode(hello);
}

std::string Peer::pose(const StepRecord& record, HostNs now) {
  const Snapshot& snapshot = record.snapshot;
  ++counters_.poses;
  ++sequence_;
  poses_[sequence_ % poses_.size()] = {sequence_, record.now_ns, now};
  PoseReport report;
  report.session = session_;
  report.sequence = sequence_;
  report.stamp_s = to_s(record.now_ns);
  report.run = run_;
  report.source = snapshot.steering;
  report.pose = snapshot.world;
  report.floor = poses_of(snapshot.estimates);
  report.twist = snapshot.estimates[snapshot.steering].twist;
  report.left_mps = passed_.left_mps / passed_.steps;
  report.right_mps = passed_.right_mps / passed_.steps;
  passed_ = {};
  report.slip_left = snapshot.slip_left;
  report.slip_right = snapshot.slip_right;
  report.mode = snapshot.run_state;
  report.desired_yaw_rad = snapshot.command.desired_yaw_rad;
  report.speed_mps = snapshot.command.speed_mps;
  return encode(report, settings_.hello.frame);
}

std::optional<WorldSample> Peer::receive(std::string_view datagram, std::uint16_t port,
                                         HostNs now) {
  ++counters_.received;
  const Decoded decoded = decode_world(datagram, settings_.hello.frame);
  switch (decoded.verdict) {
    case Decoded::Verdict::kMalformed:
      ++counters_.malformed;
      return std::nullopt;
    case Decoded::Verdict::kOtherVersion:
      ++counters_.wrong_version;
      refuse("this is world/" + std::to_string(kWorldVersion) + ", not world/" +
             std::to_string(decoded.version) + "; use a world of the same version");
      return std::nullopt;
    case Decoded::Verdict::kGood:
      break;
  }
  const WorldMessage& message = decoded.message;
  if (message.session && *message.session != session_) {
    ++counters_.foreign;
    return std::nullopt;
  }
  if (message.type == WorldMessage::Type::kWelcome) {
    welcome(message, port, now);
    return std::nullopt;
  }
  if (!welcomed_ || port != port_) {
    ++counters_.foreign;
    return std::nullopt;
  }
  return world(message, now);
}

void Peer::welcome(const WorldMessage& message, std::uint16_t port, HostNs now) {
  if (welcomed_) {
    // The world also replied to the second of two hellos.
    ++(port == port_ ? counters_.accepted : counters_.foreign);
    return;
  }
  const Hello& hello = settings_.hello;
  const std::string_view frame = to_string(hello.frame);
  const std::string_view authority = to_string(hello.authority);
  if ((message.frame && *message.frame != frame) ||
      (message.authority && *message.authority != authority)) {
    ++counters_.malformed;
    refuse("the bridge has world.frame " + std::string(frame) + " and world.authority " +
           std::string(authority) + "; set the same in both programs");
    return;
  }
  ++counters_.accepted;
  ++counters_.sessions;
  welcomed_ = true;
  refused_ = false;
  began_ = false;
  port_ = port;
  name_ = message.name.empty() ? "the world" : message.name;
  received_ns_ = now;
  world_sequence_ = 0;
  answers_ = 0;
  stamp_s_.reset();
  note_ = "world: connected to " + name_;
}

const Peer::Sent* Peer::find(std::uint64_t sequence) const {
  const Sent& sent = poses_[sequence % poses_.size()];
  return sequence != 0 && sent.sequence == sequence ? &sent : nullptr;
}

std::optional<WorldSample> Peer::world(const WorldMessage& message, HostNs now) {
  if ((message.sequence <= world_sequence_ && world_sequence_ != 0) || message.answers < answers_) {
    ++counters_.reordered;
    return std::nullopt;
  }
  if (stamp_s_ && message.stamp_s && *message.stamp_s < *stamp_s_) {
    ++counters_.back_in_time;
    return std::nullopt;
  }
  const Sent* sent = find(message.answers);
  if (sent == nullptr) {
    ++counters_.unknown_ack;
    return std::nullopt;
  }
  if (world_sequence_ != 0) counters_.missing += message.sequence - world_sequence_ - 1;
  if (message.answers > answers_) {
    ++counters_.answered;
    take_round_trip(now - sent->sent_ns);
  }
  ++counters_.accepted;
  world_sequence_ = message.sequence;
  answers_ = message.answers;
  if (message.stamp_s) stamp_s_ = message.stamp_s;
  received_ns_ = now;
  return sample_of(message, sent->step_ns);
}

WorldSample Peer::sample_of(const WorldMessage& message, HostNs answered_ns) {
  WorldSample sample;
  sample.session = static_cast<std::uint32_t>(counters_.sessions);
  sample.answered_ns = answered_ns;
  sample.stop = message.stop;
  sample.step_height_m = message.step_height_m;
  sample.blocked = message.blocked;
  if (message.ground) {
    sample.has_ground = true;
    sample.height_m = message.ground->height_m;
    sample.roll_rad = message.ground->roll_rad;
    sample.pitch_rad = message.ground->pitch_rad;
    const std::string& surface = message.ground->surface;
    const auto found = std::find_if(settings_.surfaces.begin(), settings_.surfaces.end(),
                                    [&](const auto& known) { return known.first == surface; });
    if (found != settings_.surfaces.end()) {
      sample.slip_offset = found->second;
    } else if (!surface.empty()) {
      ++counters_.unknown_surface;
    }
  }
  if (message.pose && settings_.hello.authority == Authority::kWorld) {
    sample.has_pose = true;
    sample.pose = *message.pose;
  }
  return sample;
}

void Peer::take_round_trip(HostNs round_trip_ns) {
  const double round_trip_ms = ms(round_trip_ns);
  counters_.round_trip_ms = round_trip_ms;
  counters_.max_round_trip_ms = std::max(counters_.max_round_trip_ms, round_trip_ms);
  double& mean = counters_.mean_round_trip_ms;
  mean = counters_.answered == 1 ? round_trip_ms : mean + kSmoothing * (round_trip_ms - mean);
}

// Sent once: a world of another version would trigger it with every datagram.
void Peer::refuse(const std::string& text) {
  if (std::exchange(refused_, true)) return;
  note_ = "world: refused: " + text;
  reply_ = encode_error(text);
}

}  // namespace tp100::worlds
