#include "loop/fixed_rate_loop.h"

#include <pthread.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <string>
#include <system_error>

#include "core/clock.h"
#include "core/error.h"

namespace tp100::loop {
namespace {

// Unwritten output older than this is stale and dropped.
constexpr HostNs kStuckNs = 50 * kNsPerMs;
constexpr HostNs kShutDownLimitNs = 300 * kNsPerMs;
// Shortest time between two reads while waiting: limits the load that a flooding peer can cause.
constexpr HostNs kPromptSpacingNs = 50 * kNsPerUs;
constexpr HostNs kRobotSpacingNs = 200 * kNsPerUs;

void add(std::atomic<std::uint64_t>& counter, std::uint64_t n) {
  counter.store(counter.load(std::memory_order_relaxed) + n, std::memory_order_relaxed);
}

bool temporary(int error) { return error == EAGAIN || error == EWOULDBLOCK || error == EINTR; }

}  // namespace

FixedRateLoop::FixedRateLoop(const LoopSettings& settings, LoopClient& loop_client)
    : settings_(settings), client_(loop_client), port_wait_(settings.period_ns / 2) {}

FixedRateLoop::~FixedRateLoop() {
  request_stop();
  join();
}

void FixedRateLoop::start() {
  try {
    thread_ = std::thread([this] {
      ::pthread_setname_np(::pthread_self(), "loop");
      privileges_ = apply_to_this_thread(settings_.thread);
      ready_.store(true, std::memory_order_release);
      run();
      ended_.store(true, std::memory_order_release);
    });
  } catch (const std::system_error& error) {
    throw UserError(std::string("no thread for the real-time loop (") + error.what() +
                    "); raise the memory lock limit or set loop.lock_memory = false");
  }
  while (!ready_.load(std::memory_order_acquire)) sleep_until(monotonic_now() + kNsPerMs);
}

void FixedRateLoop::join() {
  if (thread_.joinable()) thread_.join();
}

void FixedRateLoop::run() {
  Schedule schedule(settings_.period_ns, monotonic_now());
  HostNs stopping_since = 0;
  for (;;) {
    adopt();
    const bool fresh = wait(schedule);
    after_write();
    HostNs now = monotonic_now();
    const HostNs began = now;
    last_cycle_ns_ = began;
    if (!fresh) statistics_.lateness.add(now - schedule.deadline());
    if (settings_.robot_paced && !fresh) add(statistics_.frame_timeouts, 1);

    if (stop_.load(std::memory_order_relaxed)) {
      if (stopping_since == 0) stopping_since = now;
      if (client_.shut_down(now) || now - stopping_since > kShutDownLimitNs) break;
    }
    if (port_.fd >= 0 && !fresh) read(now);
    client_.step(now);
    const HostNs stepped = monotonic_now();
    statistics_.compute.add(stepped - now);
    if (port_.fd >= 0) write(stepped);
    client_.wrote(now);
    pending_ns_ = now;
    cycle_ns_ = monotonic_now() - began;
    // The kernel's worker that transmits the answer may need this processor.
    if (!settings_.robot_paced || port_.fd < 0 || client_.expects_reply(now)) after_write();

    add(statistics_.cycles, 1);
    std::uint64_t missed = 0;
    if (settings_.robot_paced) {
      missed = static_cast<std::uint64_t>(cycle_ns_ / settings_.period_ns);
      schedule.restart(began, settings_.period_ns + settings_.period_ns / 2);
    } else {
      missed = schedule.advance(monotonic_now());
    }
    if (missed > 0) {
      add(statistics_.overruns, 1);
      add(statistics_.missed, missed);
    }
  }
  if (port_.fd >= 0) client_.closed(monotonic_now());
}

// Does the cycle's deferred work, at the latest before the next cycle begins.
void FixedRateLoop::after_write() {
  if (pending_ns_ == 0) return;
  const HostNs began = monotonic_now();
  client_.after_write(pending_ns_);
  if (client_.take_port_drop() && port_.fd >= 0) lose(PortEnd::kSilent, 0, pending_ns_);
  pending_ns_ = 0;
  statistics_.work.add(cycle_ns_ + monotonic_now() - began);
}

void FixedRateLoop::adopt() {
  if (port_.fd >= 0 || !offered_.pop(port_)) return;
  port_wait_.watch(port_.fd);
  stuck_since_ns_ = 0;
  client_.opened(monotonic_now());
}

// True if a sample of the robot began the cycle. However many samples arrive, cycles are at least
// half a period apart.
bool FixedRateLoop::wait(Schedule& schedule) {
  const HostNs wake = schedule.deadline() - (settings_.robot_paced ? 0 : settings_.spin_ns);
  const HostNs earliest = last_cycle_ns_ + settings_.period_ns / 2;
  bool sample = false;
  for (HostNs now = monotonic_now(); now < wake; now = monotonic_now()) {
    if (sample && now >= earliest) return true;
    const bool prompt = client_.expects_reply(now);
    if (port_.fd < 0 || !(settings_.robot_paced || prompt)) {
      sleep_until(wake);
      break;
    }
    const bool readable = sample || port_wait_.readable(wake);
    after_write();
    if (!readable || port_.fd < 0) continue;
    sample = (read(now) || sample) && settings_.robot_paced;
    if (sample && now >= earliest) return true;
    sleep_until(std::min(wake, now + (prompt ? kPromptSpacingNs : kRobotSpacingNs)));
  }
  spin_until(schedule.deadline());
  return sample;
}

// One bounded read. True if it contained a sample; `now` becomes the time right after it.
bool FixedRateLoop::read(HostNs& now) {
  if (!port_wait_.may_read()) return false;
  std::array<std::uint8_t, kReadSize> buffer;
  const ssize_t n = ::read(port_.fd, buffer.data(), buffer.size());
  const int error = errno;
  now = monotonic_now();
  if (n > 0) return client_.received({buffer.data(), static_cast<std::size_t>(n)}, now);
  if (n == 0) {
    lose(PortEnd::kHungUp, 0, now);
  } else if (!temporary(error)) {
    lose(PortEnd::kHungUp, error, now);
  }
  return false;
}

void FixedRateLoop::write(HostNs now) {
  const auto bytes = client_.output();
  if (!bytes.empty()) {
    const ssize_t n = ::write(port_.fd, bytes.data(), bytes.size());
    const int error = errno;
    statistics_.write.add(monotonic_now() - now);
    if (n > 0) {
      client_.written(static_cast<std::size_t>(n));
    } else if (n < 0 && !temporary(error)) {
      return lose(PortEnd::kHungUp, error, now);
    }
  }
  if (client_.output().empty()) {
    stuck_since_ns_ = 0;
  } else if (stuck_since_ns_ == 0) {
    stuck_since_ns_ = now;
  } else if (now - stuck_since_ns_ > kStuckNs) {
    client_.drop_output();
    stuck_since_ns_ = 0;
  }
}

void FixedRateLoop::lose(PortEnd end, int error, HostNs now) {
  lost_.push({port_.id, end, error});
  port_ = {};
  client_.closed(now);
}

}  // namespace tp100::loop
