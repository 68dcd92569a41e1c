#pragma once
// Courses that are not bundled, drawn by a number: nobody tuned anything on them.

#include <cstdint>
#include <string_view>

#include "course/course.h"

namespace tp100::sim {

/// A course of the same kind as the bundled one of that name (1-straight, 1-curve, 1-sharp, 2, 3),
/// its lengths, radii, angles, shoves and obstacles drawn by `seed`:
/// lines 0.3-1.8 m, arcs of 0.28-0.5 m radius and 60-200 deg, turns on the spot of 45-135 deg,
/// shoves of 2-4 cm and 5-15 deg, ramps of 12-28 deg and 40-80 mm, blocks of 15-37 mm. Throws
/// SetupError for another name.
course::Course held_out_course(std::string_view kind, std::uint64_t seed);

}  // namespace tp100::sim
