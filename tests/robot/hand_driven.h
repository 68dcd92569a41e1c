#pragma once
// An emulated robot driven by hand in virtual time: the daemon's cycle, controls and request
// handler without sockets and threads, and the robot at the other end of a cable.

#include <functional>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "config/run_setup.h"
#include "live/live_controls.h"
#include "live/live_cycle.h"
#include "live/live_recording.h"
#include "live/ros2_requests.h"
#include "live/setup_changer.h"
#include "messages/sink.h"
#include "ros2/message_types.h"
#include "selftest/self_test.h"
#include "server/request_handler.h"
#include "sim/robot/emulated_robot.h"
#include "sim/robot/options.h"

namespace tp100::sim {

struct HandDrivenSettings {
  Loaded loaded{};
  std::shared_ptr<const course::Course> course{};  ///< null: no course
  std::uint64_t seed = 1;
  messages::Sink* sink = nullptr;
};

class HandDriven {
 public:
  static constexpr HostNs kPeriodNs = 5 * kNsPerMs;

  explicit HandDriven(const HandDrivenSettings& settings)
      : files_(settings.loaded.files),
        run_(setup_of(settings)),
        cycle_(bridge::session_settings(run_.parameters, run_.course.get()), run_.parameters,
               run_.course, false),
        loop_({}, cycle_),
        recording_(files_, run_, {}),
        setup_({files_, run_}, cycle_),
        controls_(cycle_, loop_, recording_, setup_, runs_, self_test_),
        publisher_(broker_, messages::Messages(context(), {}), controls_),
        handler_(broker_, publisher_, controls_, {}, "session"),
        robot_({.values = settings.loaded.robot.emulated,
                .start = run_.course == nullptr ? Pose{} : run_.course->start,
                .on_stand = settings.loaded.setup == bridge::Setup::kStand,
                .terrain = run_.course == nullptr ? course::Terrain{} : run_.course->terrain,
                .seed = settings.seed}),
        sink_(settings.sink) {
    robot_.reset(PowerUp::kPowerOn);
    while (robot_.now_ns() < 20 * kNsPerMs) robot_.advance();
    robot_.opened();
    cycle_.opened(robot_.now_ns());
  }

  /// Called after each physics step, before each step of the daemon, and with its result.
  std::function<void()> after_physics;
  std::function<void(HostNs now)> before_step;
  std::function<void(const StepRecord& record)> after_step;

  live::LiveControls& controls() { return controls_; }
  EmulatedRobot& robot() { return robot_; }
  const StepRecord& record() const { return record_; }
  RunState state() const { return record_.snapshot.run_state; }
  HostNs now() const { return robot_.now_ns(); }
  /// By a person who sees the robot now.
  void request(OperatorRequest request) {
    if (request == OperatorRequest::kStop) return controls_.stop();
    cycle_.request(request, {.acted_ns = now(), .stops_seen = controls_.stop_count()});
  }

  void step() {
    for (const HostNs end = now() + kPeriodNs; now() < end;) {
      for (const TimedByte& byte : robot_.advance()) {
        arriving_.push_back(byte.value);
        if (byte.value != wire::kDelimiter) continue;
        cycle_.received(arriving_, byte.at_ns);
        arriving_.clear();
      }
      if (after_physics) after_physics();
    }
    if (before_step) before_step(now());
    cycle_.step(now());
    robot_.receive(cycle_.output(), now());
    cycle_.written(cycle_.output().size());
    cycle_.after_write(now());
    take_results();
  }
  template <class Condition>
  bool step_until(Condition condition, double within_s) {
    for (const HostNs end = now() + from_s(within_s); now() < end;) {
      step();
      if (condition()) return true;
    }
    return false;
  }
  void step_for(double duration_s) {
    step_until([] { return false; }, duration_s);
  }
  bool wait_until_ready() {
    return step_until([&] { return record_.snapshot.drive_refusal == StartRefusal::kNone; }, 10.0);
  }

