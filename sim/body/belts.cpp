#include "sim/body/belts.h"

namespace tp100::sim {
namespace {

constexpr int kStations = 10;
constexpr double kColumnShare = 13.0 / 45.0;  // of the belt's width, from its centre line

}  // namespace

Belts::Belts(const course::EmulatedBody& values) : radius_m_(values.belt_radius_m) {
  for (const double side : {1.0, -1.0}) {
    for (const double column : {1.0, -1.0}) {
      for (int i = 0; i < kStations; ++i) {
        const bool end = i == 0 || i == kStations - 1;
        const double along = static_cast<double>(i) / (kStations - 1) - 0.5;
        stations_.push_back(
            {{along * values.axle_spacing_m - values.com_forward_m,
              side * values.gauge_m / 2.0 + column * kColumnShare * values.belt_width_m -
                  values.com_left_m,
              values.belt_radius_m + (end ? 0.0 : values.mid_lift_m) - values.com_height_m},
             side > 0.0});
      }
    }
  }
  contacts_.reserve(stations_.size());
}

const std::vector<BeltContact>& Belts::touch(const Eigen::Vector3d& position_m,
                                             const Eigen::Matrix3d& rotation) {
  contacts_.clear();
  for (const Station& station : stations_) {
    const Eigen::Vector3d centre = position_m + rotation * station.centre_m;
    const double depth = radius_m_ - centre.z();
    if (depth <= 0.0) continue;
    contacts_.push_back(
        {{centre.x(), centre.y(), 0.0}, Eigen::Vector3d::UnitZ(), depth, station.left});
  }
  return contacts_;
}

}  // namespace tp100::sim
