#pragma once
// Whether, where and by how much the results (command_valid, request, snapshot) of two records of
// the same step differ. Pure.

#include <optional>
#include <string>

#include "core/step_record.h"

namespace tp100::record {

/// One result that differs from the recorded one.
struct StepDifference {
  std::string field;     ///< dotted name
  std::string recorded;  ///< as text; doubles with all digits
  std::string computed;
};

/// The first difference, bit by bit.
std::optional<StepDifference> first_difference(const StepRecord& recorded,
                                               const StepRecord& computed);

/// The largest differences over any number of steps; infinite where only one side has a
/// number.
struct LargestDifference {
  double length_m = 0.0;   ///< of all results in metres: positions, errors, progress
  double angle_rad = 0.0;  ///< of all in radians, around the circle
  double other = 0.0;      ///< of all other numbers; relative for values above 1
  bool decided = false;    ///< a truth value, an enumeration or an integer differs

  void add(const StepRecord& recorded, const StepRecord& computed);
  /// `decided` is false, and no number differs by more than `limit`.
  bool within(double limit) const;
};

}  // namespace tp100::record
