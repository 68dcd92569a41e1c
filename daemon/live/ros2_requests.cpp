#include <algorithm>
#include <cmath>
#include <utility>

#include "core/arithmetic.h"
#include "live/ros2_node.h"
#include "text/format.h"

namespace tp100::live {
namespace {

constexpr const char* kTopic = "ROS 2 /cmd_vel";
// How far the estimate of a robot at standstill may move until it starts for its goal.
constexpr double kMaxMovedM = 0.01, kMaxTurnedRad = 2.0 * kRadPerDeg;

std::string name_of(ros2::Input input) {
  return ros2::inputs().at(static_cast<std::size_t>(input)).name;
}

messages::Event refusal(HostNs now, const std::string& text) {
  return {.at_ns = now,
          .kind = "client",
          .level = messages::Event::Level::kWarning,
          .text = "ROS 2: " + text};
}

/// Removes file:line:column: this text has no file.
std::string of_goal(const std::string& why) {
  const bool placed = why.starts_with(std::string(course::kGoalCourse) + ".toml:");
  return placed ? why.substr(why.find(": ") + 2) : why;
}

}  // namespace

void Ros2Requests::Shared::say(messages::Event event, bool answers) {
  if (answers) {
    const std::lock_guard lock(mutex);
    answer = event;
  }
  events.post(std::move(event));
}

std::optional<messages::Event> Ros2Requests::take_answer() {
  const std::lock_guard lock(shared_->mutex);
  return std::exchange(shared_->answer, std::nullopt);
}

void Ros2Requests::set_course(const std::string& name) {
  const std::lock_guard lock(shared_->mutex);
  shared_->course = name;
}

void Ros2Requests::say(HostNs now, const std::string& text) {
  shared_->say({.at_ns = now, .kind = "run", .text = text}, false);
}

void Ros2Requests::reply(HostNs now, const std::string& text) {
  shared_->say({.at_ns = now, .kind = "run", .text = text}, true);
}

void Ros2Requests::note(Note kind, HostNs now, const std::string& text) {
  if (now < quiet_until_ns_[kind]) return;
  quiet_until_ns_[kind] = now + (kind < kVelocityRefused ? kQuietNs : kRefusedQuietNs);
  shared_->say(refusal(now, text), true);
}

void Ros2Requests::refuse(ros2::Input input, HostNs now, const std::string& why) {
  // The kind of note for each input.
  constexpr std::array<Note, ros2::kInputCount> kNotes = {
      kVelocityRefused, kVelocityRefused, kDriveRefused, kPoseRefused,
      kGoalRefused,     kCourseRefused,   kMarkRefused,  kStopped};
  note(kNotes.at(static_cast<std::size_t>(input)), now, name_of(input) + " refused: " + why);
}

void Ros2Requests::observe(const StepRecord& record, HostNs now) {
  note_stops(now);
  drive_refusal_ = record.snapshot.drive_refusal;
  run_state_ = record.snapshot.run_state;
  at_ = record.snapshot.world;
  if (!start_) return;
  // A person's request or a STOP replaces the start.
  if (record.now_ns > start_->asked_ns && !record.inputs.requests.empty()) {
    refuse(start_->input, record.now_ns, "another request came meanwhile");
    return start_.reset();
  }
  advance(*start_, record.snapshot, record.now_ns);
}

// Noted late rather than early: then fewer messages count as written after a STOP was seen.
void Ros2Requests::note_stops(HostNs now) {
  for (const std::uint64_t stops = controls_.stop_count(); stops_ < stops; ++stops_)
    stop_times_.push_back(now);
  std::erase_if(stop_times_, [now](HostNs at) { return at < now - kSeenNs - Consent::kLifeNs; });
}

Consent Ros2Requests::consent_of(const ros2::Received& received, HostNs now) {
  note_stops(now);
  const HostNs age_ns = std::max<HostNs>(0, received.taken_ns - received.written_ns);
  const HostNs acted_ns = now - age_ns;
  const auto unseen =
      std::ranges::count_if(stop_times_, [&](HostNs at) { return at > acted_ns - kSeenNs; });
  return {.by = {Door::kRos2},
          .acted_ns = acted_ns,
          .seen_ns = now,
          .stops_seen = stops_ - static_cast<std::uint64_t>(unseen)};
}

Ros2Requests::Writer& Ros2Requests::writer_of(std::uint64_t id) {
  const auto at = std::ranges::find(drive_writers_, id, &Writer::id);
  Writer writer{.id = id};
  if (at != drive_writers_.end()) {
    writer = *at;
    drive_writers_.erase(at);
  } else if (drive_writers_.size() == kMaxWriters) {
    drive_writers_.erase(drive_writers_.begin());
  }
  return drive_writers_.emplace_back(writer);
}

void Ros2Requests::take(const ros2::Received& received, HostNs now) {
  using ros2::Input;
  if (received.input == Input::kVelocity || received.input == Input::kVelocityStamped)
    return velocity(received, now);
  if (received.gone) return;
  std::string why;
  switch (received.input) {
    case Input::kVelocity:
    case Input::kVelocityStamped:
      break;
    case Input::kDrive:
      if (const auto wanted = ros2::read_drive(received, why)) return drive(received, *wanted, now);
      break;
    case Input::kInitialPose:
      if (const auto at = ros2::read_pose(received, why)) return place(received, *at, now);
      break;
    case Input::kGoal:
      if (const auto to = ros2::read_pose(received, why))
        return start(received, {.goal = course::Goal{.from = at_, .to = *to}},
                     OperatorRequest::kContinue, now);
      break;
    case Input::kCourse:
      if (const auto course = ros2::read_course(received, why))
        return start(received, {.course = course->name}, course->request, now);
      break;
    case Input::kMark:
      if (const auto text = ros2::read_mark(received, why))
        return shared_->say({.at_ns = now, .kind = "mark", .text = *text}, false);
      break;
    case Input::kStop:
      // Whatever the message contains.
      return stop(now);
  }
  refuse(received.input, now, why);
}

// Only a node that said false before takes the lease and so arms: a stream of true must not arm
// again whenever a drive has ended, whatever other nodes say.
void Ros2Requests::drive(const ros2::Received& received, bool wanted, HostNs now) {
  Writer& writer = writer_of(received.writer);
  if (!wanted) {
    writer.said_false = true;
    if (!token_.empty() && controls_.drive_release(token_, now))
      reply(now, std::string(kTopic) + " releases the lease");
    token_.clear();
    return;
  }
  const bool said_false = std::exchange(writer.said_false, false);
  const std::string by = controls_.driver(now).by;
  if (!token_.empty() && by == kTopic) return;
  if (!said_false)
    return note(kRepeated, now,
                "/tp100/drive takes no lease: true counts only after this node's own false; send "
                "false, then true");
  std::string why;
  if (ros2::in_time(received, why) && by.empty()) why = to_string(drive_refusal_);
  writer_ = 0;
  token_.clear();
  if (!why.empty()) return refuse(ros2::Input::kDrive, now, why);
  const Result<std::string> token = controls_.drive_take(kTopic, consent_of(received, now), now);
  if (!token) return refuse(ros2::Input::kDrive, now, token.why());
  token_ = *token;
  reply(now, std::string(kTopic) + " takes the lease");
}

void Ros2Requests::velocity(const ros2::Received& received, HostNs now) {
  const bool drives = writer_ == received.writer && writer_input_ == received.input;
  if (received.gone) {
    if (token_.empty() || writer_ == 0 || writer_input_ != received.input) return;
    controls_.drive_lost(kTopic, now);
    token_.clear();
    return reply(now, std::string(kTopic) + " has no publisher any more");
  }
  if (token_.empty())
    return note(kNotTaken, now,
                "/cmd_vel does not drive; send true on /tp100/drive to take the lease");
  if (writer_ != 0 && !drives)
    return note(kOtherWriter, now, "/cmd_vel has a second writer, which is ignored");
  std::string why;
  const auto wanted = ros2::read_velocity(received, why);
  if (!wanted) return refuse(received.input, now, why);
  const HostNs age_ns = received.taken_ns - wanted->stamp_ns;
  if (age_ns < -kFreshInputNs || age_ns > ros2::kMaxAgeNs)
    return refuse(received.input, now,
                  "its time differs from this machine's by " + text::number_text(to_s(age_ns)) +
                      " s, so that its delay is unknown; synchronise both machines' clocks");
  if (age_ns > kFreshInputNs)
    note(kStale, now,
         "/cmd_vel is " + text::number_text(to_s(age_ns)) +
             " s old by this machine's clock, and beyond " +
             text::number_text(to_s(kFreshInputNs)) +
             " s it counts as zero; synchronise both machines' clocks, or shorten its way");
  writer_ = received.writer;
  writer_input_ = received.input;
  const Result<> driven = controls_.drive({.token = token_,
                                           .speed_mps = wanted->speed_mps,
                                           .yaw_rate_radps = wanted->yaw_rate_radps,
                                           .at_ns = now - age_ns},
                                          now);
  if (driven || controls_.driver(now).by == kTopic) return;
  token_.clear();
  reply(now, std::string(kTopic) + " no longer drives");
}

void Ros2Requests::place(const ros2::Received& received, const Pose& at, HostNs now) {
  std::string late;
  if (!ros2::in_time(received, late)) return refuse(received.input, now, late);
  if (under_way(run_state_)) return refuse(received.input, now, server::kUnderWay);
  controls_.place(at, [shared = shared_, now](const std::string& why, const std::string&) {
    if (!why.empty()) shared->say(refusal(now, "/initialpose refused: " + why), true);
  });
}

// As a person does on the page: chooses the course, and then starts.
void Ros2Requests::start(const ros2::Received& received, const server::SetupChoice& choice,
                         OperatorRequest request, HostNs now) {
  HostNs& silent_until_ns = silent_until_ns_.at(static_cast<std::size_t>(received.input));
  if (now < std::exchange(silent_until_ns, now + kSilenceNs))
    return note(kRepeated, now,
                name_of(received.input) + " is repeated and starts nothing; send it once");
  std::string why;
  if (start_) {
    why = name_of(start_->input) + " is about to start the robot";
  } else if (under_way(run_state_)) {
    why = server::kUnderWay;
  } else if (ros2::in_time(received, why)) {
    why = to_string(drive_refusal_);
  }
  if (!why.empty()) return refuse(received.input, now, why);
  const std::uint32_t number = ++choices_;
  start_ = {.number = number,
            .input = received.input,
            .choice = choice,
            .request = request,
            .consent = consent_of(received, now),
            .asked_ns = now};
  controls_.choose(choice,
                   [shared = shared_, number](const std::string& refused, const std::string&) {
                     const std::lock_guard lock(shared->mutex);
                     shared->choice = {number, refused};
                   });
}

void Ros2Requests::advance(Start& start, const Snapshot& snapshot, HostNs now) {
  std::string why;
  if (!start.chosen) {
    const std::lock_guard lock(shared_->mutex);
    start.chosen = shared_->choice.first == start.number;
    if (start.chosen) why = shared_->choice.second;
  }
  const bool in_time = now - start.consent.acted_ns <= Consent::kLifeNs;
  const bool ready = start.chosen && snapshot.start_refusal == StartRefusal::kNone;
  if (why.empty() && !ready && in_time) return;
  if (why.empty())
    why = start.chosen ? why_not(start, snapshot) : "its course took too long to load";
  // The course is its own choice, and every other request since has ended it.
  start.consent.seen_ns = now;
  if (why.empty()) why = controls_.move(start.request, start.consent, now).why();
  const ros2::Input input = std::exchange(start_, std::nullopt)->input;
  if (!why.empty()) return refuse(input, now, of_goal(why));
  reply(now, "ROS 2 " + name_of(input) + " starts the robot");
}

std::string Ros2Requests::why_not(const Start& start, const Snapshot& snapshot) const {
  const std::optional<course::Goal>& goal = start.choice.goal;
  {
    const std::lock_guard lock(shared_->mutex);
    if (shared_->course != (goal ? course::kGoalCourse : *start.choice.course))
      return "another course was chosen meanwhile";
  }
  if (goal && (magnitude(at_.x_m - goal->from.x_m, at_.y_m - goal->from.y_m) > kMaxMovedM ||
               std::abs(wrap_angle(at_.yaw_rad - goal->from.yaw_rad)) > kMaxTurnedRad))
    return "the robot has moved since; send it again";
  return std::string(to_string(snapshot.start_refusal));
}

void Ros2Requests::stop(HostNs now) {
  controls_.stop();
  note_stops(now);
  start_.reset();
  note(kStopped, now, "/tp100/stop: STOP");
  stop_pressed_();
}

}  // namespace tp100::live
