#include "sim/sensors/detections.h"

#include <array>
#include <cmath>
#include <cstdint>
#include <sstream>

#include "core/error.h"
#include "core/time.h"
#include "course/bundled_files.h"

namespace tp100::sim {
namespace {

constexpr double kMaxTimeS = 1e7;
constexpr double kMaxPlaceM = 1e3;

}  // namespace

std::vector<CameraSample> read_detections(const std::string& path) {
  std::istringstream rows(course::read_text_file(path).text);
  std::vector<CameraSample> samples;
  std::string row;
  for (int line = 1; std::getline(rows, row); ++line) {
    if (row.empty() || row.starts_with('#')) continue;
    const auto fail = [&](const std::string& what) {
      return UserError(path + ":" + std::to_string(line) + ": " + what +
                       "; tp100-camera --tum writes such files");
    };
    std::istringstream words(row);
    std::array<double, 8> values{};  // t x y z qx qy qz qw
    for (double& value : values)
      if (!(words >> value) || !std::isfinite(value)) throw fail("fewer than 8 numbers");
    const auto [t_s, x_m, y_m, z_m, qx, qy, qz, qw] = values;
    if (std::abs(t_s) > kMaxTimeS || std::abs(x_m) > kMaxPlaceM || std::abs(y_m) > kMaxPlaceM)
      throw fail("out of range");
    CameraSample sample{
        .x_m = x_m,
        .y_m = y_m,
        .yaw_rad = std::atan2(2.0 * (qw * qz + qx * qy), 1.0 - 2.0 * (qy * qy + qz * qz)),
        .measured_ns = from_s(t_s),
        .sequence = static_cast<std::uint32_t>(samples.size() + 1)};
    if (!samples.empty() && sample.measured_ns <= samples.back().measured_ns)
      throw fail("not later than the one before");
    samples.push_back(sample);
  }
  if (samples.empty()) throw UserError(path + ": no detection in it");
  return samples;
}

}  // namespace tp100::sim
