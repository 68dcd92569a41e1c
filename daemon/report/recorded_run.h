#pragma once
// A recorded run as plain data, for reports: estimates, truth where it is known, performance of
// loop and link, events. Memory is bounded whatever the recording contains.

#include <cstdint>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "core/estimates.h"
#include "course/course.h"
#include "course/robot_file.h"
#include "messages/figures.h"
#include "record/recording.h"
#include "report/run_monitor.h"
#include "report/run_result.h"

namespace tp100::report {

/// What people noted about the run beside its recording.
struct RunNotes {
  std::string name, tags, note;
  std::vector<RunEvent>
      marks;  ///< their at_ns counts from the recording's clock, as t_s in messages
};

/// What was driven, from the files in the recording and beside it.
struct RecordedContext {
  std::shared_ptr<const course::Course> course;  ///< null: none
  course::Robot robot{};
  PoseSource steering = PoseSource::kOdometry;
  double rate_hz = 200.0;
  double turning_threshold_radps = 0.05;  ///< of the model's slip angle
  RunNotes notes{};
};

/// Data of a trajectory point besides its poses. Not-a-number: unknown or invalid.
struct RunMoment {
  double slip_left = 0.0, slip_right = 0.0;  ///< in use by the model
  double cross_track_m = 0.0;                ///< steering pose against the path, left positive
  double jitter_us = 0.0;                    ///< this step against the period
  Pose steering_world{};                     ///< steering pose in the course's world
  bool truth_known = false;
};

/// Steering pose against the path: the controller's own estimate, not the truth.
struct EstimatedErrors {
  double max_cross_track_m = 0.0, rms_cross_track_m = 0.0, max_heading_error_rad = 0.0;
};

/// The last run of a recording; the whole recording, if no run began.
struct RecordedRun {
  std::string path;                                        ///< of the file
  std::map<std::string, std::string> facts;                ///< program, version, ...
  std::vector<std::pair<std::string, std::string>> files;  ///< name and text, as they were loaded
  RecordedContext run_context{};
  std::int64_t written_unix_s = 0;  ///< date of the file; 0: not known
  std::int64_t driven_unix_s = 0;   ///< when the run began; 0: in virtual time
  bool whole = true;                ///< false: the file was cut off

  RunResult result{};              ///< `truth` of a point is only set if has_truth
  bool has_truth = false;          ///< every point has it
  std::vector<RunMoment> moments;  ///< one for each point
  std::uint64_t every = 1;         ///< one of this many points is kept; 1: all
  EstimatedErrors estimated{};     ///< over all steps

  std::uint64_t runs = 0;  ///< in the recording
  std::uint64_t steps = 0, missing_steps = 0;
  std::uint64_t implausible = 0;     ///< points left out because of impossible values
  messages::Durations jitter{};      ///< |time between two steps - period|
  messages::Durations sample_age{};  ///< of the newest sample at each step
  /// From the step whose pose the external world's newest answer answers, to each step; none: count
  /// 0.
  messages::Durations world_age{};
  messages::LatenessCounts jitter_counts{};
  std::vector<RunEvent> events;
  std::uint64_t more_events = 0;  ///< not listed
};

/// Whether the steps kept to a clock: in virtual time every step is exactly a period.
inline bool in_real_time(const RecordedRun& run) { return run.jitter.max_us > 0.0; }

/// Reads all of `recording`. Throws UserError.
RecordedRun read_run(const record::Recording& recording, const RecordedContext& run_context);

}  // namespace tp100::report
