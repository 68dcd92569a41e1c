#pragma once
// Answers clients' messages: subscriptions, parameters, services. Checks everything that could
// reach the robot. No socket; one thread; time is passed in.

#include <cstdint>
#include <map>
#include <memory>
#include <mutex>
#include <set>
#include <string>
#include <vector>

#include "server/broker.h"
#include "server/controls.h"
#include "server/protocol.h"
#include "server/publisher.h"
#include "server/service.h"

namespace tp100::server {

class RequestHandler {
 public:
  /// Publishes the parameters. `broker`, `publisher` and `controls` must outlive the handler.
  /// `services`: those of others, besides those of motion.
  RequestHandler(Broker& broker, Publisher& publisher, Controls& controls,
                 std::vector<messages::ParameterText> parameters, std::vector<ServiceRow> services,
                 std::string session_id, std::string name = {});

  /// Sends server info, channels and services, in this order.
  void send_server_info(Viewer& viewer, Permission permission);
  /// Answers one message, which was received at host time `now`. False: it is not a message of the
  /// protocol. STOP must have been carried out already.
  bool handle(const std::shared_ptr<Viewer>& viewer, const ClientMessage& message,
              Permission permission, HostNs now);
  /// STOP was pressed at host time `at` and is carried out already: publishes that, and answers
  /// when the robot has acknowledged it.
  void stop_pressed(const std::shared_ptr<Viewer>& viewer, std::uint32_t call, HostNs at);
  /// All rows, by their numbers.
  const std::vector<ServiceRow>& services() const { return services_; }
  /// Another course, robot or set-up is in force: these are its parameters. Those that viewers may
  /// set keep their values.
  void exchange(std::vector<messages::ParameterText> parameters, HostNs now);
  /// The viewer is gone: stops the robot that it drives.
  void leave(const Viewer& viewer, HostNs now);
  /// Call it regularly and after events: answers requests that waited for a STOP or for the disk,
  /// and publishes the steering pose in use if the step did not accept a change of it.
  void tick(HostNs now);

 private:
  struct Waiting {
    std::weak_ptr<Viewer> viewer;
    std::uint32_t call;
  };
  /// Answers to requests, possibly by another thread and when the handler is gone.
  struct Answers {
    struct One {
      std::weak_ptr<Viewer> viewer;
      std::string message;
      bool binary;
    };
    std::mutex mutex;
    std::vector<One> answers;
  };

  void on(const std::shared_ptr<Viewer>& viewer, const ServiceCall& call, Permission permission,
          HostNs now);
  Result<> begin(const ServiceCall& call, std::uint32_t viewer, Permission permission, HostNs now,
                 const Answer& answer) const;
  void stop_if_unwatched(HostNs now);
  void send_answers();
  std::vector<const messages::ParameterText*> select(const std::vector<std::string>& names) const;
  void set_parameters(Viewer& viewer, const SetParameters& wanted, Permission permission,
                      HostNs now);
  Result<const messages::ParameterText*> set_one(const NamedValue& one, Permission permission);
  void watch_parameters(const Viewer& viewer, const ParameterSubscription& wanted);
  void parameter_changed(const messages::ParameterText& parameter, HostNs now);
  void publish_parameters(HostNs now);
  void correct_steering(HostNs now);

  Broker& broker_;
  Publisher& publisher_;
  Controls& controls_;
  std::vector<messages::ParameterText> parameters_;
  HostNs overdue_ns_ = 0;  // a parameter change is under way until then
  std::map<std::uint32_t, std::set<std::string>> watched_;  // parameters, by viewer
  std::vector<ServiceRow> services_;
  std::string session_id_, name_;
  std::string advertised_services_;  // made when the first viewer comes
  std::vector<Waiting> waiting_;
  HostNs watched_ns_ = 0;  // when a page was in sight, or nothing was under way
  std::shared_ptr<Answers> answers_ = std::make_shared<Answers>();
};

}  // namespace tp100::server
