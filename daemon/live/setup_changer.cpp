#include "live/setup_changer.h"

#include <utility>
#include <vector>

#include "bridge/cycle.h"
#include "core/arithmetic.h"
#include "core/clock.h"
#include "core/enum_names.h"
#include "core/error.h"
#include "live/setup_list.h"
#include "text/format.h"
#include "text/json_writer.h"

namespace tp100::live {
namespace {

using course::Bundled;

// A stopped robot comes to rest, and its standstill is detected, in less time.
constexpr HostNs kChangeTimeoutNs = 3 * kNsPerS;

struct FieldList {
  template <class T>
  void field(const char* /*name*/, const T& value) {
    all.push_back(static_cast<double>(value));
  }
  std::vector<double> all{};
};

/// All fields, with nonce and token, which the session sets, at 0.
std::vector<double> fields(wire::Parameters parameters) {
  parameters.boot_nonce = parameters.token = 0;
  FieldList list;
  parameters.visit(list);
  return list.all;
}

wire::Parameters wire_parameters(const config::RunSetup& run) {
  return bridge::session_settings(run.parameters, run.course.get()).parameters;
}

std::string course_name(const config::LoadedRun& run) {
  return run.setup.course == nullptr ? "" : run.setup.course->name;
}

std::string pose_json(const Pose& pose) {
  return text::json_object([&](text::JsonWriter& json) {
    json.field("x_m", pose.x_m).field("y_m", pose.y_m).field("yaw_rad", pose.yaw_rad);
  });
}

}  // namespace

SetupChanger::SetupChanger(config::LoadedRun run, LiveCycle& cycle,
                           const messages::PublishClock& clock, bool ros2)
    : cycle_(cycle),
      clock_(clock),
      ros2_(ros2),
      files_(config::library_folder(run.setup.configuration.library), run.files),
      run_(std::make_shared<const config::LoadedRun>(std::move(run))) {}

std::shared_ptr<const config::LoadedRun> SetupChanger::run() const {
  const std::lock_guard lock(mutex_);
  return run_;
}

bool SetupChanger::changing() const {
  const std::lock_guard lock(mutex_);
  return answer_ != nullptr;
}

void SetupChanger::choose(const server::SetupChoice& choice, server::Answer answer) {
  ask({.choice = choice}, std::move(answer));
}

void SetupChanger::place(const std::optional<Pose>& at, server::Answer answer) {
  ask({.places = true, .at = at}, std::move(answer));
}

void SetupChanger::ask(Asked asked, server::Answer answer) {
  {
    const std::lock_guard lock(mutex_);
    if (answer_ == nullptr) answer_ = std::exchange(answer, {});
  }
  if (answer != nullptr) return answer("another change is under way; try again", "");
  const auto change = [this, asked = std::move(asked)] {
    std::unique_ptr<SetupRequest> request = make(asked);
    request->until_ns = monotonic_now() + kChangeTimeoutNs;
    const std::lock_guard lock(mutex_);
    request_ = std::move(request);
    cycle_.change_setup(*request_);
  };
  const bool posted = disk_.post(change, [this](const std::string& why) { end(why); });
  if (!posted) end(record::Worker::kBusy);
}

// The step is built here: in the loop nothing is allocated.
std::unique_ptr<SetupRequest> SetupChanger::make(const Asked& asked) {
  const std::shared_ptr<const config::LoadedRun> now = run();
  if (now->setup.parameters.world.kind != bridge::WorldKind::kInternal)
    throw UserError(
        "an external world is in use (world.kind) and keeps the robot's place: restart tp100d");
  auto request = std::make_unique<SetupRequest>();
  if (asked.places) {
    if (!asked.at && now->setup.course == nullptr)
      throw UserError("there is no course, and so no start; choose a course");
    const Pose at = asked.at ? *asked.at : now->setup.course->start;
    request->change.place = at;
    const std::lock_guard lock(mutex_);
    json_ = pose_json(at);
    next_ = {};
    next_.text =
        text::format("placed at (%.3f, %.3f) m, %.1f deg", at.x_m, at.y_m, at.yaw_rad * kDegPerRad);
    return request;
  }
  const auto file = [&](Bundled kind, const std::optional<std::string>& name,
                        const course::TextFile& present) {
    if (!name) return present;
    return name->empty() && kind == Bundled::kCourses ? course::TextFile{}
                                                      : files_.read(kind, *name);
  };
  const auto setup = asked.choice.setup ? value_in(bridge::kSetupNames, *asked.choice.setup)
                                        : std::optional(now->files.setup);
  if (!setup) throw UserError("setup is \"stand\", \"flat\" or \"terrain\"");
  const course::TextFile course =
      asked.choice.goal ? course::course_to(now->files.course, *asked.choice.goal)
                        : file(Bundled::kCourses, asked.choice.course, now->files.course);
  const auto next = std::make_shared<const config::LoadedRun>(config::with_files(
      *now, course, file(Bundled::kRobots, asked.choice.robot, now->files.robot), *setup));
  require_fit(next->setup);
  request->change.step.emplace(next->setup.parameters, next->setup.course);
  const wire::Parameters parameters = wire_parameters(next->setup);
  if (fields(parameters) != fields(wire_parameters(now->setup)))
    request->change.parameters = parameters;
  Made made{.run = next, .run_context = config::run_context_of(next->setup)};
  {
    const messages::Messages messages(made.run_context, clock_);
    const HostNs at = monotonic_now();
    made.for_viewers = messages::setup_messages(messages, at);
    if (ros2_) made.for_nodes = ros2::setup_messages(messages, at);
  }
  const std::string name = course_name(*next);
  made.text = (name.empty() ? "no course" : "course " + name) + ", robot " +
              next->setup.robot.name + ", set-up " + bridge::to_string(*setup);
  const std::lock_guard lock(mutex_);
  json_ = server::json_of(
      {{"course", name}, {"robot", next->setup.robot.name}, {"setup", bridge::to_string(*setup)}});
  next_ = std::move(made);
  return request;
}

std::optional<SetupChanger::Made> SetupChanger::take(const StepRecord& next) {
  const SetupRequest* done = cycle_.setup_done();
  if (done == nullptr || !done->made || next.step < done->step) return std::nullopt;
  const std::lock_guard lock(mutex_);
  if (next_.run != nullptr) run_ = next_.run;
  next_.step = done->step;
  return std::exchange(next_, {});
}

void SetupChanger::finish() { end({}); }

void SetupChanger::tick() {
  const SetupRequest* done = cycle_.setup_done();
  if (done != nullptr && !done->made)
    end("the robot did not stand still within 3 s, or a run began: nothing is changed");
}

// Frees the old step.
void SetupChanger::end(const std::string& why) {
  std::unique_ptr<SetupRequest> freed;
  server::Answer answer;
  std::string json;
  {
    const std::lock_guard lock(mutex_);
    cycle_.release_setup();
    freed = std::move(request_);
    answer = std::exchange(answer_, {});
    json = json_;
    next_ = {};
  }
  answer(why, json);
}

}  // namespace tp100::live
