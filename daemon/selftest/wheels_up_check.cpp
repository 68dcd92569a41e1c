#include "selftest/wheels_up_check.h"

#include <algorithm>
#include <chrono>
#include <utility>

#include "bridge/cycle.h"
#include "core/clock.h"
#include "core/error.h"
#include "doctor/robot.h"
#include "loop/real_time.h"
#include "text/json_writer.h"

namespace tp100::selftest {
namespace {

constexpr auto kHandoverLimit = std::chrono::seconds(2);

/// The worst finding, in one line.
std::string end_of(const doctor::Findings& findings) {
  for (const doctor::Finding& finding : findings)
    if (finding.severity == doctor::Severity::kError) return finding.name + ": " + finding.seen;
  return "no problem found";
}

}  // namespace

WheelsUpCheck::WheelsUpCheck(config::Configuration configuration, const course::Robot& robot,
                             messages::EventQueue& events)
    : configuration_(std::move(configuration)), events_(events), robot_(robot) {}

void WheelsUpCheck::choose(const course::Robot& robot) {
  const std::lock_guard lock(mutex_);
  robot_ = robot;
}

Result<std::string> WheelsUpCheck::begin(const std::string& viewer, HostNs now) {
  const std::lock_guard lock(mutex_);
  if (on_.exchange(true)) return Refusal{kTracksRun};
  stop_ = false;
  lease_.clear();
  const std::string token = lease_.take(viewer, now).value_or("");
  input_ns_ = now;
  step_ = "the check takes over the port";
  question_.reset();
  result_.clear();
  lost_.clear();
  handover_.ask();
  const auto run = [this, robot = robot_] {
    std::string port;
    const doctor::Findings findings = examine(robot, port);
    finish(findings, port);
  };
  const auto failed = [this](const std::string& why) {
    finish(doctor::wheels_up_broken_off(why, "run it again"), {});
  };
  if (check_.post(run, failed)) return token;
  handover_.end();
  on_ = false;
  return Refusal{"too many requests wait; try again"};
}

Result<std::string> WheelsUpCheck::watch(const server::Request& request) {
  const server::Arguments& given = request.arguments;
  const auto token = given.text("token");
  const auto input_ms = given.number("input_ms");
  if (!token || !input_ms) return Refusal{"token and input_ms are needed"};
  const std::lock_guard lock(mutex_);
  std::string why;
  const auto input = lease_.drive({.token = *token, .input_ms = *input_ms}, request.now, why);
  if (!input && why.empty()) return Refusal{"no check has this token; begin another check"};
  if (!input) {
    lose_viewer(why);
    return Refusal{why};
  }
  input_ns_ = input->at_ns;
  const auto answer = given.text("answer");
  if (answer && question_ && given.number("question") == question_number_) {
    if (std::ranges::find(question_->choices, *answer, &doctor::Choice::answer) ==
        question_->choices.end())
      return Refusal{"the question does not offer this answer"};
    answer_ = answer;
    question_.reset();
  }
  return text::json_object([&](text::JsonWriter& json) {
    json.field("step", step_);
    if (question_)
      json.object("question", [&] {
        json.field("number", question_number_).field("text", question_->text);
        json.objects("choices", question_->choices, [&](const doctor::Choice& choice) {
          json.field("answer", choice.answer).field("meaning", choice.meaning);
        });
      });
    if (!result_.empty()) json.key("result").raw(result_);
  });
}

void WheelsUpCheck::lose(const std::string& viewer) {
  const std::lock_guard lock(mutex_);
  if (on() && lease_.lose(viewer)) lose_viewer("its viewer has disconnected");
}

void WheelsUpCheck::lose_viewer(const std::string& why) {
  lost_ = why;
  stop();
}

void WheelsUpCheck::say(const std::string& line) {
  const std::lock_guard lock(mutex_);
  step_ = line;
}

void WheelsUpCheck::ask(const doctor::Question& question) {
  const std::lock_guard lock(mutex_);
  question_ = question;
  ++question_number_;
  answer_.reset();
}

std::optional<std::string> WheelsUpCheck::take_answer() {
  const std::lock_guard lock(mutex_);
  return std::exchange(answer_, {});
}

bool WheelsUpCheck::watches() const { return monotonic_now() - input_ns_ <= kFreshInputNs; }

doctor::Findings WheelsUpCheck::examine(const course::Robot& robot, std::string& port) {
  const std::optional<std::string> path = handover_.wait(kHandoverLimit);
  if (!path)
    return doctor::wheels_up_broken_off("the robot is not connected, or not at rest",
                                        "connect or stop it, then run the check again");
  port = *path;
  doctor::WheelsUpOptions options;
  options.port = port;
  options.serial = {configuration_.link.baud, configuration_.link.hang_up};
  options.session =
      bridge::session_settings(config::bridge_parameters(configuration_, robot), nullptr);
  options.session.baud = static_cast<std::uint32_t>(configuration_.link.baud);
  options.drive = robot.drive;
  // Driven tracks need a command every 200 ms, however busy the machine is.
  loop::apply_to_this_thread({configuration_.loop.priority, configuration_.loop.cpu});
  try {
    return doctor::try_wheels_up(options, *this, stop_);
  } catch (const UserError& error) {
    return doctor::robot_findings({.port = port, .open_error = error.what()});
  }
}

void WheelsUpCheck::finish(const doctor::Findings& findings, const std::string& port) {
  handover_.end();
  const std::lock_guard lock(mutex_);
  step_ = "the check has ended, and the daemon has its port again";
  question_.reset();
  result_ = doctor::json(findings, port);
  on_ = false;
  // Last: whoever hears of the end may begin another check.
  events_.post(
      {.at_ns = monotonic_now(),
       .kind = "doctor",
       .text = "the check of the tracks has ended: " + (lost_.empty() ? end_of(findings) : lost_)});
}

}  // namespace tp100::selftest
