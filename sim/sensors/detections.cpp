#include "sim/sensors/detections.h"

#include <cmath>
#include <cstdint>
#include <optional>

#include "core/error.h"
#include "core/time.h"
#include "core/upright.h"
#include "course/bundled_files.h"
#include "text/csv_reader.h"

namespace tp100::sim {
namespace {

constexpr double kMaxTimeS = 1e7;
constexpr double kMaxPlaceM = 1e3;

}  // namespace

std::vector<CameraSample> read_detections(const std::string& path) {
  const text::CsvTable table = text::parse_csv(
      course::read_text_file(path).text, path,
      {.required = {"t_s", "tx_m", "ty_m", "tz_m", "qx", "qy", "qz", "qw"}, .header = false});
  std::vector<CameraSample> samples;
  for (std::size_t i = 0; i < table.rows(); ++i) {
    const auto fail = [&](const std::string& what) {
      return UserError(table.where(i) + ": " + what + "; tp100-camera --tum writes such files");
    };
    const double t_s = table["t_s"][i], x_m = table["tx_m"][i], y_m = table["ty_m"][i];
    if (std::abs(t_s) > kMaxTimeS)
      throw fail("more than 1e7 s; give times from the start of the images");
    if (std::abs(x_m) > kMaxPlaceM || std::abs(y_m) > kMaxPlaceM) throw fail("farther than 1000 m");
    const std::optional<double> yaw_rad =
        upright_yaw({table["qx"][i], table["qy"][i], table["qz"][i], table["qw"][i]});
    if (!yaw_rad)
      throw fail(
          "the quaternion has not length 1, or turns the robot over; its order is qx qy qz qw");
    samples.push_back({.x_m = x_m,
                       .y_m = y_m,
                       .yaw_rad = *yaw_rad,
                       .measured_ns = from_s(t_s),
                       .sequence = static_cast<std::uint32_t>(i + 1)});
  }
  return samples;
}

}  // namespace tp100::sim
