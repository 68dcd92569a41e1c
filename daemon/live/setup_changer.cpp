#include "live/setup_changer.h"

#include <utility>
#include <vector>

#include "bridge/cycle.h"
#include "core/arithmetic.h"
#include "core/clock.h"
#include "core/enum_names.h"
#include "core/error.h"
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

}  // namespace

SetupChanger::SetupChanger(std::shared_ptr<const ActiveRun> run, LiveCycle& cycle, Worker& disk,
                           const messages::PublishClock& clock, bool ros2)
    : cycle_(cycle),
      disk_(disk),
      clock_(clock),
      ros2_(ros2),
      files_(config::library_folder(run->loaded.setup.configuration.library), run->loaded.files),
      run_(std::move(run)) {}

std::shared_ptr<const ActiveRun> SetupChanger::in_force() const {
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

void SetupChanger::ask(Order order, server::Answer answer) {
  const bool needs_disk = !order.places;
  std::uint64_t number = 0;
  {
    const std::lock_guard lock(mutex_);
    if (answer_ == nullptr) {
      answer_ = std::exchange(answer, {});
      number = ++number_;
      waits_since_ns_ = needs_disk ? monotonic_now() : 0;
    }
  }
  if (answer != nullptr) return answer("another change is under way; try again", "");
  const auto change = [this, number, order = std::move(order)] {
    {
      const std::lock_guard lock(mutex_);
      if (number != number_) return;  // given up
      waits_since_ns_ = 0;
    }
    std::unique_ptr<SetupRequest> request = make(order);
    request->until_ns = monotonic_now() + kChangeTimeoutNs;
    const std::lock_guard lock(mutex_);
    request_ = std::move(request);
    cycle_.offer_setup(*request_);
  };
  const auto failed = [this](const std::string& why) { end(why); };
  if (!needs_disk) return Worker::run_here(change, failed);
  if (!disk_.post(change, failed)) end(Worker::kBusy);
}

// The step is built here: in the loop nothing is allocated.
std::unique_ptr<SetupRequest> SetupChanger::make(const Order& order) {
  const std::shared_ptr<const ActiveRun> active = in_force();
  const config::LoadedRun& now = active->loaded;
  if (now.setup.parameters.world.kind != bridge::WorldKind::kInternal)
    throw UserError(
        "an external world is in use (world.kind) and keeps the robot's place: restart tp100d");
  auto request = std::make_unique<SetupRequest>();
  if (order.places) {
    if (!order.at && now.setup.course == nullptr)
      throw UserError("there is no course, and so no start; choose a course");
    const Pose at = order.at ? *order.at : now.setup.course->start;
    request->change.place = at;
    const std::lock_guard lock(mutex_);
    json_ = text::json_object([&](text::JsonWriter& json) { json.floor_pose(at); });
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
  const auto setup = order.choice.setup ? value_in(bridge::kSetupNames, *order.choice.setup)
                                        : std::optional(now.files.setup);
  if (!setup) throw UserError("setup is \"stand\", \"flat\" or \"terrain\"");
  const course::TextFile course =
      order.choice.goal ? course::course_to(now.files.course, *order.choice.goal)
                        : file(Bundled::kCourses, order.choice.course, now.files.course);
  const auto next = std::make_shared<const ActiveRun>(config::with_files(
      now, course, file(Bundled::kRobots, order.choice.robot, now.files.robot), *setup));
  const config::RunSetup& chosen = next->loaded.setup;
  config::require_fit(chosen);
  request->change.step.emplace(chosen.parameters, chosen.course);
  const wire::Parameters parameters = wire_parameters(chosen);
  if (fields(parameters) != fields(wire_parameters(now.setup)))
    request->change.parameters = parameters;
  const messages::Messages messages(next->context, clock_);
  const HostNs at = monotonic_now();
  Exchange exchange{.run = next, .for_viewers = messages::setup_messages(messages, at)};
  if (ros2_)
    exchange.for_nodes =
        std::make_shared<const ros2::SetupMessages>(ros2::setup_messages(messages, at));
  const std::string name = next->course();
  const std::lock_guard lock(mutex_);
  json_ = server::json_of(
      {{"course", name}, {"robot", chosen.robot.name}, {"setup", bridge::to_string(*setup)}});
  next_ = {std::move(exchange), (name.empty() ? "no course" : "course " + name) + ", robot " +
                                    chosen.robot.name + ", set-up " + bridge::to_string(*setup)};
  return request;
}

std::optional<SetupChanger::MadeChange> SetupChanger::take(const StepRecord& next) {
  const SetupRequest* done = cycle_.setup_done();
  if (done == nullptr || !done->made || next.step < done->step) return std::nullopt;
  const std::lock_guard lock(mutex_);
  if (next_.exchange) {
    next_.exchange->first_step = done->step;
    next_.exchange->at_ns = monotonic_now();
    run_ = next_.exchange->run;
  }
  return std::exchange(next_, {});
}

void SetupChanger::finish() { end({}); }

void SetupChanger::tick() {
  bool waited = false;
  {
    const std::lock_guard lock(mutex_);
    waited = waits_since_ns_ != 0 && monotonic_now() - waits_since_ns_ > kChangeTimeoutNs;
    if (waited) ++number_;  // its job does nothing any more
  }
  if (waited) return end(Worker::kBusy);
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
    waits_since_ns_ = 0;
  }
  answer(why, json);
}

}  // namespace tp100::live
