#include <array>
#include <cmath>
#include <filesystem>
#include <span>
#include <sstream>

#include "course/robot.h"
#include "course/robot_keys.h"
#include "text/key.h"

namespace tp100::course {
namespace {

constexpr double kDeg = kRadPerDeg;

std::span<const text::Key<ModelValues>> model_keys() {
  using T = ModelValues;
  static const std::array<text::Key<T>, 13> kKeys = {{
      {"slip_left", &T::slip_left, {-0.5, 0.9}, "Slip ratio of the left belt on flat ground"},
      {"slip_right", &T::slip_right, {-0.5, 0.9}, "Slip ratio of the right belt on flat ground"},
      {"slip_angle_straight_deg",
       &T::slip_angle_straight_rad,
       {-20, 20},
       "Slip angle (beta of eq 2) while driving straight",
       kDeg},
      {"slip_angle_turning_deg",
       &T::slip_angle_turning_rad,
       {-20, 20},
       "Slip angle while turning; the yaw rate that counts as turning is in the configuration",
       kDeg},
      {"wheelbase_m",
       &T::wheelbase_m,
       {0.05, 2},
       "Equivalent wheelbase L of eq 5, turning slip included"},
      {"x_icr_m",
       &T::x_icr_m,
       {-0.2, 0.2},
       "Turning centre ahead of the reference point: sideways speed is less by this times the yaw "
       "rate"},
      {"wheelbase_tight_m",
       &T::wheelbase_tight_m,
       {0, 2},
       "Equivalent wheelbase in arcs so tight that the slower belt makes 0.4 of the faster one's "
       "speed; wheelbase_m holds from 0.65 on. 0: as on the spot"},
      {"x_icr_tight_shift_m",
       &T::x_icr_tight_shift_m,
       {-0.2, 0.2},
       "How much farther ahead the turning centre lies in tight arcs than in wide turns"},
      {"wheelbase_spin_m",
       &T::wheelbase_spin_m,
       {0, 2},
       "Equivalent wheelbase on the spot, where it differs from the one of wide turns; 0 nowhere"},
      {"x_icr_spin_shift_m",
       &T::x_icr_spin_shift_m,
       {-0.2, 0.2},
       "How much farther ahead the turning centre lies on the spot than in wide turns"},
      {"turn_slip",
       &T::turn_slip,
       {-0.5, 0.5},
       "Slip of both belts that a left turn adds and a right turn takes off, where belts creep "
       "unevenly; in turns until the slower belt makes 0.55 of the faster one's speed"},
      {"turn_slip_tight", &T::turn_slip_tight, {-0.5, 0.5}, "The same in tight turns"},
      {"gyro_scale",
       &T::gyro_scale,
       {0.8, 1.25},
       "True over nominal rate of the gyro's z axis, from turning on the spot by a known angle"},
  }};
  return kKeys;
}

std::span<const text::Key<ShapeValues>> shape_keys() {
  using T = ShapeValues;
  static const std::array<text::Key<T>, 7> kKeys = {{
      {"length_m", &T::length_m, {0.05, 1}, "Length over the belts"},
      {"height_m", &T::height_m, {0.02, 0.5}, "Height"},
      {"axle_spacing_m", &T::axle_spacing_m, {0.03, 1}, "Distance between the two axles"},
      {"belt_radius_m", &T::belt_radius_m, {0.005, 0.2}, "Outer radius of wheel and belt"},
      {"gauge_m", &T::gauge_m, {0.03, 1}, "Distance between the belts' centre lines"},
      {"com_height_m",
       &T::com_height_m,
       {0.005, 0.2},
       "Centre of mass above the belts' underside; decides which step can be climbed"},
      {"com_forward_m",
       &T::com_forward_m,
       {-0.2, 0.2},
       "Centre of mass ahead of the middle of the axles"},
  }};
  return kKeys;
}

std::span<const text::Key<DriveValues>> drive_keys() {
  using T = DriveValues;
  static const std::array<text::Key<T>, 17> kKeys = {{
      {"counts_per_metre", &T::counts_per_metre, {100, 1e6}, "Encoder edges per metre of belt"},
      {"max_track_mps", &T::max_track_mps, {0.01, 2}, "Highest belt speed that is asked for"},
      {"max_track_mps2", &T::max_track_mps2, {0.05, 20}, "Highest belt acceleration"},
      {"feed_forward",
       &T::feed_forward,
       {0, 100},
       "Duty per m/s of belt speed above the dead band"},
      {"dead_band", &T::dead_band, {0, 0.9}, "Duty at which a belt just moves"},
      {"speed_kp", &T::speed_kp, {0, 100}, "Duty per m/s of belt speed error"},
      {"speed_ki", &T::speed_ki, {0, 1000}, "Duty per m that the belt lags behind"},
      {"yaw_kp", &T::yaw_kp, {0, 50}, "Yaw rate in rad/s per rad of yaw error, in the firmware"},
      {"max_yaw_radps", &T::max_yaw_radps, {0.05, 10}, "Highest yaw rate that is asked for"},
      {"battery_cutoff_v",
       &T::battery_cutoff_v,
       {0, 20},
       "The robot stops below this voltage of both cells; 0 never"},
      {"stall_duty",
       &T::stall_duty,
       {0, 1},
       "A belt at rest above this duty counts as stalled; 0 never"},
      {"stall_s", &T::stall_s, {0.05, 10}, "Time after which a stalled belt stops the robot"},
      {"invert_left_motor", &T::invert_left_motor, {}, "Left motor leads are swapped"},
      {"invert_right_motor", &T::invert_right_motor, {}, "Right motor leads are swapped"},
      {"invert_left_encoder", &T::invert_left_encoder, {}, "Left encoder counts backwards"},
      {"invert_right_encoder", &T::invert_right_encoder, {}, "Right encoder counts backwards"},
      {"swap_tracks", &T::swap_tracks, {}, "Left and right are plugged the wrong way round"},
  }};
  return kKeys;
}

std::span<const text::Key<EmulatedBody>> body_keys() {
  using T = EmulatedBody;
  static const std::array<text::Key<T>, 19> kKeys = {{
      {"mass_kg", &T::mass_kg, {0.1, 10}, "Mass with electronics"},
      {"length_m", &T::length_m, {0.05, 1}, "Length of the box that gives the inertia"},
      {"width_m", &T::width_m, {0.05, 1}, "Width of that box"},
      {"height_m", &T::height_m, {0.02, 0.5}, "Height of that box"},
      {"axle_spacing_m", &T::axle_spacing_m, {0.03, 1}, "Distance between the two axles"},
      {"belt_radius_m", &T::belt_radius_m, {0.005, 0.2}, "Outer radius of wheel and belt"},
      {"gauge_m", &T::gauge_m, {0.03, 1}, "Distance between the belts' centre lines"},
      {"belt_width_m", &T::belt_width_m, {0.005, 0.3}, "Width of a belt"},
      {"com_height_m",
       &T::com_height_m,
       {0.005, 0.2},
       "Centre of mass above the ground; decides which step can be climbed"},
      {"com_forward_m",
       &T::com_forward_m,
       {-0.2, 0.2},
       "Centre of mass ahead of the middle of the axles"},
      {"com_left_m", &T::com_left_m, {-0.1, 0.1}, "Centre of mass to the left of the middle"},
      {"mid_lift_m",
       &T::mid_lift_m,
       {0, 0.005},
       "Middle of the belts above their ends: 0.3 mm loads the ends only, 0 loads the belt evenly"},
      {"friction", &T::friction, {0.05, 2}, "Friction coefficient between belt and ground"},
      {"slick_m",
       &T::slick_m,
       {0, 5},
       "Stretch of each belt that is worn smooth and comes round again and again"},
      {"slick_factor", &T::slick_factor, {0.05, 1}, "Friction there, in parts of the rest's"},
      {"creep_left",
       &T::creep_left,
       {0, 2},
       "Contact creep of the left belt: slip per traction / weight"},
      {"creep_right", &T::creep_right, {0, 2}, "Contact creep of the right belt"},
      {"belt_deficit_left",
       &T::belt_deficit_left,
       {-0.5, 0.5},
       "Part of the left encoder's belt speed that its surface does not have"},
      {"belt_deficit_right", &T::belt_deficit_right, {-0.5, 0.5}, "Same of the right belt"},
  }};
  return kKeys;
}

std::span<const text::Key<EmulatedMotor>> motor_keys() {
  using T = EmulatedMotor;
  static const std::array<text::Key<T>, 8> kKeys = {{
      {"no_load_mps_per_v",
       &T::no_load_mps_per_v,
       {0.001, 1},
       "Belt speed per motor volt without load"},
      {"stall_n_per_v", &T::stall_n_per_v, {0.05, 50}, "Belt force per motor volt at rest"},
      {"friction_n", &T::friction_n, {0, 20}, "Coulomb friction of motor and gears at the belt"},
      {"lag_s", &T::lag_s, {0.005, 2}, "Time constant of the speed without load"},
      {"bridge_drop_v", &T::bridge_drop_v, {0, 5}, "Voltage lost in both transistors of the L293D"},
      {"current_limit_n",
       &T::current_limit_n,
       {0.5, 100},
       "Belt force at the driver's current limit"},
      {"left_gain", &T::left_gain, {0.2, 2}, "Strength of the left motor against the nominal one"},
      {"right_gain", &T::right_gain, {0.2, 2}, "Strength of the right motor"},
  }};
  return kKeys;
}

std::span<const text::Key<EmulatedEncoder>> encoder_keys() {
  using T = EmulatedEncoder;
  static const std::array<text::Key<T>, 2> kKeys = {{
      {"counts_per_metre", &T::counts_per_metre, {100, 1e6}, "True edges per metre of belt"},
      {"phase_error",
       &T::phase_error,
       {0, 0.45},
       "Error of an edge's position in parts of one edge"},
  }};
  return kKeys;
}

std::span<const text::Key<EmulatedImu>> imu_keys() {
  using T = EmulatedImu;
  static const std::array<text::Key<T>, 10> kKeys = {{
      {"gyro_noise_radps_rthz", &T::gyro_noise_radps_rthz, {0, 0.1}, "Noise density of the gyro"},
      {"gyro_bias_radps",
       &T::gyro_bias_radps,
       {0, 1},
       "Standard deviation of the turn-on bias over seeds"},
      {"gyro_bias_walk_radps_rts",
       &T::gyro_bias_walk_radps_rts,
       {0, 0.01},
       "Random walk of the bias"},
      {"gyro_scale_error",
       &T::gyro_scale_error,
       {-0.2, 0.2},
       "Scale error of the z axis, of this robot"},
      {"gyro_bias_per_degc",
       &T::gyro_bias_per_degc,
       {-0.1, 0.1},
       "Change of the bias with temperature"},
      {"accel_noise_mps2_rthz",
       &T::accel_noise_mps2_rthz,
       {0, 1},
       "Noise density of the accelerometer"},
      {"accel_bias_mps2", &T::accel_bias_mps2, {0, 3}, "Standard deviation of its bias over seeds"},
      {"start_temperature_degc", &T::start_temperature_degc, {-20, 60}, "Temperature at power-on"},
      {"warm_up_degc", &T::warm_up_degc, {0, 40}, "Rise after power-on"},
      {"warm_up_s", &T::warm_up_s, {1, 3600}, "Time constant of that rise"},
  }};
  return kKeys;
}

std::span<const text::Key<EmulatedBattery>> battery_keys() {
  using T = EmulatedBattery;
  static const std::array<text::Key<T>, 5> kKeys = {{
      {"full_v", &T::full_v, {3, 20}, "Voltage of both cells at the start"},
      {"internal_ohm", &T::internal_ohm, {0, 5}, "Internal resistance of both cells"},
      {"capacity_as", &T::capacity_as, {10, 1e6}, "Charge of the cells"},
      {"amps_per_n", &T::amps_per_n, {0, 5}, "Motor current per belt force"},
      {"idle_a", &T::idle_a, {0, 5}, "Current of the electronics"},
  }};
  return kKeys;
}

std::span<const text::Key<Emulated>> emulated_keys() {
  static const std::array<text::Key<Emulated>, 1> kKeys = {{
      {"clock_ppm", &Emulated::clock_ppm, {-20000, 20000}, "Error of the Mega's resonator"},
  }};
  return kKeys;
}

template <class T>
std::string section(const char* name, std::span<const text::Key<T>> keys, const T& values,
                    const text::Origins& origins = {}) {
  return "\n[" + std::string(name) + "]\n" + text::write_keys(keys, values, origins);
}

}  // namespace

Robot parse_robot(const std::string& text, const std::string& file) {
  const text::TomlDocument document(text, file);
  text::TomlTable root = document.root();
  Robot robot;
  robot.name = std::filesystem::path(file).stem().string();
  robot.description = root.text("description", "");
  text::TomlTable model = root.table("model");
  text::TomlTable shape = root.table("shape");
  text::TomlTable drive = root.table("drive");
  text::TomlTable emulated = root.table("emulated");
  text::TomlTable body = emulated.table("body");
  text::TomlTable motor = emulated.table("motor");
  text::TomlTable encoder = emulated.table("encoder");
  text::TomlTable imu = emulated.table("imu");
  text::TomlTable battery = emulated.table("battery");
  text::read_keys(model, model_keys(), robot.model);
  robot.origins = text::read_origins(text, "model");
  text::read_keys(shape, shape_keys(), robot.shape);
  text::read_keys(drive, drive_keys(), robot.drive);
  text::read_keys(emulated, emulated_keys(), robot.emulated);
  text::read_keys(body, body_keys(), robot.emulated.body);
  text::read_keys(motor, motor_keys(), robot.emulated.motor);
  text::read_keys(encoder, encoder_keys(), robot.emulated.encoder);
  text::read_keys(imu, imu_keys(), robot.emulated.imu);
  text::read_keys(battery, battery_keys(), robot.emulated.battery);
  root.finish();
  if (robot.emulated.body.belt_width_m >= robot.emulated.body.gauge_m)
    body.fail("belt_width_m", "'emulated.body.belt_width_m' must be below 'emulated.body.gauge_m'");
  if (std::abs(robot.shape.com_forward_m) >= robot.shape.axle_spacing_m / 2.0)
    shape.fail("com_forward_m", "'shape.com_forward_m' must lie between the axles");
  if (robot.model.wheelbase_spin_m != 0.0 && robot.model.wheelbase_spin_m < 0.05)
    model.fail("wheelbase_spin_m", "'model.wheelbase_spin_m' must be 0 or at least 0.05 m");
  if (robot.model.wheelbase_tight_m != 0.0 && robot.model.wheelbase_tight_m < 0.05)
    model.fail("wheelbase_tight_m", "'model.wheelbase_tight_m' must be 0 or at least 0.05 m");
  return robot;
}

std::string head_note(const std::string& text) {
  std::string note;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line) && line.starts_with('#');) {
    line.erase(0, line.find_first_not_of("# "));
    if (!line.empty() && line.back() == '\r') line.pop_back();
    if (!line.empty()) note += (note.empty() ? "" : " ") + line;
  }
  return note;
}

