#pragma once
// A thread with a queue of jobs that may wait, for a disk, a process or a port, so that no other
// thread has to. A thread that serves STOP, the operator or the service manager never touches a
// file itself: it posts a job here. Nothing that a job throws ends the program.

#include <chrono>
#include <condition_variable>
#include <deque>
#include <functional>
#include <mutex>
#include <string>
#include <thread>

namespace tp100 {

class Worker {
 public:
  using Job = std::function<void()>;
  /// Receives what a job threw, in one line: what, where, what to do.
  using Failed = std::function<void(const std::string& why)>;
  /// Receives why a request failed, in one line, or nothing; and its answer as JSON.
  using Answer = std::function<void(const std::string& why, const std::string& json)>;

  /// What is answered if too many jobs wait.
  static constexpr const char* kBusy = "the disk does not answer; try again later";

  /// `name`: of the thread, 15 characters at most. At most `most` jobs may wait besides the running
  /// one.
  explicit Worker(const char* name, std::size_t most = 64);
  /// Runs the waiting jobs, however long the disk takes.
  ~Worker();
  Worker(const Worker&) = delete;
  Worker& operator=(const Worker&) = delete;

  // Any thread; none of these waits for a disk.
  /// Runs `job` on the worker's thread, in the order of posting, and after it `failed`, there too,
  /// if the job throws. False: too many jobs are waiting, and neither is called.
  bool post(Job job, Failed failed);
  /// Answers a request with what `job` returns, or with why it failed; once, on the worker's
  /// thread, or on the caller's if too many jobs are waiting.
  void ask(const Answer& answer, std::function<std::string()> job);
  /// Waits until no job is waiting or running; false: `deadline` passed first.
  bool idle_by(std::chrono::steady_clock::time_point deadline);
  /// Runs `job` on the caller's thread, and `failed` after it if it throws; throws nothing itself.
  /// For jobs that wait for something else than a disk.
  static void run_here(const Job& job, const Failed& failed);

 private:
  struct Posted {
    Job job;
    Failed failed;
  };
  void run();

  const std::size_t most_;
  std::mutex mutex_;  // never held while a job runs
  std::condition_variable some_, idle_;
  std::deque<Posted> jobs_;
  bool busy_ = false, ending_ = false;
  std::thread thread_;
};

}  // namespace tp100
