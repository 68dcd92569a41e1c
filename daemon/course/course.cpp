#include "course/course.h"

namespace tp100::course {
namespace {

void mirror(Place& place) {
  place.y_m = -place.y_m;
  place.heading_rad = -place.heading_rad;
}

struct Mirror {
  void operator()(Line& /*line*/) const {}
  void operator()(Arc& arc) const { arc.angle_rad = -arc.angle_rad; }
  void operator()(Pivot& pivot) const { pivot.angle_rad = -pivot.angle_rad; }
};

}  // namespace

Course mirrored(const Course& course) {
  Course other = course;
  other.name += "-mirrored";
  other.start.y_m = -other.start.y_m;
  other.start.yaw_rad = -other.start.yaw_rad;
  for (Segment& segment : other.path) std::visit(Mirror{}, segment);
  for (Disturbance& disturbance : other.disturbances) {
    disturbance.sideways_m = -disturbance.sideways_m;
    disturbance.yaw_rad = -disturbance.yaw_rad;
  }
  for (Ramp& ramp : other.terrain.ramps) mirror(ramp.place);
  for (Block& block : other.terrain.blocks) mirror(block.place);
  for (Surface& surface : other.terrain.surfaces) mirror(surface.place);
  other.fence.min_y_m = -course.fence.max_y_m;
  other.fence.max_y_m = -course.fence.min_y_m;
  for (Vertex& corner : other.fence.corners) corner.y_m = -corner.y_m;
  for (Polygon& area : other.fence.keep_out)
    for (Vertex& corner : area) corner.y_m = -corner.y_m;
  return other;
}

}  // namespace tp100::course
