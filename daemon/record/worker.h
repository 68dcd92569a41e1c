#pragma once
// A thread that waits for disks, so that no other thread has to. A thread that serves STOP, the
// operator or the service manager never touches a file itself: it posts a job here.

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

  /// At most `most` jobs may wait besides the running one.
  explicit Worker(std::size_t most = 64);
  /// Runs the waiting jobs, however long the disk takes.
  ~Worker();
  Worker(const Worker&) = delete;
  Worker& operator=(const Worker&) = delete;

  // Any thread.
  /// Runs `job` on the worker's thread, in the order of posting; it must not throw. Never waits for
  /// a disk; false: too many jobs are waiting, and this one is rejected.
  bool post(Job job);
  /// Waits until no job is waiting or running; false: `deadline` passed first.
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
