#include "server/controls.h"

#include <cmath>

#include "core/start_rule.h"

namespace tp100::server {
namespace {

constexpr double kMaxPlaceM = 100.0, kMaxYawRad = 100.0;
// Faster than any robot; the step limits it to what this one can do.
constexpr double kMaxVelocity = 100.0;
constexpr double kMaxInputMs = 1e15;

using Text = Result<std::string>;

bool within(const std::optional<double>& number, double most) {
  return number && std::abs(*number) <= most;
}

/// What requests of motion do.
struct Motion {
  Controls& controls;
  std::function<void(const messages::Event&)> tell;

  void say(const Request& request, const char* does) const {
    tell({.at_ns = request.now, .kind = "run", .text = request.by + does});
  }

  Text start(const Request& request) const {
    const auto what = start_request(request.arguments.text("from").value_or(""));
    if (!what)
      return Refusal{
          "from must be \"start\" (the robot stands at the course's start) or \"here\" (continue "
          "from the pose that is shown); it may be left out where both are the same"};
    if (!request.state.can_start) return Refusal{request.state.why_not_start};
    return accepted(controls.move(*what, request.consent, request.now));
  }

  Text pause(const Request& request) const {
    if (request.state.run != RunState::kRunning) return Refusal{"no run is under way"};
    const Result<> paused = controls.pause();
    if (paused && request.state.pause_left_s == 0.0) say(request, " pauses the run");
    return accepted(paused);
  }

  Text resume(const Request& request) const {
    if (request.state.run != RunState::kRunning || request.state.pause_left_s == 0.0)
      return Refusal{"the run is not paused"};
    const Result<> resumed = controls.move(OperatorRequest::kResume, request.consent, request.now);
    if (resumed) say(request, " resumes the run");
    return accepted(resumed);
  }

  Text take_lease(const Request& request) const {
    // A driver who asks again gets a new token.
    const std::string& why = request.state.why_not_drive;
    if (!why.empty() && controls.driver(request.now).by.empty()) return Refusal{why};
    Text token = controls.drive_take(request.by, request.consent, request.now);
    if (!token) return token;
    say(request, " takes the lease");
    return json_of({{"token", *token}});
  }

  Text drive(const Request& request) const {
    const Arguments& given = request.arguments;
    const auto token = given.text("token");
    const auto speed_mps = given.number("speed_mps"), rate_radps = given.number("yaw_rate_radps"),
               input_ms = given.number("input_ms");
    if (!token || !speed_mps || !rate_radps || !input_ms)
      return Refusal{"token, speed_mps, yaw_rate_radps and input_ms are needed"};
    if (!within(speed_mps, kMaxVelocity) || !within(rate_radps, kMaxVelocity) ||
        !within(input_ms, kMaxInputMs))
      return Refusal{"speed_mps and yaw_rate_radps range from -100 to 100, input_ms to 1e15"};
    return accepted(controls.drive({*token, *speed_mps, *rate_radps, *input_ms}, request.now));
  }

  Text release_lease(const Request& request) const {
    const auto token = request.arguments.text("token");
    if (!token) return Refusal{"token must be a string"};
    return accepted(controls.drive_release(*token, request.now));
  }

  Result<> choose(const Request& request, const Answer& answer) const {
    const Arguments& given = request.arguments;
    if (given.empty()) return Refusal{"give a course, robot or setup"};
    controls.choose({given.text("course"), given.text("robot"), given.text("setup")}, answer);
    return Done{};
  }

  Result<> place(const Request& request, const Answer& answer) const {
    const Arguments& given = request.arguments;
    const auto x_m = given.number("x_m"), y_m = given.number("y_m"),
               yaw_rad = given.number("yaw_rad");
    const bool start = given.text("at") == "start";
    const bool somewhere =
        within(x_m, kMaxPlaceM) && within(y_m, kMaxPlaceM) && within(yaw_rad, kMaxYawRad);
    if (given.fields().size() != (start ? 1U : 3U) || (!start && !somewhere))
      return Refusal{"give x_m, y_m and yaw_rad, each from -100 to 100, or {\"at\":\"start\"}"};
    std::optional<Pose> at;
    if (somewhere) at = {.x_m = *x_m, .y_m = *y_m, .yaw_rad = *yaw_rad};
    controls.place(at, answer);
    return Done{};
  }
};

constexpr const char* kToken = R"({"token":""})";

}  // namespace

std::vector<ServiceRow> motion_services(Controls& controls,
                                        const std::function<void(const messages::Event&)>& tell) {
  const auto does = [motion = Motion{controls, tell}](auto what) {
    return std::bind_front(what, motion);
  };
  const auto hold = [&controls](const Request&) { return accepted(controls.hold()); };
  constexpr const char* kDrive =
      R"({"token":"","speed_mps":0.1,"yaw_rate_radps":0.1,"input_ms":1.5})";
  constexpr const char* kChoice = R"({"course":"","robot":"","setup":""})";
  constexpr const char* kPlace = R"({"at":"","x_m":1.5,"y_m":1.5,"yaw_rad":1.5})";
  constexpr const char* kPose = R"({"x_m":1.5,"y_m":1.5,"yaw_rad":1.5})";
  constexpr ServiceRow::Rules kConsent{.consents = true}, kRest{.at_rest = true};
  return {
      {Service::kStart, "start", R"({"from":""})", kAccepted, does(&Motion::start), kConsent},
      {Service::kHold, "hold", "{}", kAccepted, hold},
      {Service::kPause, "pause", "{}", kAccepted, does(&Motion::pause)},
      {Service::kResume, "resume", "{}", kAccepted, does(&Motion::resume), kConsent},
      {Service::kDriveTake, "drive_take", "{}", kToken, does(&Motion::take_lease), kConsent},
      {Service::kDrive, "drive", kDrive, kAccepted, does(&Motion::drive)},
      {Service::kDriveRelease, "drive_release", kToken, kAccepted, does(&Motion::release_lease)},
      {Service::kChoose, "choose", kChoice, kChoice, does(&Motion::choose), kRest},
      {Service::kPlace, "place", kPlace, kPose, does(&Motion::place), kRest},
  };
}

}  // namespace tp100::server
