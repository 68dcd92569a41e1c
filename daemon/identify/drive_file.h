#pragma once
// Drives for identify: from CSV files, with hand measurements of them, from recordings, and from
// the steps of a run.

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/error.h"
#include "identify/drive.h"
#include "messages/sink.h"
#include "record/recording.h"

namespace tp100::identify {

/// Reads `t_s,left_count,right_count,gyro_z_radps[,camera_x_m,camera_y_m,camera_yaw_rad]`. A row
/// holds a sample, a camera pose (at the time its image was taken) or both; missing values are
/// empty. The drive is named after the file, without "-samples". Throws UserError (file:line).
/// Pure.
RecordedDrive parse_drive(std::string_view text, const std::string& file);

/// The drive as parse_drive reads it back, bit for bit; camera columns only if it has poses.
std::string write_drive(const RecordedDrive& drive);

/// Reads `run[,distance_m][,ahead_m][,left_m][,turned_deg][,slope_deg]`, one row per measured run;
/// `run` counts the drives from 1, an empty cell was not measured. Adds each row to its drive.
/// Throws UserError (file:line). Pure.
void add_measured(std::string_view text, const std::string& file,
                  std::vector<RecordedDrive>& drives);

/// The hand measurements of the drives, as add_measured reads them back; empty if there are none.
std::string write_measured(const std::vector<RecordedDrive>& drives);

/// The drive in a recording, with times as DriveSink has them. Throws UserError.
RecordedDrive recorded_drive(const record::Recording& recording,
                             std::optional<HostNs> since = std::nullopt);

class DriveSink : public messages::Sink, public messages::TruthSink {
 public:
  /// Times are those of the robot's clock; or, since a host time, of the host's clock. Then samples
  /// from before the clocks were related are left out.
  explicit DriveSink(std::optional<HostNs> since = std::nullopt) : since_(since) {}

  void take(const StepRecord& record) override;
  void take_truth(HostNs at, const Pose& truth) override;

  /// Samples and camera poses of the last boot. Its name is empty.
  const RecordedDrive& drive() const { return drive_; }
  /// Exact poses at the drive's samples if they are known; else all zero.
  const std::vector<Pose>& truth() const { return truth_; }

 private:
  std::optional<HostNs> since_;
  RecordedDrive drive_;
  std::vector<HostNs> measured_ns_;  // of the samples
  std::vector<Pose> truth_;
};

}  // namespace tp100::identify
