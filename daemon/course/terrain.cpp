#include "course/terrain.h"

#include <cmath>

namespace tp100::course {

double Ramp::up_length_m() const { return height_m / std::tan(up_rad); }
double Ramp::down_length_m() const { return height_m / std::tan(down_rad); }
double Ramp::length_m() const { return up_length_m() + top_m + down_length_m(); }

bool Surface::covers(double x_m, double y_m) const {
  const double dx = x_m - place.x_m;
  const double dy = y_m - place.y_m;
  const double c = std::cos(place.heading_rad);
  const double s = std::sin(place.heading_rad);
  return std::abs(c * dx + s * dy) <= length_m / 2.0 && std::abs(c * dy - s * dx) <= width_m / 2.0;
}

const Surface* Terrain::surface_at(double x_m, double y_m) const {
  for (auto surface = surfaces.rbegin(); surface != surfaces.rend(); ++surface)
    if (surface->covers(x_m, y_m)) return &*surface;
  return nullptr;
}

}  // namespace tp100::course
