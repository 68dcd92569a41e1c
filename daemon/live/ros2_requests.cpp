#include "live/ros2_requests.h"

#include <algorithm>
#include <iterator>
#include <utility>

namespace tp100::live {
namespace {

constexpr const char* kTopic = "ROS 2 /cmd_vel";
constexpr std::size_t kMostWords = 64;

server::Driver driver() { return {.id = kTopic, .name = kTopic}; }

}  // namespace

void Ros2Requests::Words::add(messages::Event event) {
  const std::lock_guard lock(mutex);
  if (all.size() < kMostWords) all.push_back(std::move(event));
}

void Ros2Requests::take_words(std::vector<messages::Event>& words) {
  const std::lock_guard lock(words_->mutex);
  std::ranges::move(std::exchange(words_->all, {}), std::back_inserter(words));
}

void Ros2Requests::say(HostNs now, const std::string& text) {
  words_->add({.at_ns = now, .kind = "run", .text = text});
}

void Ros2Requests::note(Note kind, HostNs now, const std::string& text) {
  if (now < quiet_until_ns_[kind]) return;
  quiet_until_ns_[kind] = now + (kind < kVelocityRefused ? kQuietNs : kRefusedQuietNs);
  words_->add({.at_ns = now,
               .kind = "client",
               .level = messages::Event::Level::kWarning,
               .text = "ROS 2: " + text});
}

void Ros2Requests::observe(const StepRecord& record) {
  drive_refusal_ = record.snapshot.drive_refusal;
  run_state_ = record.snapshot.run_state;
}

void Ros2Requests::take(const ros2::Received& received, HostNs now) {
  std::string why;
  switch (received.input) {
    case ros2::Input::kVelocity:
    case ros2::Input::kVelocityStamped:
      velocity(received, now);
      return;
    case ros2::Input::kDrive:
      if (received.gone) return;
      if (const auto wanted = ros2::read_drive(received, why)) return drive(*wanted, now);
      break;
    case ros2::Input::kInitialPose:
      if (received.gone) return;
      if (const auto at = ros2::read_pose(received, why)) return place(*at, now);
      break;
  }
  note(received.input == ros2::Input::kDrive ? kDriveRefused : kPoseRefused, now,
       std::string(ros2::inputs().at(static_cast<std::size_t>(received.input)).name) +
           " refused: " + why);
}

// Only a change to true takes the wheel and so arms: a stream of it must not arm again whenever a
// drive has ended.
void Ros2Requests::drive(bool wanted, HostNs now) {
  const bool before = std::exchange(drive_wanted_, wanted);
  if (!wanted) {
    if (!token_.empty() && controls_.drive_release(token_, now).empty())
      say(now, std::string(kTopic) + " releases the wheel");
    token_.clear();
    return;
  }
  const std::string by = controls_.driver(now).by;
  if (!token_.empty() && by == driver().name) return;
  if (before)
    return note(kRepeated, now,
                "/tp100/drive is still true and takes no wheel again; send false, then true");
  std::string why;
  if (by.empty()) why = to_string(drive_refusal_);
  writer_ = 0;
  token_.clear();
  if (why.empty()) why = controls_.drive_take(driver(), now, token_);
  if (!why.empty()) return note(kDriveRefused, now, "/tp100/drive refused: " + why);
  say(now, std::string(kTopic) + " takes the wheel");
}

void Ros2Requests::velocity(const ros2::Received& received, HostNs now) {
  const bool drives = writer_ == received.writer && writer_input_ == received.input;
  if (received.gone) {
    if (token_.empty() || writer_ == 0 || writer_input_ != received.input) return;
    controls_.drive_lost(driver().id, now);
    token_.clear();
    return say(now, std::string(kTopic) + " is gone");
  }
  if (token_.empty())
    return note(kNotTaken, now,
                "/cmd_vel does not drive; send true on /tp100/drive to take the wheel");
  if (writer_ != 0 && !drives)
    return note(kOtherWriter, now, "/cmd_vel has a second writer, which is ignored");
  std::string why;
  const auto wanted = ros2::read_velocity(received, why);
  if (!wanted) return note(kVelocityRefused, now, "/cmd_vel refused: " + why);
  writer_ = received.writer;
  writer_input_ = received.input;
  why = controls_.drive({.token = token_,
                         .speed_mps = wanted->speed_mps,
                         .yaw_rate_radps = wanted->yaw_rate_radps,
                         .input_ms = static_cast<double>(wanted->stamp_ns) * 1e-6},
                        now);
  if (why.empty() || controls_.driver(now).by == driver().name) return;
  token_.clear();
  say(now, std::string(kTopic) + " drives no more");
}

void Ros2Requests::place(const Pose& at, HostNs now) {
  if (under_way(run_state_))
    return note(kPoseRefused, now,
                "/initialpose refused: a run is under way, or somebody drives by hand; stop it "
                "first");
  controls_.place(at, [words = words_, now](const std::string& why, const std::string&) {
    if (why.empty()) return;
    words->add({.at_ns = now,
                .kind = "client",
                .level = messages::Event::Level::kWarning,
                .text = "ROS 2: /initialpose refused: " + why});
  });
}

}  // namespace tp100::live
