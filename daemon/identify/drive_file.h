#pragma once
// Recorded drives as CSV files, and what was measured of them by hand.

#include <string>
#include <string_view>
#include <vector>

#include "core/error.h"
#include "identify/drive.h"

namespace tp100::identify {

/// Reads `t_s,left_count,right_count,gyro_z_radps[,camera_x_m,camera_y_m,camera_yaw_rad]`. A row
/// holds a sample, a camera pose (at the time its picture was taken) or both; the cells of what it
/// does not hold are empty. The drive is called by the file's name,
/// less "-samples". Throws SetupError (file:line).
/// Pure.
Drive parse_drive(std::string_view text, const std::string& file);

/// The drive as parse_drive reads it back, bit for bit; camera columns only if it has poses.
std::string write_drive(const Drive& drive);

/// Reads `run[,distance_m][,ahead_m][,left_m][,turned_deg]`, one row per measured run; `run` counts
/// the drives from 1, an empty cell was not measured. Adds each row to its drive. Throws SetupError
/// (file:line). Pure.
void add_measured(std::string_view text, const std::string& file, std::vector<Drive>& drives);

/// What was measured of the drives as add_measured reads it back; empty if nothing was.
std::string write_measured(const std::vector<Drive>& drives);

}  // namespace tp100::identify
