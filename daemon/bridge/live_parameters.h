#pragma once
// Changes of parameters while the step runs.

#include "bridge/parameters.h"
#include "core/parameter_change.h"

namespace tp100::bridge {

/// Carries out `change`. False, and nothing is changed, if its value cannot be: not finite,
/// negative, no pose of that number, or steering while `under_way`. Limits beyond that are the
/// business of whoever asks. No allocation; safe in the real-time thread.
bool apply(const ParameterChange& change, bool under_way, Parameters& parameters);

}  // namespace tp100::bridge
