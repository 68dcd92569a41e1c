#include "sim/lab/real_data.h"

#include <cmath>

#include "core/arithmetic.h"
#include "core/error.h"
#include "text/csv_reader.h"

namespace tp100::sim {
namespace {

constexpr double kMaxxiiGaugeM = 0.606;
constexpr double kHuskyGaugeM = 0.5708;
constexpr std::size_t kRightSpeeds = 9;
constexpr double kUniformS = 0.002;  // how far the intervals of a window may differ

text::CsvTable unordered(const course::TextFile& file, std::vector<std::string_view> columns) {
  return text::parse_csv(file.text, file.path,
                         {.required = std::move(columns), .optional = {}, .by_time = false});
}

/// The first row after the window that begins at row `begin`.
std::size_t end_of_window(const text::CsvTable& table, std::size_t begin) {
  std::size_t end = begin;
  while (end < table.rows() && table["window"][end] == table["window"][begin]) ++end;
  return end;
}

RealMotion window(const text::CsvTable& table, std::size_t begin, std::size_t end) {
  if (end - begin < 2) throw UserError(table.where(begin) + ": a window of one sample");
  RealMotion motion;
  motion.row = static_cast<int>(table["window"][begin]);
  motion.column = static_cast<int>(table["step"][begin]);
  motion.dt_s =
      (table["t_s"][end - 1] - table["t_s"][begin]) / static_cast<double>(end - begin - 1);
  for (std::size_t i = begin + 1; i < end; ++i) {
    const auto mean = [&](const char* column) {
      return (table[column][i - 1] + table[column][i]) / 2.0;
    };
    const auto change = [&](const char* column) { return table[column][i] - table[column][i - 1]; };
    if (std::abs(change("t_s") - motion.dt_s) > kUniformS || motion.dt_s <= 0.0)
      throw UserError(table.where(i) + ": t_s does not increase in even steps");
    if (change("step") != 0.0) throw UserError(table.where(i) + ": step changes in a window");
    motion.speeds.push_back(
        {mean("left_wheel_mps"), mean("right_wheel_mps"), mean("gyro_z_radps")});
    motion.path_m += magnitude(change("x_m"), change("y_m"));
    motion.truth[2] += wrap_angle(change("yaw_rad"));
  }
  motion.truth[0] = table["x_m"][end - 1] - table["x_m"][begin];
  motion.truth[1] = table["y_m"][end - 1] - table["y_m"][begin];
  return motion;
}

}  // namespace

RealRobot parse_maxxii(const course::TextFile& file) {
  const text::CsvTable table = unordered(
      file,
      {"left_track_mps", "right_track_mps", "left_slip_mps", "right_slip_mps", "side_slip_rad"});
  RealRobot robot{.name = "MAXXII", .gauge_m = kMaxxiiGaugeM, .motions = {}};
  for (std::size_t i = 0; i < table.rows(); ++i) {
    const std::size_t column = i % kRightSpeeds;
    const double left_mps = table["left_track_mps"][i], right_mps = table["right_track_mps"][i];
    if (left_mps != table["left_track_mps"][i - column])
      throw UserError(table.where(i) + ": left_track_mps changes before its ninth row");
    const double left_ground_mps = left_mps - table["left_slip_mps"][i];
    const double right_ground_mps = right_mps - table["right_slip_mps"][i];
    const double forward_mps = (left_ground_mps + right_ground_mps) / 2.0;
    robot.motions.push_back(
        {.row = static_cast<int>(i / kRightSpeeds),
         .column = static_cast<int>(column),
         .speeds = {{left_mps, right_mps}},
         .truth = {forward_mps, forward_mps * std::tan(table["side_slip_rad"][i]),
                   (right_ground_mps - left_ground_mps) / kMaxxiiGaugeM}});
  }
  if (table.rows() % kRightSpeeds != 0)
    throw UserError(table.where(table.rows() - 1) +
                    ": the last left_track_mps does not have nine rows");
  return robot;
}

RealRobot parse_husky(const course::TextFile& file) {
  const text::CsvTable table =
      unordered(file, {"window", "step", "t_s", "left_wheel_mps", "right_wheel_mps", "gyro_z_radps",
                       "x_m", "y_m", "yaw_rad"});
  RealRobot robot{.name = "Husky", .gauge_m = kHuskyGaugeM, .motions = {}};
  for (std::size_t begin = 0, end = 0; begin < table.rows(); begin = end) {
    end = end_of_window(table, begin);
    robot.motions.push_back(window(table, begin, end));
  }
  return robot;
}

std::vector<RealRobot> read_real_robots() {
  const std::string folder = TP100_SOURCE_DIR "/tests/data/real";
  return {parse_maxxii(course::read_text_file(folder + "/maxxii-indoor.csv")),
          parse_husky(course::read_text_file(folder + "/husky-windows.csv"))};
}

}  // namespace tp100::sim
