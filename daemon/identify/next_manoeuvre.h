#pragma once
// Identification that drives itself: of candidate manoeuvres that stay inside a fence the one that
// narrows the parameters' intervals most for each second of driving, until all are narrow enough.
// What a manoeuvre brings is the information that the fit itself would take from it, driven as the
// present parameters predict.

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "core/pose.h"
#include "course/bundled_files.h"
#include "course/course.h"
#include "course/goal.h"
#include "identify/identify.h"

namespace tp100::identify {

struct AutoSettings {
  bool camera = true;    ///< sees the drives; else each end is measured from its start by hand
  double narrow = 1.0;   ///< goal of every half interval, in parts of the error of the table of
                         ///< parameters that is harmless to a pose
  double max_s = 240.0;  ///< of driving; then it ends with intervals as they are
  IdentifySettings fit{};
};

/// The goals of the half intervals, in the order of the table of parameters. SI.
std::array<double, model::kTrackParameters.size()> interval_goals(
    const model::TrackParameters& tracks, double narrow);

/// How far an identification has come.
struct AutoProgress {
  std::size_t manoeuvres = 0;
  double driving_s = 0.0;      ///< while the tracks moved
  std::size_t widest = 0;      ///< row of the table: the interval that exceeds its goal most ...
  double half_interval = 0.0;  ///< ... its half width
  double goal = 0.0;
  bool narrow = false;  ///< all intervals are
};

/// Chooses, takes the drives and fits. Deterministic; pure.
class NextManoeuvre {
 public:
  /// `area`: a course; its fence holds every manoeuvre, and the robot is put at its start first.
  /// Throws UserError for a bad file.
  NextManoeuvre(const Prior& base, const course::TextFile& area, const AutoSettings& settings = {});

  /// The course to drive next, from where the camera last saw the robot, without a camera from the
  /// start of the area. Nothing: all intervals are narrow, the time is over, or no manoeuvre
  /// narrows one that is too wide. Throws UserError: no manoeuvre fits into the fence from there.
  std::optional<course::OtherPath> choose() const;
  /// The file of that course.
  course::TextFile course_of(const course::OtherPath& manoeuvre) const {
    return course::course_along(area_file_, manoeuvre);
  }
  /// A drive of the chosen manoeuvre, with camera poses or hand measurements. Throws UserError as
  /// identify() does.
  void take(RecordedDrive drive);

  AutoProgress progress() const;
  const std::vector<RecordedDrive>& drives() const { return drives_; }
  /// The present values, within the ranges of a robot file.
  model::TrackParameters tracks() const;

 private:
  struct Prediction;
  Prediction predict(const course::OtherPath& manoeuvre) const;
  struct Clearance;
  bool fits(const std::vector<Pose>& poses, const Clearance& clearance) const;
  std::optional<course::OtherPath> best_within(const Clearance& clearance, bool& any) const;

  Prior base_;
  course::TextFile area_file_;
  course::Course area_;
  AutoSettings settings_;
  std::vector<RecordedDrive> drives_;
  std::vector<FittedRun> runs_;
  ModelFit fit_;
  Intervals intervals_;  // of the fit
  Pose here_;
  double driving_s_ = 0.0;
};

/// One line for the terminal: manoeuvre, widest interval and its goal, seconds so far.
std::string progress_line(const AutoProgress& progress);
/// The same of the end: what it took, or what stayed too wide.
std::string end_line(const AutoProgress& progress);

}  // namespace tp100::identify
