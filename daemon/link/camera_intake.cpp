#include "link/camera_intake.h"

#include <algorithm>
#include <utility>

namespace tp100::link {
namespace {

// A sender without a useful datagram for this long has ended, or makes room for another.
constexpr HostNs kSilenceNs = kNsPerS;
// Stamps and offsets are inexact; a stamp further ahead than this is of another clock.
constexpr HostNs kAheadNs = 10 * kNsPerMs;

}  // namespace

CameraIntake::CameraIntake(std::string own_clock, HostNs max_age_ns)
    : own_clock_(std::move(own_clock)), max_age_ns_(max_age_ns) {}

/// False: another stream is active. A stream without a useful datagram for a while makes room, also
/// for its own restart.
template <class Message>
bool CameraIntake::follow(const Message& message, HostNs now) {
  const bool silent = counters_.streams == 0 || now - useful_ns_ >= kSilenceNs;
  const bool same = message.stream == stream_ && message.clock == clock_;
  if (!silent) return same;
  if (!same || counters_.streams == 0) {
    ++counters_.streams;
    stream_ = message.stream;
    clock_ = message.clock;
    offset_.reset();
  }
  sequence_.reset();
  useful_ns_ = now;
  return true;
}

template <class Message>
HostNs CameraIntake::host_time(const Message& message, HostNs now) {
  const HostNs stamp_ns = message.stamp_us * kNsPerUs;
  if (message.clock == own_clock_) return stamp_ns;
  offset_.add(stamp_ns + message.age_us * kNsPerUs, now);
  return stamp_ns + offset_.offset_ns();
}

template <class Message>
std::optional<HostNs> CameraIntake::admit(const std::optional<Message>& message, HostNs now) {
  ++counters_.received;
  if (!message) {
    ++counters_.malformed;
    return std::nullopt;
  }
  if (!follow(*message, now)) {
    ++counters_.foreign;
    return std::nullopt;
  }
  const HostNs measured_ns = host_time(*message, now);
  const bool follows = !sequence_ || (message->sequence > *sequence_ && measured_ns > measured_ns_);
  if (measured_ns > now + kAheadNs) {
    ++counters_.early;
    return std::nullopt;
  }
  if (!follows || now - measured_ns > max_age_ns_) {
    ++counters_.late;
    return std::nullopt;
  }
  if (sequence_) counters_.missing += message->sequence - *sequence_ - 1;
  sequence_ = message->sequence;
  measured_ns_ = measured_ns;
  useful_ns_ = now;
  return measured_ns;
}

std::optional<CameraSample> CameraIntake::receive(std::string_view datagram, HostNs now) {
  const std::optional<CameraMessage> message = decode_camera(datagram);
  const std::optional<HostNs> measured_ns = admit(message, now);
  if (!measured_ns) return std::nullopt;
  ++counters_.accepted;
  return CameraSample{.x_m = message->x_m,
                      .y_m = message->y_m,
                      .yaw_rad = message->yaw_rad,
                      .measured_ns = *measured_ns,
                      .sequence = message->sequence};
}

std::optional<CameraImage> CameraIntake::receive_image(std::string_view datagram,
                                                       HostNs interval_ns, HostNs now) {
  const std::optional<ImageMessage> message = decode_image(datagram);
  const std::optional<HostNs> taken_ns = admit(message, now);
  if (!taken_ns) return std::nullopt;
  if (*taken_ns < image_due_ns_) {
    ++counters_.dropped;
    return std::nullopt;
  }
  // An image that is late by less than an interval does not delay those that follow.
  image_due_ns_ = std::max(image_due_ns_, *taken_ns - interval_ns) + interval_ns;
  ++counters_.accepted;
  return CameraImage{*taken_ns, std::string(message->jpeg)};
}

}  // namespace tp100::link
