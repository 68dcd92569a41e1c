#pragma once
// Studies in processes of their own: ODE's solver has one random number generator for a process, so
// that threads would wait for each other.

#include <sys/types.h>

#include <functional>
#include <vector>

#include "sim/lab/study.h"

namespace tp100::sim {

/// Runs jobs in the background, as many at a time as there are processors, from construction on.
/// All of them end with the process that made this.
class StudyProcesses {
 public:
  using Job = std::function<std::vector<CourseStudy>()>;

  /// Call it without other threads. Throws std::system_error.
  explicit StudyProcesses(const std::vector<Job>& jobs);
  ~StudyProcesses();
  StudyProcesses(const StudyProcesses&) = delete;
  StudyProcesses& operator=(const StudyProcesses&) = delete;

  /// Waits for all jobs; their studies in the jobs' order, without CourseStudy::shown. Call it
  /// once. Throws what a job threw, as UserError or std::runtime_error.
  std::vector<CourseStudy> results();

 private:
  void end();

  std::vector<int> files_;  ///< one for each job, for its result
  pid_t runner_ = -1;       ///< the parent of the jobs' processes; -1: none, or waited for
};

}  // namespace tp100::sim
