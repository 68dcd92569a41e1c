#include "identify/drive_file.h"

#include <array>
#include <cmath>
#include <filesystem>
#include <string>

#include "core/arithmetic.h"
#include "core/error.h"
#include "model/track_parameters.h"
#include "text/csv_reader.h"
#include "text/format.h"
#include "text/toml_document.h"

namespace tp100::identify {
namespace {

using text::number_text;

constexpr std::array<std::string_view, 3> kSampleColumns = {"left_count", "right_count",
                                                            "gyro_z_radps"};
constexpr std::array<std::string_view, 3> kCameraColumns = {"camera_x_m", "camera_y_m",
                                                            "camera_yaw_rad"};
// Above it a double does not represent every whole number.
constexpr double kMaxCounts = 9e15;
constexpr double kMaxMetres = 1e4;
constexpr double kMaxRadps = 1e3;
constexpr double kMaxRad = 1e6;
// Unix time in seconds, even in milliseconds, is fine.
constexpr double kMaxSeconds = 1e13;

/// One row of a table that must lie within limits.
class Row {
 public:
  Row(const text::CsvTable& table, std::size_t row) : table_(table), row_(row) {}

  double number(std::string_view column, double most) const {
    const double value = table_[column][row_];
    if (std::abs(value) > most)
      fail(std::string(column) + " is " + number_text(value) + ", allowed " + number_text(-most) +
           " to " + number_text(most));
    return value;
  }
  std::int64_t counts(std::string_view column) const {
    const double value = number(column, kMaxCounts);
    if (value != std::floor(value))
      fail(std::string(column) + " is " + number_text(value) + ", expected a whole number");
    return static_cast<std::int64_t>(value);
  }
  /// True if all of `columns` have a value, false if none; a mixture is an error.
  bool holds(const std::array<std::string_view, 3>& columns) const {
    std::size_t there = 0;
    for (const std::string_view column : columns)
      if (!std::isnan(table_[column][row_])) ++there;
    if (there != 0 && there != columns.size())
      fail("of " + std::string(columns[0]) + ", " + std::string(columns[1]) + " and " +
           std::string(columns[2]) + " only some have a value; give all or none");
    return there != 0;
  }
  [[noreturn]] void fail(const std::string& what) const {
    throw UserError(table_.where(row_) + ": " + what);
  }

