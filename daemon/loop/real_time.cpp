#include "loop/real_time.h"

#include <fcntl.h>
#include <pthread.h>
#include <sched.h>
#include <sys/mman.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <unistd.h>

#include <array>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <string>
#include <string_view>
#include <system_error>

namespace tp100::loop {
namespace {

// With less, locking succeeds at first, and later threads and buffers fail.
constexpr rlim_t kEnoughLockable = 256U << 20U;
constexpr std::size_t kStack = 1U << 20U;
constexpr std::size_t kStackTouched = 64U << 10U;

// Root needs no such limit, unless the capability was removed.
std::string by_limit(const std::string& limit, const std::string& capability) {
  if (::geteuid() == 0) return "start the container with --cap-add " + capability;
  return "echo \"$USER - " + limit +
         "\" | sudo tee -a /etc/security/limits.d/tp100.conf, then log in again";
}

// A thread's stack is locked as a whole, and the usual one is 8 MB.
void use_small_stacks() {
  pthread_attr_t attributes;
  if (::pthread_attr_init(&attributes) != 0) return;
  if (::pthread_attr_setstacksize(&attributes, kStack) == 0)
    ::pthread_setattr_default_np(&attributes);
  ::pthread_attr_destroy(&attributes);
}

Privilege lock_memory() {
  Privilege privilege{"memory locked", false, by_limit("memlock unlimited", "ipc_lock")};
  rlimit limit{};
  const bool enough = ::getrlimit(RLIMIT_MEMLOCK, &limit) == 0 && limit.rlim_cur >= kEnoughLockable;
  if (!enough && ::geteuid() != 0) return privilege;
  use_small_stacks();
  privilege.granted = ::mlockall(MCL_CURRENT | MCL_FUTURE) == 0;
  return privilege;
}

Privilege fifo(int priority) {
  Privilege privilege{"SCHED_FIFO " + std::to_string(priority), false,
                      by_limit("rtprio 90", "sys_nice")};
  sched_param wanted{};
  wanted.sched_priority = priority;
  ::pthread_setschedparam(::pthread_self(), SCHED_FIFO, &wanted);
  int policy = SCHED_OTHER;
  sched_param got{};
  ::pthread_getschedparam(::pthread_self(), &policy, &got);
  privilege.granted = policy == SCHED_FIFO && got.sched_priority == priority;
  return privilege;
}

Privilege affinity(int cpu) {
  Privilege privilege{"processor " + std::to_string(cpu), false,
                      "set loop.cpu to one that taskset -pc $$ lists"};
  if (cpu >= CPU_SETSIZE) return privilege;
  cpu_set_t wanted;
  CPU_ZERO(&wanted);
  CPU_SET(static_cast<std::size_t>(cpu), &wanted);
  ::pthread_setaffinity_np(::pthread_self(), sizeof wanted, &wanted);
  cpu_set_t got;
  CPU_ZERO(&got);
  ::pthread_getaffinity_np(::pthread_self(), sizeof got, &got);
  privilege.granted = CPU_EQUAL(&wanted, &got);
  return privilege;
}

void touch_stack() {
  std::array<volatile char, kStackTouched> stack;
  for (std::size_t i = 0; i < stack.size(); i += 1024) stack[i] = 0;
}

/// Whether /proc/PID is of an unbound worker of the kernel. Any program may have such a name, but
/// only a kernel thread is a child of kthreadd.
bool is_unbound_worker(const std::filesystem::path& process) {
  std::string text;
  if (!std::getline(std::ifstream(process / "comm"), text) || !text.starts_with("kworker/u"))
    return false;
  std::getline(std::ifstream(process / "stat"), text);
  const std::size_t name_end = text.rfind(')');
  return name_end != std::string::npos &&
         std::string_view(text).substr(name_end, 6).ends_with(" 2 ");
}

/// Returns how many unbound workers are raised: none without permission, or in a container that
/// does not show them.
int raise_kernel_workers() {
  const sched_param wanted{.sched_priority = kBelowTheLoop};
  int raised = 0;
  std::error_code error;
  for (const auto& entry : std::filesystem::directory_iterator("/proc", error)) {
    const std::string name = entry.path().filename();
    if (name.find_first_not_of("0123456789") != std::string::npos) continue;
    if (!is_unbound_worker(entry.path())) continue;
    if (::sched_setscheduler(std::stoi(name), SCHED_FIFO, &wanted) == 0) ++raised;
  }
  return raised;
}

void resolve(Privilege& privilege) {
  if (privilege.granted) privilege.fix.clear();
}

}  // namespace

RealTimeProcess::RealTimeProcess(const ProcessRequest& request) {
  if (request.lock_memory) privileges_.push_back(lock_memory());
  if (request.hold_cpu_latency) {
    latency_ = Descriptor(::open("/dev/cpu_dma_latency", O_WRONLY | O_CLOEXEC));
    const std::int32_t zero = 0;
    const bool held = latency_ && ::write(latency_.get(), &zero, sizeof zero) == sizeof zero;
    privileges_.push_back({"processor kept awake (/dev/cpu_dma_latency)", held,
                           R"(echo KERNEL==\"cpu_dma_latency\",OWNER=\"$USER\" | )"
                           "sudo tee /etc/udev/rules.d/90-tp100.rules && sudo udevadm trigger "
                           "/dev/cpu_dma_latency"});
  }
  workers_raised_ = request.raise_kernel_workers && raise_kernel_workers() > 0;
  if (workers_raised_)
    privileges_.push_back(
        {"kernel workers that carry serial data: SCHED_FIFO " + std::to_string(kBelowTheLoop),
         true,
         {}});
  for (Privilege& privilege : privileges_) resolve(privilege);
}

void RealTimeProcess::keep() const {
  if (workers_raised_) raise_kernel_workers();
}

std::vector<Privilege> apply_to_this_thread(const ThreadRequest& request) {
  std::vector<Privilege> privileges;
  // By default, ordinary threads are woken up to 50 us late.
  ::prctl(PR_SET_TIMERSLACK, 1UL);
  if (request.cpu >= 0) privileges.push_back(affinity(request.cpu));
  if (request.priority > 0) privileges.push_back(fifo(request.priority));
  for (Privilege& privilege : privileges) resolve(privilege);
  touch_stack();
  return privileges;
}

}  // namespace tp100::loop
