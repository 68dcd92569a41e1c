#pragma once
// The interval between samples in the estimators' tests.

#include "core/time.h"

namespace tp100::estimation {

inline constexpr HostNs kPeriod = 5 * kNsPerMs;
inline constexpr double kDt = 0.005;

}  // namespace tp100::estimation
