#pragma once
// Keys of the section [emulated] of a robot file and its subsections: names, ranges, meanings.

#include <span>

#include "course/robot_file.h"
#include "text/key.h"

namespace tp100::course {

std::span<const text::Key<EmulatedBody>> body_keys();
std::span<const text::Key<EmulatedVariation>> variation_keys();
std::span<const text::Key<EmulatedShear>> shear_keys();
std::span<const text::Key<EmulatedMotor>> motor_keys();
std::span<const text::Key<EmulatedEncoder>> encoder_keys();
std::span<const text::Key<EmulatedImu>> imu_keys();
std::span<const text::Key<EmulatedBattery>> battery_keys();
std::span<const text::Key<Emulated>> emulated_keys();

}  // namespace tp100::course
