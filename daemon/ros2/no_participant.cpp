#include "core/error.h"
#include "ros2/participant.h"

namespace tp100::ros2 {

struct Participant::State {};

Participant::Participant(const config::Ros2Settings&, const std::string&, std::span<const Topic>,
                         std::span<const Input>) {
  throw UserError(
      "ROS 2's topics: this program was built without Cyclone DDS; scripts/build installs it and "
      "builds with it; or leave out ros2.enabled and --ros2");
}
Participant::~Participant() = default;
void Participant::write(Topic, Bytes) {}  // NOLINT(performance-unnecessary-value-param)
void Participant::take(const std::function<void(const Received&)>&) {}

}  // namespace tp100::ros2
