#pragma once
// A recorded run as plain data, for reports: what was estimated, what was true where that is known,
// how the loop and the link did, what happened. Memory is bounded whatever the recording holds.

#include <array>
#include <cstdint>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "core/steering.h"
#include "course/course.h"
#include "course/robot.h"
#include "messages/figures.h"
#include "record/recording.h"
#include "report/run_result.h"

namespace tp100::report {

/// What was driven; from the files in the recording.
struct RunSubject {
  std::shared_ptr<const course::Course> course;  ///< null: none
  course::Robot robot{};
  Steering steering = Steering::kOdometry;
  double rate_hz = 200.0;
};

/// What belongs to a track point besides its poses. Not-a-number: not known, or nonsense.
struct RunMoment {
  double slip_left = 0.0, slip_right = 0.0;  ///< in use by the model
  double left_mps = 0.0, right_mps = 0.0;    ///< belts
  double cross_track_m = 0.0;                ///< steering pose against the path, left positive
  double heading_error_rad = 0.0;            ///< desired - steering
  double jitter_us = 0.0;                    ///< this step against the period
  Pose steering_world{};                     ///< steering pose in the course's world
  bool truth_known = false;
};

/// Steering pose against the path: what the controller believed, not what was true.
struct BelievedErrors {
  double max_cross_track_m = 0.0, rms_cross_track_m = 0.0, max_heading_error_rad = 0.0;
};

struct RunEvent {
  double t_s = 0.0;  ///< as the points; negative before the run
  std::string text = {}, remedy = {};
  bool bad = false;
};

/// The last run of a recording; all of the recording, if nothing ran.
struct RecordedRun {
  std::string path;                                        ///< of the file
  std::map<std::string, std::string> facts;                ///< program, version, ...
  std::vector<std::pair<std::string, std::string>> files;  ///< name and text, as they were loaded
  RunSubject subject{};
  bool whole = true;  ///< false: the file was cut off

  RunResult result{};              ///< `truth` of a point is only set if has_truth
  bool has_truth = false;          ///< then every point has it
  std::vector<RunMoment> moments;  ///< one for each point
  std::uint64_t every = 1;         ///< a point is here of every so many; 1: all
  BelievedErrors believed{};       ///< of all steps

  std::uint64_t runs = 0;  ///< in the recording
  std::uint64_t steps = 0, missing_steps = 0;
  std::uint64_t implausible = 0;     ///< points left out because of their numbers
  messages::Durations jitter{};      ///< |time between two steps - period|
  messages::Durations sample_age{};  ///< of the newest sample at each step
  std::array<std::uint64_t, messages::kLatenessEdgesUs.size() + 1> jitter_counts{};
  std::vector<RunEvent> events;
  std::uint64_t more_events = 0;  ///< that are not listed
};

/// Reads all of `recording`. Throws SetupError.
RecordedRun read_run(const record::Recording& recording, const RunSubject& subject);

/// Pose that steered, of a point.
const Pose& steering_pose(const RecordedRun& run, const TrackPoint& point);

}  // namespace tp100::report
