#pragma once
// A robot file as data. `model`, `shape` and `drive` are what the daemon assumes and sends to the
// firmware; they come from driving the robot (identify) and from measuring it. `baselines` are
// simpler forms of the model from the same drives, which only reports use. `emulated` is the
// physics of an emulated robot of that kind; the daemon never reads it, and `model` is never copied
// from it.

#include <array>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "core/enum_names.h"
#include "course/robot.h"
#include "model/model_form.h"
#include "model/track_parameters.h"

namespace tp100::text {
struct KeyText;
}

namespace tp100::course {

/// Rigid body and tracks (sim/body). Creep, track deficit and lift of the middle are those of the
/// contact law `ode`.
struct EmulatedBody {
  double mass_kg = 0.922;
  double length_m = 0.185, width_m = 0.205, height_m = 0.060;  ///< inertia box
  double axle_spacing_m = 0.133;
  double wheel_radius_m = 0.026;  ///< outer radius of wheel and track
  double gauge_m = 0.155;         ///< distance between track centre lines
  double shoe_width_m = 0.045;
  double com_height_m = 0.022;  ///< above the ground
  double com_forward_m = 0.0;   ///< from the middle of the axles
  double com_left_m = 0.0;
  double mid_lift_m = 0.0003;  ///< mid stations above the end stations: 0.3 mm loads the ends only
  double friction = 0.9;
  double slick_m = 0.0;  ///< length of each track that is worn smooth, on the ground once a turn
  double slick_factor = 0.5;  ///< on the friction of that stretch
  double creep_left = 0.148;  ///< contact creep, slip per unit of traction / weight
  double creep_right = 0.148;
  double track_deficit_left = 0.160;  ///< surface speed lost against the encoder's track speed
  double track_deficit_right = 0.160;
};

/// Law of the contact between tracks and ground; it selects the emulated robot's body (sim/body).
enum class ContactLaw {
  kOde,    ///< rigid-body contacts, on every terrain
  kShear,  ///< shear stress that builds up under each shoe, on level ground
};

/// Names as in options, files and results.
inline constexpr std::array<EnumName<ContactLaw>, 2> kContactLawNames = {{
    {ContactLaw::kOde, "ode"},
    {ContactLaw::kShear, "shear"},
}};
constexpr const char* to_string(ContactLaw law) { return name_in(kContactLawNames, law); }

/// Whether an emulated robot's floor is the same everywhere and every run begins alike.
enum class Floor {
  kEven,    ///< yes: a seed draws sensor noise and where tracks and samples begin
  kUneven,  ///< no: a seed draws what EmulatedVariation describes, too
};

/// Names as in options, files and results.
inline constexpr std::array<EnumName<Floor>, 2> kFloorNames = {{
    {Floor::kEven, "even"},
    {Floor::kUneven, "uneven"},
}};
constexpr const char* to_string(Floor floor) { return name_in(kFloorNames, floor); }

/// What a seed draws of floor and robot where the floor is uneven. The values are our own: we know
/// of no measurement of such a floor.
struct EmulatedVariation {
  double friction_sd = 0.08;    ///< over the floor, in parts of the friction
  double slip_sd = 0.01;        ///< over the floor, added to the track deficit; `ode` only
  double correlation_m = 0.3;   ///< distance within which the floor hardly changes
  double tile_m = 0.0;          ///< side of square tiles that differ from each other; 0: none
  double tension_sd = 0.005;    ///< of each track deficit, from run to run; `ode` only
  double payload_sd_m = 0.002;  ///< of the centre of mass, forward and to the left
  double battery_sd_v = 0.2;    ///< below full_v at the start
  double placed_sd_m = 0.0;     ///< of x and of y, where a person puts it down; 0: at the start
  double placed_sd_rad = 0.0;
  double gyro_scale_sd = 0.0;                 ///< of the gyro's scale, from run to run
  double gyro_drift_sd_radps_per_degc = 0.0;  ///< of its drift with temperature [rad/s per K]
};

/// The ground under the tracks by the contact law `shear`, which reads neither creep nor track
/// deficit nor lift of the middle. Sizes, mass, friction and worn stretches are EmulatedBody's.
struct EmulatedShear {
  double modulus_m = 0.001;          ///< Janosi and Hanamoto's K
  double cohesion_pa = 0.0;          ///< shear strength without pressure
  double motion_resistance = 0.06;   ///< in parts of the weight
  double pressure_unevenness = 0.6;  ///< 0: even; 1: no load between the wheels
};

/// DC motor behind an L293D (sim/sensors).
struct EmulatedMotor {
  double no_load_mps_per_v = 0.052;  ///< track speed per motor volt without load
  double stall_n_per_v = 2.0;        ///< track force per motor volt at rest
  double friction_n = 1.0;     ///< Coulomb friction of motor and gears at the track: the dead band
  double lag_s = 0.080;        ///< speed time constant without load
  double bridge_drop_v = 2.0;  ///< L293D, both transistors
  double current_limit_n = 12.0;  ///< track force at the driver's current limit
  double left_gain = 1.0;         ///< asymmetry of the two motors
  double right_gain = 1.0;
};

/// Quadrature encoders.
struct EmulatedEncoder {
  double counts_per_metre = 11140.0;  ///< true edges per metre of track
  double phase_error = 0.05;          ///< edge position error, parts of one edge
};

/// MPU6050 (data sheet rev 3.4, sections 6.1, 6.2).
struct EmulatedImu {
  double gyro_noise_radps_rthz = 8.7e-5;  ///< 0.005 deg/s/sqrt(Hz)
  double gyro_bias_radps = 0.02;          ///< sd of the turn-on bias over seeds
  double gyro_bias_walk_radps_rts = 1e-5;
  double gyro_scale_error = 0.01;         ///< z axis, fixed for this robot
  double gyro_bias_per_degc = 5e-4;       ///< [rad/s per K]
  double accel_noise_mps2_rthz = 3.9e-3;  ///< 400 ug/sqrt(Hz)
  double accel_bias_mps2 = 0.3;           ///< sd over seeds
  double start_temperature_degc = 25.0;
  double warm_up_degc = 6.0;  ///< rise after power-on
  double warm_up_s = 180.0;
};

/// Two 18650 cells in series.
struct EmulatedBattery {
  double full_v = 8.2;
  double internal_ohm = 0.12;
  double capacity_as = 7200.0;
  double amps_per_n = 0.10;  ///< motor current per track force
  double idle_a = 0.15;
};

struct Emulated {
  ContactLaw contact_law = ContactLaw::kOde;
  Floor floor = Floor::kEven;
  EmulatedBody body{};
  EmulatedVariation variation{};
  EmulatedShear shear{};
  EmulatedMotor motor{};
  EmulatedEncoder encoder{};
  EmulatedImu imu{};
  EmulatedBattery battery{};
  double clock_ppm = 40.0;  ///< error of the Mega's resonator
};

/// One robot.
struct Robot {
  std::string name;  ///< file stem, e.g. "end-loaded"
  std::string description;
  model::TrackParameters model{};
  /// Fitted simpler forms of the model, which reports compare with it; nothing: not fitted.
  model::PerBaseline<std::optional<model::TrackParameters>> baselines{};
  /// Where values of `model` came from, by key: a comment "# From ..." in the file.
  std::map<std::string, std::string, std::less<>> origins;
  ShapeValues shape{};
  DriveValues drive{};
  Emulated emulated{};
};

/// Parses a robot file. `file` is only used in messages. Throws UserError (file:line:column).
/// Pure.
Robot parse_robot(const std::string& text, const std::string& file);

/// The comment at the head of a robot file, up to the first blank line, on one line without its
/// marks. Pure.
std::string head_note(const std::string& text);

/// The robot as a commented file that parse_robot reads back: every key with meaning, unit,
/// default, range, and where a value of `model` came from. `note` becomes the comment at its head.
std::string write_robot(const Robot& robot, const std::string& note);

// The keys of a robot file as a list, for programs that display them.

/// Those that the daemon uses (model, shape, drive), named "robot.model.slip_left".
std::vector<text::KeyText> robot_keys(const Robot& robot);

}  // namespace tp100::course