std::vector<text::KeyText> robot_keys(const Robot& robot) {
  std::vector<text::KeyText> out;
  text::describe_keys("robot.model.", model_keys(), robot.model, out);
  text::describe_keys("robot.shape.", shape_keys(), robot.shape, out);
  text::describe_keys("robot.drive.", drive_keys(), robot.drive, out);
  return out;
}

std::string write_robot(const Robot& robot, const std::string& note) {
  const Emulated& emulated = robot.emulated;
  return text::toml_comment(note) + "\ndescription = " + text::toml_string(robot.description) +
         "\n" +
         "\n# What the daemon believes of this robot. Found by driving it, never copied from "
         "[emulated].\n" +
         section("model", model_keys(), robot.model, robot.origins).substr(1) +
         "\n# What a ruler and a balance find: how it stands on ramps and steps.\n" +
         section("shape", shape_keys(), robot.shape).substr(1) +
         "\n# How it is wired and driven; sent to the firmware at connect.\n" +
         section("drive", drive_keys(), robot.drive).substr(1) +
         "\n# Physics of an emulated robot of this kind; a real robot ignores all of it, and so "
         "does the "
         "daemon.\n" +
         section("emulated", emulated_keys(), emulated).substr(1) +
         section("emulated.body", body_keys(), emulated.body) +
         section("emulated.motor", motor_keys(), emulated.motor) +
         section("emulated.encoder", encoder_keys(), emulated.encoder) +
         section("emulated.imu", imu_keys(), emulated.imu) +
         section("emulated.battery", battery_keys(), emulated.battery);
}

}  // namespace tp100::course
