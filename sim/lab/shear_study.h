#pragma once
// The body with the other contact law (sim/body/shear_body.h): what the model is worth on a robot
// whose physics shares nothing with the one that it was developed on.

#include <cstdint>
#include <string>
#include <vector>

#include "sim/lab/study.h"

namespace tp100::sim {

/// Every bundled robot on the body `shear`, and three on softer ground: each is identified there on
/// its own identification drives first (its file, `<robot>-shear.toml`, goes to `folder`), then
/// driven on other courses, on level floor. The largest model error of a run is judged in parts of
/// the path's length: by its median over all runs, and by the worst run. The last two studies hold
/// both figures, over all robots with their limits, over the soft ones without.
std::vector<CourseStudy> study_shear(const std::string& folder, std::uint64_t first_seed, int runs);

}  // namespace tp100::sim
