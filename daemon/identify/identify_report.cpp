#include "identify/identify_report.h"

#include <array>
#include <cmath>
#include <cstdarg>
#include <cstdio>

#include "core/angle.h"
#include "text/key.h"

namespace tp100::identify {
namespace {

// Where the head of an identified file begins; what follows is written anew each time.
constexpr const char* kIdentified = "Identified";

[[gnu::format(printf, 1, 2)]] std::string format(const char* pattern, ...) {
  std::array<char, 300> text{};
  va_list arguments;
  va_start(arguments, pattern);
  std::vsnprintf(text.data(), text.size(), pattern, arguments);
  va_end(arguments);
  return text.data();
}

/// The field of a robot file that holds a parameter. SI.
double& field(course::ModelValues& m, Parameter parameter) {
  switch (parameter) {
    case Parameter::kSlipLeft:
      return m.slip_left;
    case Parameter::kSlipRight:
      return m.slip_right;
    case Parameter::kSlipAngleStraight:
      return m.slip_angle_straight_rad;
    case Parameter::kSlipAngleTurning:
      return m.slip_angle_turning_rad;
    case Parameter::kWheelbase:
      return m.wheelbase_m;
    case Parameter::kXIcr:
      return m.x_icr_m;
    case Parameter::kWheelbaseTight:
      return m.wheelbase_tight_m;
    case Parameter::kXIcrTightShift:
      return m.x_icr_tight_shift_m;
    case Parameter::kWheelbaseSpin:
      return m.wheelbase_spin_m;
    case Parameter::kXIcrSpinShift:
      return m.x_icr_spin_shift_m;
    case Parameter::kTurnSlip:
      return m.turn_slip;
    case Parameter::kTurnSlipTight:
      return m.turn_slip_tight;
    case Parameter::kGyroScale:
      break;
  }
  return m.gyro_scale;
}

std::string residual(const Fit& fit) {
  return format("%.2f cm and %.2f deg rms, %.2f cm at most", fit.rms_m * 100.0,
                fit.rms_rad * kDegPerRad, fit.max_m * 100.0);
}

std::string with_date(const std::string& date) { return date.empty() ? "" : " on " + date; }

bool has_pictures(const Fit& fit) {
  for (const RunFit& run : fit.runs)
    if (run.pictures > 0) return true;
  return false;
}

std::string table(const Fit& fit, const course::Robot& base) {
  course::ModelValues before = base.model;
  std::string text = "                              found    95 % interval     before\n";
  for (std::size_t i = 0; i < kParameters; ++i) {
    const ParameterKey& key = kParameterKeys[i];
    const Estimate& estimate = fit.estimates[i];
    const double was = field(before, static_cast<Parameter>(i)) / key.si;
    if (estimate.found) {
      text += format("  %-24s %9.4f      +- %7.4f  %9.4f\n", key.key, estimate.value / key.si,
                     estimate.half_interval / key.si, was);
    } else {
      text += format("  %-24s  not seen                 %9.4f\n", key.key, was);
    }
  }
  return text;
}

std::string run_lines(const Fit& fit) {
  std::string text =
      "  run                                     pictures   rejected   rms [cm]"
      "   max [cm]  rms [deg]\n";
  for (const RunFit& run : fit.runs) {
    if (run.pictures == 0) {
      text += format("  %-40s by hand\n", run.name.c_str());
    } else {
      text += format("  %-40s %7zu    %7zu    %7.2f    %7.2f    %7.2f\n", run.name.c_str(),
                     run.pictures, run.rejected, run.rms_m * 100.0, run.max_m * 100.0,
                     run.rms_rad * kDegPerRad);
    }
  }
  return text;
}

/// Of the keys that eqs 1-5 have, as lines of a robot file.
std::string plain_values(const Fit& plain) {
  std::string text;
  for (std::size_t i = 0; i <= index(Parameter::kWheelbase); ++i) {
    const ParameterKey& key = kParameterKeys[i];
    text += format("  %s = %.5f\n", key.key, plain.estimates[i].value / key.si);
  }
  return text;
}

}  // namespace

Belief belief_of(const course::Robot& robot, double turning_threshold_radps) {
  const course::ModelValues& m = robot.model;
  return {.tracks = {.slip_left = m.slip_left,
                     .slip_right = m.slip_right,
                     .slip_angle_straight_rad = m.slip_angle_straight_rad,
                     .slip_angle_turning_rad = m.slip_angle_turning_rad,
                     .turning_threshold_radps = turning_threshold_radps,
                     .wheelbase_m = m.wheelbase_m,
                     .x_icr_m = m.x_icr_m,
                     .wheelbase_tight_m = m.wheelbase_tight_m,
                     .x_icr_tight_shift_m = m.x_icr_tight_shift_m,
                     .wheelbase_spin_m = m.wheelbase_spin_m,
                     .x_icr_spin_shift_m = m.x_icr_spin_shift_m,
                     .turn_slip = m.turn_slip,
                     .turn_slip_tight = m.turn_slip_tight},
          .gyro_scale = m.gyro_scale,
          .counts_per_metre = robot.drive.counts_per_metre};
}

std::string identify_report(const Identification& found, const course::Robot& base) {
  std::string text =
      format("robot %s, %zu runs\n\n", base.name.c_str(), found.extended.runs.size());
  text += table(found.extended, base);
  text += "\n" + run_lines(found.extended) + "\n";
  if (has_pictures(found.extended)) {
    text += "best-fit residual against the camera, whose noise is in it:\n";
    text += "  eqs 1-5                                  " + residual(found.plain) + "\n";
    text += "  with turning centre and tight turns      " + residual(found.extended) + "\n";
    text += "eqs 1-5 alone, all other keys of [model] at 0:\n" + plain_values(found.plain);
    text += format("camera's time stamps late by %.1f ms\n", found.extended.camera_late_s * 1e3);
  }
  text += format("condition number %.1f\n", found.extended.condition);
  for (const auto& [a, b] : found.extended.confused)
    text += format("warning: these runs cannot separate %s and %s; add runs in which they differ\n",
                   kParameterKeys[index(a)].key, kParameterKeys[index(b)].key);
  for (std::size_t i = 0; i < kParameters; ++i)
    if (!found.extended.estimates[i].found)
      text +=
          format("warning: these runs do not show %s; it stays as it was\n", kParameterKeys[i].key);
  return text;
}

course::Robot identified_robot(const Identification& found, const course::Robot& base,
                               const std::string& date) {
  course::Robot robot = base;
  for (std::size_t i = 0; i < kParameters; ++i) {
    const Estimate& estimate = found.extended.estimates[i];
    if (!estimate.found) continue;
    const ParameterKey& key = kParameterKeys[i];
    const double rounded = std::round(estimate.value / key.si * 1e5) / 1e5;
    field(robot.model, static_cast<Parameter>(i)) = rounded * key.si;
    robot.origins[key.key] =
        format("identify%s: +- %.5f (95 %%), %zu runs", with_date(date).c_str(),
               estimate.half_interval / key.si, found.extended.runs.size());
  }
  return robot;
}

std::string identified_note(const Identification& found, const std::string& base_note,
                            const std::string& date) {
  std::string note = base_note.substr(0, base_note.find(kIdentified));
  while (note.ends_with(' ')) note.pop_back();
  if (!note.empty()) note += " ";
  note += kIdentified + with_date(date) + " from the runs";
  for (std::size_t i = 0; i < found.extended.runs.size(); ++i)
    note += (i == 0 ? " " : ", ") + text::one_line(found.extended.runs[i].name);
  note += ".";
  if (has_pictures(found.extended))
    note += " Best-fit residual of eqs 1-5 against the camera: " + residual(found.plain) +
            "; with turning centre and tight turns: " + residual(found.extended) + ".";
  return note;
}

}  // namespace tp100::identify
