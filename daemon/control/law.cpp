#include "control/law.h"

#include "control/lqr.h"
#include "control/pure_pursuit.h"
#include "control/stanley.h"

namespace tp100::control {

std::unique_ptr<const Law> make_law(const Parameters& parameters, const BeltLimits& limits) {
  switch (parameters.law) {
    case LawName::kStanley:
      break;
    case LawName::kPurePursuit:
      return std::make_unique<PurePursuit>(parameters, limits);
    case LawName::kLqr:
      return std::make_unique<Lqr>(parameters, limits);
  }
  return std::make_unique<Stanley>(parameters);
}

}  // namespace tp100::control
