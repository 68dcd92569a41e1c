#pragma once
// A thread that waits for disks so that nobody else has to. A thread that serves STOP, the operator
// or the service manager touches no file itself: it posts a job here.

#include <chrono>
#include <condition_variable>
#include <deque>
#include <functional>
#include <mutex>
#include <thread>

namespace tp100::record {

class Worker {
 public:
  using Job = std::function<void()>;

  /// At most `most` jobs wait for the one that runs.
  explicit Worker(std::size_t most = 64);
  /// Runs the jobs that wait, however long the disk takes.
  ~Worker();
  Worker(const Worker&) = delete;
  Worker& operator=(const Worker&) = delete;

  // Any thread.
  /// Runs `job` on the worker's thread, in the order of posting; it must not throw. Never waits for
  /// a disk; false: too many jobs wait, this one is not taken.
  bool post(Job job);
  /// Waits until no job waits or runs; false: not before `deadline`.
  bool idle_by(std::chrono::steady_clock::time_point deadline);

 private:
  void run();

  const std::size_t most_;
  std::mutex mutex_;  // never held while a job runs
  std::condition_variable some_, idle_;
  std::deque<Job> jobs_;
  bool busy_ = false, ending_ = false;
  std::thread thread_;
};

}  // namespace tp100::record
