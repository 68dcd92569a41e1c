#include "sim/body/body.h"

#include "sim/body/ode_body.h"
#include "sim/body/shear_body.h"

namespace tp100::sim {

std::unique_ptr<Body> make_body(const course::Emulated& values, const Pose& start, bool on_stand,
                                const course::Terrain& terrain) {
  if (values.contact_law == course::ContactLaw::kShear)
    return std::make_unique<ShearBody>(values, start, on_stand, terrain);
  return std::make_unique<OdeBody>(values.body, start, on_stand, terrain);
}

}  // namespace tp100::sim
