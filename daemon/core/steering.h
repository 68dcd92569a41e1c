#pragma once
// Which pose steers.

#include <cstdint>
#include <string_view>

namespace tp100 {

enum class Steering : std::uint8_t { kModel, kOdometry, kFused };

/// Name as in files and messages.
constexpr std::string_view to_string(Steering steering) {
  switch (steering) {
    case Steering::kModel:
      return "model";
    case Steering::kOdometry:
      return "odometry";
    case Steering::kFused:
      break;
  }
  return "fused";
}

}  // namespace tp100