  /// Viewer `id` calls a service; connects first if it is new. Returns the answer as JSON, a
  /// refusal as {"refused": text}.
  nlohmann::json call(std::uint32_t id, const std::string& service,
                      const nlohmann::json& request = nlohmann::json::object(),
                      server::Permission permission = server::Permission::kCommand) {
    static const std::vector<std::string> kServices = {"start",        "hold",         "stop",
                                                       "record_start", "record_stop",  "drive_take",
                                                       "drive",        "drive_release"};
    std::uint32_t number = 1;
    while (kServices.at(number - 1) != service) ++number;
    const std::shared_ptr<server::Viewer> viewer = viewer_of(id);
    nlohmann::json sent = request;
    if ((service == "start" || service == "drive_take") && !sent.contains("stops"))
      sent.update({{"stops", controls_.stop_count()}, {"t_s", to_s(now())}});
    handler_.handle(viewer, server::ServiceCall{number, 1, "json", sent.dump()}, permission, now());
    nlohmann::json answer;
    while (!viewer->outbox().empty()) {
      const server::WebSocketFrame frame = viewer->outbox().pop();
      if (frame.binary && frame.head_size == 0)
        answer = nlohmann::json::parse(frame.body->substr(frame.body->find('{')));
      else if (!frame.binary)
        answer = {{"refused", nlohmann::json::parse(*frame.body).value("message", "")}};
    }
    return answer;
  }
  /// The socket of viewer `id` is closed.
  void disconnect(std::uint32_t id) {
    const std::shared_ptr<server::Viewer> viewer = viewer_of(id);
    broker_.remove(viewer);
    handler_.leave(*viewer, now());
    viewers_.erase(id);
  }
  /// Viewer `id` takes the wheel and waits until the robot is armed. Returns the token or the
  /// refusal.
  std::string take(std::uint32_t id) {
    const nlohmann::json answer = call(id, "drive_take");
    if (!answer.contains("token")) return answer.value("refused", "");
    step_until([&] { return state() == RunState::kDriving; }, 1.0);
    return answer["token"];
  }
  /// Viewer `id` sends its input, which is `age_s` old.
  nlohmann::json drive(std::uint32_t id, const std::string& token, double speed_mps,
                       double yaw_rate_radps, double age_s = 0.0) {
    return call(id, "drive",
                {{"token", token},
                 {"speed_mps", speed_mps},
                 {"yaw_rate_radps", yaw_rate_radps},
                 {"input_ms", (to_s(now()) - age_s) * 1e3}});
  }
  /// Receives a message of a ROS 2 node, which its writer sent `age_s` ago.
  template <class Message>
  void receive(ros2::Input input, const Message& message, double age_s = 0.0,
               std::uint64_t writer = 1) {
    ros2_.take({.input = input,
                .writer = writer,
                .written_ns = kWriterClockNs + now() - from_s(age_s),
                .taken_ns = kWriterClockNs + now(),
                .cdr = ros2::serialized(message)},
               now());
  }
  /// Receives a velocity on /cmd_vel, as TwistStamped if `stamped`.
  void receive_velocity(double speed_mps, double yaw_rate_radps, double age_s = 0.0,
                        std::uint64_t writer = 1, bool stamped = false) {
    ros2::geometry_msgs::Twist twist{};
    twist.linear.x = speed_mps;
    twist.angular.z = yaw_rate_radps;
    if (!stamped) return receive(ros2::Input::kVelocity, twist, age_s, writer);
    const HostNs at_ns = kWriterClockNs + now() - from_s(age_s);
    receive(ros2::Input::kVelocityStamped,
            ros2::geometry_msgs::TwistStamped{
                .header = {.stamp = {.sec = static_cast<std::int32_t>(at_ns / kNsPerS),
                                     .nanosec = static_cast<std::uint32_t>(at_ns % kNsPerS)}},
                .twist = twist},
            0.0, writer);
  }
  void receive_drive(bool wanted) {
    receive(ros2::Input::kDrive, ros2::std_msgs::Bool{.data = wanted});
  }
  /// Reports that no writer is left on that topic.
  void writers_gone(ros2::Input input) { ros2_.take({.input = input, .gone = true}, now()); }
  /// ROS 2 takes the wheel and the robot is armed; returns the messages if that fails.
  std::string take_by_ros2() {
    receive_drive(false);
    take_messages();
    receive_drive(true);
    step_until([&] { return state() == RunState::kDriving; }, 1.0);
    return take_messages();
  }
  /// Messages about ROS 2's requests since the last call.
  std::string take_messages() {
    std::vector<messages::Event> words;
    ros2_.drain_events(words);
    std::string text;
    for (const messages::Event& word : words) text += word.text + "\n";
    return text;
  }
  /// The /state as a viewer sees it.
  const messages::StateFigures& shown() {
    publisher_.tick(now());
    return publisher_.state();
  }

 private:
  static config::RunSetup setup_of(const HandDrivenSettings& settings) {
    config::RunSetup run{.configuration = settings.loaded.configuration,
                         .robot = settings.loaded.robot,
                         .course = settings.course,
                         .parameters = config::bridge_parameters(settings.loaded.configuration,
                                                                 settings.loaded.robot)};
    run.parameters.setup = settings.loaded.setup;
    run.parameters.world.kind = bridge::WorldKind::kInternal;
    return run;
  }
  messages::RunContext context() const {
    messages::RunContext out;
    out.course = run_.course;
    return out;
  }
  std::shared_ptr<server::Viewer> viewer_of(std::uint32_t id) {
    std::shared_ptr<server::Viewer>& viewer = viewers_[id];
    if (viewer == nullptr) {
      viewer = std::make_shared<server::Viewer>(
          id, [] {}, [] {});
      broker_.add(viewer);
    }
    return viewer;
  }
  // Offset of the writer's own clock.
  static constexpr HostNs kWriterClockNs = 1'700'000'000 * kNsPerS;

  void take_results() {
    record_ = *cycle_.front_record();
    cycle_.release_record();
    live::LiveEvent event;
    while (cycle_.take_event(event)) {
    }
    live::LiveStatus status;
    cycle_.take_status(status);
    publisher_.take(record_);
    ros2_.observe(record_);
    handler_.tick(now());
    if (after_step) after_step(record_);
    if (sink_ != nullptr) sink_->take(record_);
  }

  config::RunFiles files_;
  config::RunSetup run_;
  live::LiveCycle cycle_;
  loop::FixedRateLoop loop_;  // not started: the test is the loop
  live::LiveRecording recording_;
  live::SetupChanger setup_;
  runs::RunArchive runs_{{}};
  selftest::SelfTest self_test_{run_.configuration, run_.robot};
  live::LiveControls controls_;
  live::Ros2Requests ros2_{controls_};
  server::Broker broker_{messages::channel_texts()};
  server::Publisher publisher_;
  server::RequestHandler handler_;
  EmulatedRobot robot_;
  messages::Sink* sink_;
  std::map<std::uint32_t, std::shared_ptr<server::Viewer>> viewers_;
  StepRecord record_{};
  std::vector<std::uint8_t> arriving_;
};

}  // namespace tp100::sim
