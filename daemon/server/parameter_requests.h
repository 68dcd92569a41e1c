#pragma once
// Answers clients' requests for parameters: reads, sets and watches them. No socket; one thread;
// time is passed in.

#include <cstdint>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "server/broker.h"
#include "server/controls.h"
#include "server/protocol.h"
#include "server/publisher.h"

namespace tp100::server {

class ParameterRequests {
 public:
  /// Publishes the parameters. `broker`, `publisher` and `controls` must outlive this.
  ParameterRequests(Broker& broker, Publisher& publisher, Controls& controls,
                    std::vector<messages::ParameterText> parameters);

  void get(Viewer& viewer, const GetParameters& wanted) const;
  /// `may_command`: false for a client from which only STOP is accepted.
  void set(Viewer& viewer, const SetParameters& wanted, bool may_command, HostNs now);
  void watch(Viewer& viewer, const ParameterSubscription& wanted);

  /// Another course, robot or set-up is in force: these are its parameters. Those that viewers may
  /// set keep their values.
  void change_setup(std::vector<messages::ParameterText> parameters, HostNs now);
  /// The viewer is gone.
  void leave(const Viewer& viewer) { watched_.erase(viewer.id()); }
  /// Call it regularly: publishes the steering pose in use if the step did not accept a change of
  /// it.
  void finish_overdue(HostNs now);

 private:
  bool under_way() const;
  void publish(HostNs now);
  Result<> set_one(const SetParameters::One& one);
  void parameter_changed(const messages::ParameterText& parameter, HostNs now);
  std::vector<const messages::ParameterText*> select(const std::vector<std::string>& names) const;

  Broker& broker_;
  Publisher& publisher_;
  Controls& controls_;
  std::vector<messages::ParameterText> parameters_;
  HostNs overdue_ns_ = 0;  // a parameter change is under way until then
  std::map<std::uint32_t, std::set<std::string>> watched_;  // parameters, by viewer
};

}  // namespace tp100::server
