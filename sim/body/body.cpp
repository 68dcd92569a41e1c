#include "sim/body/body.h"

#include "sim/body/ode_body.h"
#include "sim/body/shear_body.h"
#include "sim/body/uneven_floor.h"

namespace tp100::sim {

std::unique_ptr<Body> make_body(const course::Emulated& values, const Pose& start, bool on_stand,
                                const course::Terrain& terrain, std::uint64_t seed) {
  const UnevenFloor floor(values, seed);
  if (values.contact_law == course::ContactLaw::kShear)
    return std::make_unique<ShearBody>(values, start, on_stand, terrain, floor);
  return std::make_unique<OdeBody>(values.body, start, on_stand, terrain, floor);
}

}  // namespace tp100::sim
