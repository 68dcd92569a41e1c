#pragma once
// What the ground does along the robot, as far as its pitch tells.

#include <cstdint>

namespace tp100 {

enum class Slope : std::uint8_t { kFlat, kUp, kDown };

}  // namespace tp100
