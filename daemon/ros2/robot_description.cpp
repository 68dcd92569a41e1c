#include "ros2/robot_description.h"

#include <string>
#include <tuple>

#include "core/error.h"
#include "text/format.h"

namespace tp100::ros2 {
namespace {

/// A visible shape that is also its collision shape, in the frame of its link.
std::string solid(const std::string& shape, const std::string& xyz, const std::string& rpy,
                  const char* colour) {
  const std::string place =
      "<origin xyz=\"" + xyz + "\" rpy=\"" + rpy + "\"/><geometry>" + shape + "</geometry>";
  return "    <visual>" + place + "<material name=\"" + colour + "\"/></visual>\n    <collision>" +
         place + "</collision>\n";
}

std::string box(double x_m, double y_m, double z_m) {
  return text::format("<box size=\"%g %g %g\"/>", x_m, y_m, z_m);
}

std::string at(double x_m, double y_m, double z_m) {
  return text::format("%g %g %g", x_m, y_m, z_m);
}

std::string joint(const char* name, const char* type, const char* child, const std::string& xyz) {
  std::string text = "  <joint name=\"" + std::string(name) + "\" type=\"" + type + "\">\n";
  text += "    <parent link=\"" + std::string(kBaseLink) + "\"/><child link=\"" + child + "\"/>\n";
  text += "    <origin xyz=\"" + xyz + "\" rpy=\"0 0 0\"/>\n";
  if (std::string(type) == "continuous") text += "    <axis xyz=\"0 1 0\"/>\n";
  return text + "  </joint>\n";
}

/// `name` without characters that have a meaning in XML.
std::string plain(const std::string& name) {
  std::string out = one_line(name);
  for (char& c : out)
    if (c == '<' || c == '>' || c == '&' || c == '"') c = '_';
  return out;
}

}  // namespace

std::string robot_description(const course::Robot& robot) {
  const course::ShapeValues& shape = robot.shape;
  // In the robot file, only the emulated robot has the widths of shoe and body.
  const double shoe_m = robot.emulated.body.shoe_width_m;
  const double radius_m = shape.wheel_radius_m, half_gauge_m = shape.gauge_m / 2.0;
  const double belly_m = radius_m, front_m = shape.axle_spacing_m / 2.0;
  std::string text = "<?xml version=\"1.0\"?>\n<robot name=\"" + plain(robot.name) + "\">\n";
  text +=
      "  <material name=\"body\"><color rgba=\"0.8 0.6 0.2 1\"/></material>\n"
      "  <material name=\"track\"><color rgba=\"0.15 0.15 0.15 1\"/></material>\n"
      "  <material name=\"sprocket\"><color rgba=\"0.6 0.6 0.6 1\"/></material>\n";
  text += "  <link name=\"" + std::string(kBaseLink) + "\">\n";
  text += solid(box(shape.length_m, shape.gauge_m - shoe_m, shape.height_m - belly_m),
                at(0.0, 0.0, (shape.height_m + belly_m) / 2.0), "0 0 0", "body");
  for (const double side : {1.0, -1.0})
    text += solid(box(shape.axle_spacing_m + 2.0 * radius_m, shoe_m, 2.0 * radius_m),
                  at(0.0, side * half_gauge_m, radius_m), "0 0 0", "track");
  text += "  </link>\n  <link name=\"" + std::string(kImuLink) + "\"/>\n";
  text += joint("imu_joint", "fixed", kImuLink, at(0.0, 0.0, 0.0));
  const std::string wheel =
      text::format("<cylinder radius=\"%g\" length=\"%g\"/>", 0.8 * radius_m, 1.05 * shoe_m);
  for (const auto& [name, link, side] : {std::tuple(kLeftJoint, "left_sprocket", 1.0),
                                         std::tuple(kRightJoint, "right_sprocket", -1.0)}) {
    text += "  <link name=\"" + std::string(link) + "\">\n";
    text += solid(wheel, "0 0 0", "1.5707963267948966 0 0", "sprocket") + "  </link>\n";
    text += joint(name, "continuous", link, at(front_m, side * half_gauge_m, radius_m));
  }
  return text + "</robot>\n";
}

}  // namespace tp100::ros2
