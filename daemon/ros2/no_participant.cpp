#include "core/error.h"
#include "ros2/participant.h"

namespace tp100::ros2 {

std::unique_ptr<messages::Sink> join_domain(const config::Ros2Settings&,
                                            const messages::RunContext&,
                                            const messages::PublishClock&) {
  throw SetupError(
      "ros2.enabled: this tp100d was built without Cyclone DDS; install cyclonedds-dev and build "
      "it again, or set it to false");
}

}  // namespace tp100::ros2
