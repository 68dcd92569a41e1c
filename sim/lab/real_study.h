#pragma once
// The model on measured data of real robots: `tp100-lab reproduce --part real`. Each form is fitted
// to one half of a robot's motions and judged on the other.

#include <string>
#include <utility>
#include <vector>

#include "report/html_page.h"
#include "sim/lab/real_data.h"
#include "sim/lab/real_fit.h"
#include "sim/lab/study.h"

namespace tp100::sim {

// Names of forms and figures.
inline constexpr const char* kNoSlip = "no slip";
inline constexpr const char* kPaperFitted = "eqs 1-5, fitted";
inline constexpr const char* kPaperIcr = "eqs 1-5, x_icr";
inline constexpr const char* kExtendedFitted = "extended, fitted";
inline constexpr const char* kBothSpeeds = "slip by both speeds";
inline constexpr const char* kPaperGyro = "eqs 1-5, yaw by the gyro";
inline constexpr const char* kBothSpeedsGyro = "both speeds, yaw by the gyro";
inline constexpr const char* kYawRate = "yaw rate, rms [% of its rms]";
inline constexpr const char* kSpeed = "speed, rms [% of its rms]";
inline constexpr const char* kLateral = "lateral speed, rms [cm/s]";
inline constexpr const char* kPosition = "position, mean [% of path]";
inline constexpr const char* kYaw = "yaw, mean [deg]";

/// Results of one form in all splits.
struct RealForm {
  std::string name{};
  std::vector<std::vector<double>> figures{};  ///< [split][figure]
  SlipFit fit{};                               ///< to the fitted half of the first split
  /// For each motion judged in the first split: right minus left track speed [m/s] and error of the
  /// yaw rate [rad/s]; for windows the means.
  std::vector<std::pair<double, double>> yaw_errors{};
};

struct RealStudy {
  std::string robot;
  int motions = 0;
  std::vector<std::string> splits;   ///< what is fitted; the rest is judged
  std::vector<std::string> figures;  ///< name and unit; other splits have only the first
  std::vector<RealForm> forms;

  /// Figure of a form in the first split; NaN if there is none with these names.
  double figure(const std::string& form, const std::string& figure) const;
};

/// Fits and judges every form on `robot`. Pure.
RealStudy study_real(const RealRobot& robot);

/// The figures of the first split with their limits.
CourseStudy judged(const RealStudy& study);

/// Section of the page about all robots.
void write_real(report::HtmlPage& page, const std::vector<RealStudy>& studies);
/// The same tables for a terminal.
std::string real_text(const std::vector<RealStudy>& studies);

}  // namespace tp100::sim
