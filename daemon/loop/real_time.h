#pragma once
// Privileges of the real-time thread: each is requested, checked and reported; none is required.

#include <string>
#include <vector>

namespace tp100::loop {

/// One requested privilege.
struct Grant {
  std::string what;  ///< e.g. "SCHED_FIFO 80"
  bool granted = false;
  std::string fix;  ///< how to get it; empty if granted
};

/// For the whole process.
struct ProcessRequest {
  bool lock_memory = true;
  bool hold_cpu_latency = true;  ///< keep the processor out of deep sleep: halves the wake-up time
};

/// For one thread.
struct ThreadRequest {
  int priority = 80;  ///< SCHED_FIFO; 0: ordinary scheduling
  int cpu = -1;       ///< -1: any
};

/// Requests on construction; releases the processor latency on destruction.
class RealTimeProcess {
 public:
  explicit RealTimeProcess(const ProcessRequest& request);
  ~RealTimeProcess();
  RealTimeProcess(const RealTimeProcess&) = delete;
  RealTimeProcess& operator=(const RealTimeProcess&) = delete;

  const std::vector<Grant>& grants() const { return grants_; }

 private:
  std::vector<Grant> grants_;
  int latency_fd_ = -1;
};

/// For the calling thread; also sets its timer slack to 1 ns and touches its stack.
std::vector<Grant> apply_to_this_thread(const ThreadRequest& request);

}  // namespace tp100::loop
