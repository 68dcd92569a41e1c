#include "course/emulated_keys.h"

#include <array>

namespace tp100::course {

std::span<const text::Key<EmulatedBody>> body_keys() {
  using T = EmulatedBody;
  static const std::array<text::Key<T>, 19> kKeys = {{
      {"mass_kg", &T::mass_kg, {0.1, 10}, "Mass with electronics"},
      {"length_m",
       &T::length_m,
       {0.05, 1},
       "Length of the box from which the inertia is calculated"},
      {"width_m", &T::width_m, {0.05, 1}, "Width of that box"},
      {"height_m", &T::height_m, {0.02, 0.5}, "Height of that box"},
      {"axle_spacing_m", &T::axle_spacing_m, {0.03, 1}, "Distance between the two axles"},
      {"wheel_radius_m", &T::wheel_radius_m, {0.005, 0.2}, "Outer radius of wheel and track"},
      {"gauge_m", &T::gauge_m, {0.03, 1}, "Distance between the tracks' centre lines"},
      {"shoe_width_m", &T::shoe_width_m, {0.005, 0.3}, "Width of a track"},
      {"com_height_m",
       &T::com_height_m,
       {0.005, 0.2},
       "Height of the centre of mass above the ground; it limits the steps that can be climbed"},
      {"com_forward_m",
       &T::com_forward_m,
       {-0.2, 0.2},
       "Distance of the centre of mass ahead of the middle between the axles"},
      {"com_left_m",
       &T::com_left_m,
       {-0.1, 0.1},
       "Distance of the centre of mass to the left of the middle"},
      {"mid_lift_m",
       &T::mid_lift_m,
       {0, 0.005},
       "Height of the middle of the tracks above their ends: with 0.3 mm only the ends carry load, "
       "with 0 the load is even"},
      {"friction", &T::friction, {0.05, 2}, "Friction coefficient between track and ground"},
      {"slick_m",
       &T::slick_m,
       {0, 5},
       "Length of the worn, smooth part of each track, which reaches the ground in every "
       "revolution"},
      {"slick_factor",
       &T::slick_factor,
       {0.05, 1},
       "Friction of that part, relative to the rest of the track"},
      {"creep_left",
       &T::creep_left,
       {0, 2},
       "Contact creep of the left track: slip per traction / weight"},
      {"creep_right", &T::creep_right, {0, 2}, "Contact creep of the right track"},
      {"track_deficit_left",
       &T::track_deficit_left,
       {-0.5, 0.5},
       "Share by which the left track's surface is slower than its encoder indicates"},
      {"track_deficit_right", &T::track_deficit_right, {-0.5, 0.5}, "Same for the right track"},
  }};
  return kKeys;
}

std::span<const text::Key<EmulatedVariation>> variation_keys() {
  using T = EmulatedVariation;
  static const std::array<text::Key<T>, 11> kKeys = {{
      {"friction_sd",
       &T::friction_sd,
       {0, 0.3},
       "Standard deviation of the friction over the floor, relative to it"},
      {"slip_sd",
       &T::slip_sd,
       {0, 0.1},
       "Standard deviation over the floor of what is added to the slip of a track; only for "
       "contact_law \"ode\""},
      {"correlation_m",
       &T::correlation_m,
       {0.02, 20},
       "Distance within which the floor is much the same"},
      {"tile_m",
       &T::tile_m,
       {0, 20},
       "Side of square tiles; half of the variance is then from tile to tile, with a jump at each "
       "joint. 0: no tiles"},
      {"tension_sd",
       &T::tension_sd,
       {0, 0.1},
       "Standard deviation of either track's deficit from run to run; only for contact_law "
       "\"ode\""},
      {"payload_sd_m",
       &T::payload_sd_m,
       {0, 0.01},
       "Standard deviation of the centre of mass from run to run, forward and to the left"},
      {"battery_sd_v",
       &T::battery_sd_v,
       {0, 1},
       "The battery begins below its full voltage, by the magnitude of a normal number with this "
       "standard deviation"},
      {"placed_sd_m",
       &T::placed_sd_m,
       {0, 0.1},
       "Standard deviation of x and y where a person puts the robot down; 0: exactly at the start"},
      {"placed_sd_rad", &T::placed_sd_rad, {0, 0.2}, "Standard deviation of the heading there"},
      {"gyro_scale_sd",
       &T::gyro_scale_sd,
       {0, 0.03},
       "Standard deviation of the gyro's scale error from run to run"},
      {"gyro_drift_sd_radps_per_degc",
       &T::gyro_drift_sd_radps_per_degc,
       {0, 0.02},
       "Standard deviation of the change of its bias with temperature"},
  }};
  return kKeys;
}

// Wong, Theory of Ground Vehicles, tables 2.3 and 2.4: K 1 cm on firm sandy terrain, 2.5 cm on
// loose sand, 2.5 to 5 cm on fresh snow; cohesion 0 to 1 kPa of dry sand, 3 to 70 kPa of clays;
// resistance of tracks 0.03 of the weight on hard ground to 0.25 on soft. Rubber on a hard floor
// shears over about a millimetre.
std::span<const text::Key<EmulatedShear>> shear_keys() {
  using T = EmulatedShear;
  static const std::array<text::Key<T>, 4> kKeys = {{
      {"modulus_m",
       &T::modulus_m,
       {0.0001, 0.05},
       "Janosi and Hanamoto's modulus K: sliding path after which 63 % of the limit are reached. "
       "About 1 mm for rubber on a hard floor, 5 mm for soft tracks, 10 to 25 mm on sand"},
      {"cohesion_pa",
       &T::cohesion_pa,
       {0, 10000},
       "Shear strength without pressure; 0 on hard floors and dry sand"},
      {"motion_resistance",
       &T::motion_resistance,
       {0, 0.3},
       "Resistance of the ground to motion, in parts of the weight: 0.03 to 0.1 on hard floors, up "
       "to 0.25 on soft ground"},
      {"pressure_unevenness",
       &T::pressure_unevenness,
       {0, 1},
       "How much of the load the wheels carry: with 0 the pressure along the tracks is even, with "
       "1 it is 0 in their middle and three times the mean at their ends"},
  }};
  return kKeys;
}

std::span<const text::Key<EmulatedMotor>> motor_keys() {
  using T = EmulatedMotor;
  static const std::array<text::Key<T>, 8> kKeys = {{
      {"no_load_mps_per_v",
       &T::no_load_mps_per_v,
       {0.001, 1},
       "Track speed per motor volt without load"},
      {"stall_n_per_v", &T::stall_n_per_v, {0.05, 50}, "Track force per motor volt at standstill"},
      {"friction_n", &T::friction_n, {0, 20}, "Coulomb friction of motor and gears at the track"},
      {"lag_s", &T::lag_s, {0.005, 2}, "Time constant of the speed without load"},
      {"bridge_drop_v", &T::bridge_drop_v, {0, 5}, "Voltage lost in both transistors of the L293D"},
      {"current_limit_n",
       &T::current_limit_n,
       {0.5, 100},
       "Track force at the driver's current limit"},
      {"left_gain",
       &T::left_gain,
       {0.2, 2},
       "Strength of the left motor, relative to the nominal motor"},
      {"right_gain", &T::right_gain, {0.2, 2}, "Strength of the right motor"},
  }};
  return kKeys;
}

std::span<const text::Key<EmulatedEncoder>> encoder_keys() {
  using T = EmulatedEncoder;
  static const std::array<text::Key<T>, 2> kKeys = {{
      {"counts_per_metre", &T::counts_per_metre, {100, 1e6}, "True edges per metre of track"},
      {"phase_error",
       &T::phase_error,
       {0, 0.45},
       "Error of an edge's position, relative to the distance between edges"},
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
      {"gyro_scale_error", &T::gyro_scale_error, {-0.2, 0.2}, "Scale error of this robot's z axis"},
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
      {"full_v", &T::full_v, {3, 20}, "Battery voltage at the start"},
      {"internal_ohm", &T::internal_ohm, {0, 5}, "Internal resistance of the battery"},
      {"capacity_as", &T::capacity_as, {10, 1e6}, "Charge of the battery"},
      {"amps_per_n", &T::amps_per_n, {0, 5}, "Motor current per track force"},
      {"idle_a", &T::idle_a, {0, 5}, "Current of the electronics"},
  }};
  return kKeys;
}

std::span<const text::Key<Emulated>> emulated_keys() {
  static const std::array<text::Key<Emulated>, 3> kKeys = {{
      {"clock_ppm", &Emulated::clock_ppm, {-20000, 20000}, "Error of the Mega's resonator"},
      {"contact_law",
       text::enum_choice<Emulated, &Emulated::contact_law, kContactLawNames>(),
       {},
       "Contact between tracks and ground, also chosen by --body: \"ode\", rigid bodies, or "
       "\"shear\", shear stress that builds up along the track, on level ground only"},
      {"floor",
       text::enum_choice<Emulated, &Emulated::floor, kFloorNames>(),
       {},
       "Whether the floor is the same everywhere, also chosen by --floor: \"even\", or "
       "\"uneven\", sampled from the seed as [emulated.variation] describes"},
  }};
  return kKeys;
}

}  // namespace tp100::course
