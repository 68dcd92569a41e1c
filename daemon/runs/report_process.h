#pragma once
// Runs a program beside the real-time loop, one at a time: without a copy of this process's locked
// memory, which fork() would make, and without its open files.

#include <chrono>
#include <mutex>
#include <string>
#include <vector>

namespace tp100::runs {

class ReportProcess {
 public:
  /// Runs `arguments[0]` with the rest as its arguments, at the lowest priority, and waits. Returns
  /// why it failed: the last line that it wrote on standard error; empty: it ended with status 0.
  /// Killed after `limit`. What it prints goes to the file `output`. One thread.
  std::string run(const std::vector<std::string>& arguments, std::chrono::milliseconds limit,
                  const std::string& output = "/dev/null");
  /// Kills what is running; from now on nothing is run. Any thread.
  void stop();

 private:
  std::mutex mutex_;  // guards what follows
  int pid_ = 0;       // 0: none
  bool stopped_ = false;
};

}  // namespace tp100::runs
