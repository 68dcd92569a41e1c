#include "course/robot_file.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <span>
#include <sstream>

#include "core/arithmetic.h"
#include "course/emulated_keys.h"
#include "text/key.h"

namespace tp100::course {
namespace {

std::span<const text::Key<model::TrackParameters>> model_keys() {
  static const auto kKeys = [] {
    std::array<text::Key<model::TrackParameters>, model::kTrackParameters.size()> keys;
    std::ranges::transform(model::kTrackParameters, keys.begin(), [](const auto& row) {
      return text::Key<model::TrackParameters>{
          row.key, row.value, {row.least, row.most}, row.meaning, row.si};
    });
    return keys;
  }();
  return kKeys;
}

/// The keys of the parameters that the form fits.
std::vector<text::Key<model::TrackParameters>> form_keys(const model::ModelForm& form) {
  std::vector<text::Key<model::TrackParameters>> keys;
  for (std::size_t i = 0; i < model_keys().size(); ++i)
    if (form.fitted[i]) keys.push_back(model_keys()[i]);
  return keys;
}

std::span<const text::Key<ShapeValues>> shape_keys() {
  using T = ShapeValues;
  static const std::array<text::Key<T>, 7> kKeys = {{
      {"length_m", &T::length_m, {0.05, 1}, "Length over the tracks"},
      {"height_m", &T::height_m, {0.02, 0.5}, "Height"},
      {"axle_spacing_m", &T::axle_spacing_m, {0.03, 1}, "Distance between the two axles"},
      {"wheel_radius_m", &T::wheel_radius_m, {0.005, 0.2}, "Outer radius of wheel and track"},
      {"gauge_m", &T::gauge_m, {0.03, 1}, "Distance between the tracks' centre lines"},
      {"com_height_m",
       &T::com_height_m,
       {0.005, 0.2},
       "Height of the centre of mass above the tracks' underside; it limits the steps that can be "
       "climbed"},
      {"com_forward_m",
       &T::com_forward_m,
       {-0.2, 0.2},
       "Distance of the centre of mass ahead of the middle between the axles"},
  }};
  return kKeys;
}

std::span<const text::Key<DriveValues>> drive_keys() {
  using T = DriveValues;
  static const std::array<text::Key<T>, 17> kKeys = {{
      {"counts_per_metre", &T::counts_per_metre, {100, 1e6}, "Encoder edges per metre of track"},
      {"max_track_mps", &T::max_track_mps, {0.01, 2}, "Highest commanded track speed"},
      {"max_track_mps2", &T::max_track_mps2, {0.05, 20}, "Highest track acceleration"},
      {"feed_forward",
       &T::feed_forward,
       {0, 100},
       "Duty per m/s of track speed above the dead band"},
      {"dead_band", &T::dead_band, {0, 0.9}, "Duty at which a track just moves"},
      {"speed_kp", &T::speed_kp, {0, 100}, "Duty per m/s of track speed error"},
      {"speed_ki", &T::speed_ki, {0, 1000}, "Duty per m that the track lags behind"},
      {"yaw_kp", &T::yaw_kp, {0, 50}, "Yaw rate in rad/s per rad of yaw error, in the firmware"},
      {"max_yaw_radps", &T::max_yaw_radps, {0.05, 10}, "Highest commanded yaw rate"},
      {"battery_cutoff_v",
       &T::battery_cutoff_v,
       {0, 20},
       "The robot stops below this battery voltage; 0: never"},
      {"stall_duty",
       &T::stall_duty,
       {0, 1},
       "A track at standstill above this duty counts as stalled; 0: never"},
      {"stall_s", &T::stall_s, {0.05, 10}, "Time after which a stalled track stops the robot"},
      {"invert_left_motor", &T::invert_left_motor, {}, "Left motor leads are swapped"},
      {"invert_right_motor", &T::invert_right_motor, {}, "Right motor leads are swapped"},
      {"invert_left_encoder", &T::invert_left_encoder, {}, "Left encoder counts backwards"},
      {"invert_right_encoder", &T::invert_right_encoder, {}, "Right encoder counts backwards"},
      {"swap_tracks",
       &T::swap_tracks,
       {},
       "Left and right track are connected the wrong way round"},
  }};
  return kKeys;
}

constexpr text::Range kSlopeDeg{-model::kSteepestDeg, model::kSteepestDeg},
    kAddedSlip{model::kLeastAddedSlip, model::kMostAddedSlip};

constexpr const char* kSlopesNote =
    "Slip that slopes add to that of level ground. Linear in between, held beyond the steepest "
    "one; downhill the negative of uphill if only uphill is given. Without any, the paper's table "
    "applies (model.slip_curve of the configuration).";

std::string slope_sections(const model::TrackParameters& model) {
  std::string text;
  for (const model::AddedSlip& row : std::span(model.added_slips).first(model.slopes))
    text += (text.empty() ? "\n" + text::toml_comment(kSlopesNote) : "\n") + "[[model.slope]]\n" +
            "slope_deg = " + text::toml_number(row.slope_rad * kDegPerRad) +
            "\nadded_left = " + text::toml_number(row.left) +
            "\nadded_right = " + text::toml_number(row.right) + "\n";
  return text;
}

void read_slopes(text::TomlTable& table, model::TrackParameters& model) {
  double last_deg = -HUGE_VAL;
  for (text::TomlTable row : table.tables("slope")) {
    if (model.slopes == model::kMaxSlopes)
      row.fail("slope_deg", "more than " + std::to_string(model::kMaxSlopes) +
                                " slopes; leave out some of 'model.slope'");
    const double slope_deg = row.required_number("slope_deg", kSlopeDeg);
    if (slope_deg == 0.0)
      row.fail("slope_deg", "'slope_deg' is 0, where slip_left and slip_right apply; leave it out");
    if (slope_deg <= last_deg)
      row.fail("slope_deg", "'slope_deg' is not above that of the slope before; sort them");
    last_deg = slope_deg;
    model.added_slips[model.slopes++] = {slope_deg * kRadPerDeg,
                                         row.required_number("added_left", kAddedSlip),
                                         row.required_number("added_right", kAddedSlip)};
  }
}

/// Constants of earlier versions, without which the others have other values.
constexpr std::array kGoneFromModel = {"x_icr_tight_shift_m", "turn_slip_tight"};
constexpr const char* kIdentifyAgain =
    "' is a constant that the model no longer has; delete it and identify the robot again "
    "(tp100d identify), or use the version of tp100 that wrote this file";

template <class T>
std::string section(const char* name, std::span<const text::Key<T>> keys, const T& values,
                    const text::Origins& origins = {}) {
  return "\n[" + std::string(name) + "]\n" + text::write_keys(keys, values, origins);
}

constexpr const char* kBaselinesNote =
    "\n# Simpler forms of the model, fitted to the same drives. The daemon does not drive with "
    "them;\n# reports show the error of each beside the error of the model.\n";

std::string baseline_sections(const Robot& robot) {
  std::string text;
  for (std::size_t i = 0; i < model::kBaselines.size(); ++i) {
    if (!robot.baselines[i]) continue;
    const model::ModelForm& form = model::kBaselines[i];
    const std::string name = "baselines." + std::string(form.key);
    const auto keys = form_keys(form);
    text += (text.empty() ? kBaselinesNote : "\n") +
            text::toml_comment(std::string(form.meaning) + ".") +
            section<model::TrackParameters>(name.c_str(), keys, *robot.baselines[i]).substr(1);
  }
  return text;
}

void read_baselines(text::TomlTable table, Robot& robot) {
  for (std::size_t i = 0; i < model::kBaselines.size(); ++i) {
    const model::ModelForm& form = model::kBaselines[i];
    if (form.fixed != nullptr) continue;
    const bool fitted = table.has(form.key);
    text::TomlTable values = table.table(form.key);
    if (!fitted) continue;
    const auto keys = form_keys(form);
    text::read_keys<model::TrackParameters>(values, keys,
                                            robot.baselines[i].emplace(form.only({})));
  }
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
  text::TomlTable variation = emulated.table("variation");
  text::TomlTable shear = emulated.table("shear");
  text::TomlTable motor = emulated.table("motor");
  text::TomlTable encoder = emulated.table("encoder");
  text::TomlTable imu = emulated.table("imu");
  text::TomlTable battery = emulated.table("battery");
  for (const std::string gone : kGoneFromModel)
    if (model.has(gone)) model.fail(gone, "'model." + gone + kIdentifyAgain);
  text::read_keys(model, model_keys(), robot.model);
  read_slopes(model, robot.model);
  robot.origins = text::read_origins(text, "model");
  read_baselines(root.table("baselines"), robot);
  text::read_keys(shape, shape_keys(), robot.shape);
  text::read_keys(drive, drive_keys(), robot.drive);
  text::read_keys(emulated, emulated_keys(), robot.emulated);
  text::read_keys(body, body_keys(), robot.emulated.body);
  text::read_keys(variation, variation_keys(), robot.emulated.variation);
  text::read_keys(shear, shear_keys(), robot.emulated.shear);
  text::read_keys(motor, motor_keys(), robot.emulated.motor);
  text::read_keys(encoder, encoder_keys(), robot.emulated.encoder);
  text::read_keys(imu, imu_keys(), robot.emulated.imu);
  text::read_keys(battery, battery_keys(), robot.emulated.battery);
  root.finish();
  if (robot.emulated.body.shoe_width_m >= robot.emulated.body.gauge_m)
    body.fail("shoe_width_m", "'emulated.body.shoe_width_m' must be below 'emulated.body.gauge_m'");
  if (std::abs(robot.shape.com_forward_m) >= robot.shape.axle_spacing_m / 2.0)
    shape.fail("com_forward_m", "'shape.com_forward_m' must lie between the axles");
  for (const model::ParameterRow& row : model::kTrackParameters)
    if (row.relative_to != nullptr && robot.model.*row.value != 0.0 &&
        robot.model.*row.value < 0.05)
      model.fail(row.key, "'model." + std::string(row.key) + "' must be 0 or at least 0.05 m");
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
         "\n# The daemon's model of this robot. It is identified by driving, never copied from "
         "[emulated].\n" +
         section("model", model_keys(), robot.model, robot.origins).substr(1) +
         slope_sections(robot.model) + baseline_sections(robot) +
         "\n# Size and centre of mass, as measured: they determine the robot's attitude on ramps "
         "and steps.\n" +
         section("shape", shape_keys(), robot.shape).substr(1) +
         "\n# Wiring and motor control; sent to the firmware when the daemon connects.\n" +
         section("drive", drive_keys(), robot.drive).substr(1) +
         "\n# Physics of an emulated robot of this kind; real robots and the daemon ignore this "
         "section.\n" +
         section("emulated", emulated_keys(), emulated).substr(1) +
         section("emulated.body", body_keys(), emulated.body) +
         section("emulated.variation", variation_keys(), emulated.variation) +
         section("emulated.shear", shear_keys(), emulated.shear) +
         section("emulated.motor", motor_keys(), emulated.motor) +
         section("emulated.encoder", encoder_keys(), emulated.encoder) +
         section("emulated.imu", imu_keys(), emulated.imu) +
         section("emulated.battery", battery_keys(), emulated.battery);
}

}  // namespace tp100::course
