#pragma once
// The daemon without sockets and threads of its own, in virtual time: cycle, controls, request
// handler, ROS 2's requests and terminal. Whoever holds the other end of the cable steps it.

#include <algorithm>
#include <functional>
#include <map>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "config/run_setup.h"
#include "live/live_controls.h"
#include "live/live_cycle.h"
#include "live/live_events.h"
#include "live/live_recording.h"
#include "live/ros2_node.h"
#include "live/setup_changer.h"
#include "live/terminal.h"
#include "ros2/message_types.h"
#include "selftest/self_test.h"
#include "server/request_handler.h"

namespace tp100::live {

class DaemonRig {
 public:
  DaemonRig(config::RunFiles files, config::RunSetup run, runs::ArchiveSettings runs = {})
      : files_(std::move(files)),
        run_(std::move(run)),
        cycle_(bridge::session_settings(run_.parameters, run_.course.get()), run_.parameters,
               run_.course, false),
        loop_({}, cycle_),
        active_(std::make_shared<const ActiveRun>(config::LoadedRun{files_, run_})),
        recording_(active_, {}, events_),
        setup_(active_, cycle_, disk_),
        runs_(std::move(runs), disk_),
        controls_(cycle_, loop_, recording_, setup_, runs_, self_test_, events_),
        publisher_(broker_, messages::Messages(first_context(), {}), controls_),
        handler_(broker_, publisher_, controls_, {}, controls_.services(), "session"),
        terminal_(nullptr, {controls_, [this](const std::string& line, bool) { said(line); },
                            [this] { publisher_.stop_pressed("keyboard", now()); },
                            [this] { return setup_.in_force()->course(); }}) {}
  virtual ~DaemonRig() = default;
  DaemonRig(const DaemonRig&) = delete;
  DaemonRig& operator=(const DaemonRig&) = delete;

  virtual HostNs now() const = 0;

  /// Called before each step of the daemon, and with its result.
  std::function<void(HostNs now)> before_step;
  std::function<void(const StepRecord& record)> after_step;

  LiveControls& controls() { return controls_; }
  const StepRecord& record() const { return record_; }
  RunState state() const { return record_.snapshot.run_state; }
  /// By a person who sees the robot now.
  void request(OperatorRequest request) {
    if (request == OperatorRequest::kStop) return controls_.stop();
    cycle_.request(request,
                   {.acted_ns = now(), .seen_ns = now(), .stops_seen = controls_.stop_count()});
  }

  /// Viewer `id` calls a service; connects first if it is new. What sets the robot in motion gets
  /// the consent of a person who sees the robot now, unless the request has one. Returns the answer
  /// as JSON, a refusal as {"refused": text}.
  nlohmann::json call(std::uint32_t id, const std::string& service,
                      const nlohmann::json& request = nlohmann::json::object(),
                      server::Permission permission = server::Permission::kCommand) {
    nlohmann::json sent = request;
    if (row_of(service).rules.consents && !sent.contains("stops"))
      sent.update({{"stops", controls_.stop_count()}, {"t_s", to_s(now())}});
    return send(id, service, sent.dump(), permission);
  }
  /// The same, with a text as the request.
  nlohmann::json send(std::uint32_t id, const std::string& service, const std::string& text,
                      server::Permission permission = server::Permission::kCommand) {
    // As the thread of the sockets does, before anybody else knows of it.
    if (service == "stop") controls_.stop();
    const std::shared_ptr<server::Viewer> viewer = viewer_of(id);
    const auto number = static_cast<std::uint32_t>(row_of(service).service);
    handler_.handle(viewer, server::ServiceCall{number, 1, "json", text}, permission, now());
    return answer_to(*viewer);
  }
  /// The answer to a request that had none yet.
  nlohmann::json late_answer(std::uint32_t id) {
    handler_.tick(now());
    return answer_to(*viewer_of(id));
  }
  /// The socket of viewer `id` is closed.
  void disconnect(std::uint32_t id) {
    const std::shared_ptr<server::Viewer> viewer = viewer_of(id);
    broker_.remove(viewer);
    handler_.leave(*viewer, now());
    viewers_.erase(id);
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
  /// Messages about ROS 2's requests since the last call.
  std::string take_messages() {
    std::string text;
    for (const auto& [event, log_only] : events_.drain()) text += event.text + "\n";
    return text;
  }

 protected:
  virtual void said(const std::string&) {}
  virtual void happened(const LiveEvent&) {}

  /// What the daemon and the server do after a step.
  void take_results() {
    record_ = *cycle_.front_record();
    if (const auto made = setup_.take(record_)) {
      if (made->exchange) {
        const std::shared_ptr<const ActiveRun>& run = made->exchange->run;
        ros2_.set_course(run->course());
        terminal_.ask(now());
        publisher_.exchange(run->context, made->exchange->for_viewers, now());
      }
      setup_.finish();
    }
    setup_.tick();
    cycle_.release_record();
    LiveEvent event;
    while (cycle_.take_event(event)) happened(event);
    LiveStatus status;
    cycle_.take_status(status);
    publisher_.take(record_);
    ros2_.observe(record_, now());
    handler_.tick(now());
    if (after_step) after_step(record_);
  }

  // Offset of a ROS 2 writer's own clock.
  static constexpr HostNs kWriterClockNs = 1'700'000'000 * kNsPerS;

  config::RunFiles files_;
  config::RunSetup run_;
  messages::EventQueue events_;
  LiveCycle cycle_;
  loop::FixedRateLoop loop_;                 // not started: the test is the loop
  std::shared_ptr<const ActiveRun> active_;  // at the start
  LiveRecording recording_;
  SetupChanger setup_;
  runs::RunArchive runs_;
  selftest::SelfTest self_test_{run_.configuration, run_.robot, disk_, events_};
  LiveControls controls_;
  Worker disk_{"disk"};  // its jobs use the above
  Ros2Requests ros2_{controls_, events_, [] {}};
  server::Broker broker_{messages::channel_texts()};
  server::Publisher publisher_;
  server::RequestHandler handler_;
  Terminal terminal_;

 private:
  static nlohmann::json answer_to(server::Viewer& viewer) {
    nlohmann::json answer;
    while (const auto next = viewer.outbox().pop()) {
      const server::WebSocketFrame& frame = *next;
      if (frame.binary && frame.head_size == 0)
        answer = nlohmann::json::parse(frame.body->substr(frame.body->find('{')));
      else if (!frame.binary)
        answer = {{"refused", nlohmann::json::parse(*frame.body).value("message", "")}};
    }
    return answer;
  }
  messages::RunContext first_context() const {
    messages::RunContext out;
    out.course = run_.course;
    return out;
  }
  const server::ServiceRow& row_of(const std::string& service) const {
    return *std::ranges::find(handler_.services(), service, &server::ServiceRow::name);
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

  std::map<std::uint32_t, std::shared_ptr<server::Viewer>> viewers_;
  StepRecord record_{};
};

}  // namespace tp100::live