 private:
  const text::CsvTable& table_;
  std::size_t row_;
};

void append(std::string& text, const DriveSample& sample) {
  text +=
      ',' + std::to_string(sample.left_counts) + ',' + std::to_string(sample.right_counts) + ',';
  text += text::shortest(sample.gyro_z_radps);
}

void append(std::string& text, const SeenPose& seen) {
  for (const double value : {seen.x_m, seen.y_m, seen.yaw_rad}) {
    text += ',' + text::shortest(value);
  }
}

constexpr double kSecondsPerUs = 1e-6;
// Eleven hours at 200 Hz.
constexpr std::size_t kMaxSamples = 8'000'000;

}  // namespace

RecordedDrive parse_drive(std::string_view text, const std::string& file) {
  const std::vector<std::string_view> camera(kCameraColumns.begin(), kCameraColumns.end());
  std::vector<std::string_view> required = {"t_s"};
  required.insert(required.end(), kSampleColumns.begin(), kSampleColumns.end());
  std::vector<std::string_view> gaps = camera;
  gaps.insert(gaps.end(), kSampleColumns.begin(), kSampleColumns.end());
  const text::CsvTable table = text::parse_csv(text, file, {required, camera, gaps});

  bool has_camera = false;
  for (const std::string_view column : camera) has_camera = has_camera || table.has(column);
  for (const std::string_view column : camera)
    if (has_camera && !table.has(column))
      throw UserError(file + ":1: column '" + std::string(column) +
                      "' is missing; a camera pose needs all three");

  RecordedDrive drive;
  drive.name = std::filesystem::path(file).stem().string();
  if (drive.name.ends_with("-samples")) drive.name.resize(drive.name.size() - 8);
  for (std::size_t i = 0; i < table.rows(); ++i) {
    const Row row(table, i);
    const double t_s = row.number("t_s", kMaxSeconds);
    const bool sampled = row.holds(kSampleColumns);
    const bool seen = has_camera && row.holds(kCameraColumns);
    if (!sampled && !seen) row.fail("neither a sample nor a camera pose in this row");
    if (sampled)
      drive.samples.push_back({t_s, row.counts("left_count"), row.counts("right_count"),
                               row.number("gyro_z_radps", kMaxRadps)});
    if (seen)
      drive.camera.push_back({t_s, row.number("camera_x_m", kMaxMetres),
                              row.number("camera_y_m", kMaxMetres),
                              row.number("camera_yaw_rad", kMaxRad)});
  }
  if (drive.samples.size() < 2)
    throw UserError(file + ": fewer than two samples; give a recording of a whole drive");
  return drive;
}

std::string write_drive(const RecordedDrive& drive) {
  const bool has_camera = !drive.camera.empty();
  std::string text = "t_s,left_count,right_count,gyro_z_radps";
  text += has_camera ? ",camera_x_m,camera_y_m,camera_yaw_rad\n" : "\n";
  auto sample = drive.samples.begin();
  auto seen = drive.camera.begin();
  while (sample != drive.samples.end() || seen != drive.camera.end()) {
    const bool with_sample =
        sample != drive.samples.end() && (seen == drive.camera.end() || sample->t_s <= seen->t_s);
    const bool with_seen =
        seen != drive.camera.end() && (sample == drive.samples.end() || seen->t_s <= sample->t_s);
    text += text::shortest(with_sample ? sample->t_s : seen->t_s);
    if (with_sample)
      append(text, *sample++);
    else
      text += ",,,";
    if (with_seen)
      append(text, *seen++);
    else if (has_camera)
      text += ",,,";
    text += '\n';
  }
  return text;
}

void add_measured(std::string_view text, const std::string& file,
                  std::vector<RecordedDrive>& drives) {
  const std::vector<std::string_view> columns = {"distance_m", "ahead_m", "left_m", "turned_deg",
                                                 "slope_deg"};
  const text::CsvTable table = text::parse_csv(text, file,
                                               {.required = {"run"},
                                                .optional = columns,
                                                .gaps = columns,
                                                .by_time = false,
                                                .others = false});
  for (std::size_t i = 0; i < table.rows(); ++i) {
    const Row row(table, i);
    const double run = row.number("run", kMaxCounts);
    if (run < 1.0 || run != std::floor(run) || run > static_cast<double>(drives.size()))
      row.fail("run is " + number_text(run) + ", but there are runs 1 to " +
               std::to_string(drives.size()));
    HandMeasured& measured = drives[static_cast<std::size_t>(run) - 1].measured;
    const auto take = [&](std::string_view column, double most, double si,
                          std::optional<double>& into) {
      if (table.has(column) && !std::isnan(table[column][i])) into = row.number(column, most) * si;
    };
    take("distance_m", kMaxMetres, 1.0, measured.distance_m);
    take("ahead_m", kMaxMetres, 1.0, measured.ahead_m);
    take("left_m", kMaxMetres, 1.0, measured.left_m);
    take("turned_deg", kMaxRad, kRadPerDeg, measured.turned_rad);
    take("slope_deg", model::kSteepestDeg, kRadPerDeg, measured.slope_rad);
    if (measured.distance_m && *measured.distance_m < 0.0) row.fail("distance_m is below 0");
    if (measured.slope_rad == 0.0) measured.slope_rad.reset();
    if (measured.slope_rad && !measured.distance_m)
      row.fail("distance_m is missing; a run on a slope needs the distance along it");
  }
}

std::string write_measured(const std::vector<RecordedDrive>& drives) {
  std::string rows;
  for (std::size_t i = 0; i < drives.size(); ++i) {
    const HandMeasured& m = drives[i].measured;
    if (!m.distance_m && !m.ahead_m && !m.left_m && !m.turned_rad) continue;
    rows += std::to_string(i + 1);
    const auto cell = [&rows](const std::optional<double>& value, double si) {
      rows += ',';
      if (value) rows += text::shortest(*value / si);
    };
    cell(m.distance_m, 1.0);
    cell(m.ahead_m, 1.0);
    cell(m.left_m, 1.0);
    cell(m.turned_rad, kRadPerDeg);
    cell(m.slope_rad, kRadPerDeg);
    rows += '\n';
  }
  return rows.empty() ? rows : "run,distance_m,ahead_m,left_m,turned_deg,slope_deg\n" + rows;
}

RecordedDrive recorded_drive(const record::Recording& recording, std::optional<HostNs> since) {
  DriveSink sink(since);
  recording.visit({.step = [&](const StepRecord& record) {
    sink.take(record);
    if (sink.drive().samples.size() + sink.drive().camera.size() > kMaxSamples)
      throw UserError(recording.path() + ": more than " + std::to_string(kMaxSamples) +
                      " samples are too many for one drive; record shorter ones");
  }});
  return sink.drive();
}

void DriveSink::take(const StepRecord& record) {
  if (record.inputs.robot_rebooted) {
    drive_ = {};
    measured_ns_.clear();
    truth_.clear();
  }
  for (std::size_t i = 0; i < record.inputs.samples.size(); ++i) {
    const Sample& sample = record.inputs.samples[i];
    if (since_ && sample.measured_ns == 0) continue;
    const double t_s = since_ ? to_s(sample.measured_ns - *since_)
                              : static_cast<double>(sample.device_us) * kSecondsPerUs;
    if (!drive_.samples.empty() && t_s <= drive_.samples.back().t_s) continue;
    drive_.samples.push_back({t_s, sample.left_counts, sample.right_counts, sample.gyro_radps[2]});
    measured_ns_.push_back(sample.measured_ns);
    truth_.emplace_back();
  }
  if (!record.inputs.clock.valid) return;
  for (std::size_t i = 0; i < record.inputs.camera.size(); ++i) {
    const CameraSample& seen = record.inputs.camera[i];
    const double t_s =
        since_
            ? to_s(seen.measured_ns - *since_)
            : static_cast<double>(record.inputs.clock.to_device(seen.measured_ns)) * kSecondsPerUs;
    if (!drive_.camera.empty() && t_s <= drive_.camera.back().t_s) continue;
    drive_.camera.push_back({t_s, seen.x_m, seen.y_m, seen.yaw_rad});
  }
}

void DriveSink::take_truth(HostNs at, const Pose& truth) {
  for (std::size_t i = measured_ns_.size(); i-- > 0 && measured_ns_[i] >= at;)
    if (measured_ns_[i] == at) truth_[i] = truth;
}

}  // namespace tp100::identify
