#pragma once
// A course the other way round.

#include "course/course.h"

namespace tp100::course {

/// The course seen in a mirror along its x axis: left is right, everything else is the same. Its
/// name gets "-mirrored". Pure.
Course mirrored(const Course& course);

}  // namespace tp100::course
