#include "loop/fixed_rate_loop.h"

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

// Output older than this is stale for a robot; better none.
constexpr HostNs kStuckNs = 50 * kNsPerMs;
constexpr HostNs kWindUpLimitNs = 300 * kNsPerMs;
// Between two reads while waiting: bounds what a flooding peer can make the loop do.
constexpr HostNs kPromptSpacingNs = 50 * kNsPerUs;
constexpr HostNs kRobotSpacingNs = 200 * kNsPerUs;

void add(std::atomic<std::uint64_t>& counter, std::uint64_t n) {
  counter.store(counter.load(std::memory_order_relaxed) + n, std::memory_order_relaxed);
}

bool temporary(int error) { return error == EAGAIN || error == EWOULDBLOCK || error == EINTR; }

}  // namespace

FixedRateLoop::FixedRateLoop(const LoopSettings& settings, Driven& driven)
    : settings_(settings), driven_(driven), port_wait_(settings.period_ns / 2) {}

FixedRateLoop::~FixedRateLoop() {
  request_stop();
  join();
}

void FixedRateLoop::start() {
  try {
    thread_ = std::thread([this] {
      grants_ = apply_to_this_thread(settings_.thread);
      ready_.store(true, std::memory_order_release);
      run();
      ended_.store(true, std::memory_order_release);
    });
  } catch (const std::system_error& error) {
    throw SetupError(std::string("no thread for the real-time loop (") + error.what() +
                     "); raise the memory lock limit or set loop.lock_memory = false");
  }
  while (!ready_.load(std::memory_order_acquire)) sleep_until(monotonic_now() + kNsPerMs);
}

void FixedRateLoop::join() {
  if (thread_.joinable()) thread_.join();
}

void FixedRateLoop::run() {
  Schedule schedule(settings_.period_ns, settings_.overrun, monotonic_now());
  HostNs stopping_since = 0;
  for (;;) {
    adopt();
    const bool fresh = wait(schedule);
    settle();
    HostNs now = monotonic_now();
    const HostNs began = now;
    last_turn_ns_ = began;
    if (!fresh) statistics_.lateness.add(now - schedule.deadline());
    if (settings_.robot_paced && !fresh) add(statistics_.without_frame, 1);

    if (stop_.load(std::memory_order_relaxed)) {
      if (stopping_since == 0) stopping_since = now;
      if (driven_.wind_up(now) || now - stopping_since > kWindUpLimitNs) break;
    }
    // Not after a sample: a tty's read that finds nothing waits for the kernel's worker that
    // brought it, and that one runs at ordinary priority.
    if (port_.fd >= 0 && !fresh) read(now);
    driven_.step(now);
    const HostNs stepped = monotonic_now();
    statistics_.compute.add(stepped - now);
    if (port_.fd >= 0) write(stepped);
    unsettled_ns_ = now;
    turn_ns_ = monotonic_now() - began;
    // What carries the answer on is the kernel's worker, which may need this processor.
    if (!settings_.robot_paced || port_.fd < 0 || driven_.expects_reply(now)) settle();

    add(statistics_.turns, 1);
    std::uint64_t missed = 0;
    if (settings_.robot_paced) {
      missed = static_cast<std::uint64_t>(turn_ns_ / settings_.period_ns);
      schedule.restart(began, settings_.period_ns + settings_.period_ns / 2);
    } else {
      missed = schedule.advance(monotonic_now());
    }
    if (missed > 0) {
      add(statistics_.overruns, 1);
      add(statistics_.missed, missed);
    }
  }
  if (port_.fd >= 0) driven_.closed(monotonic_now());
}

// Ends the turn, at the latest before anything of the next one.
void FixedRateLoop::settle() {
  if (unsettled_ns_ == 0) return;
  const HostNs began = monotonic_now();
  driven_.settle(unsettled_ns_);
  if (driven_.take_hang_up() && port_.fd >= 0) lose(PortEnd::kSilent, 0, unsettled_ns_);
  unsettled_ns_ = 0;
  statistics_.work.add(turn_ns_ + monotonic_now() - began);
}

void FixedRateLoop::adopt() {
  if (port_.fd >= 0 || !offered_.pop(port_)) return;
  stuck_since_ns_ = 0;
  driven_.opened(monotonic_now());
}

// True if a sample of the robot began the turn. However many samples come, turns are half a period
// apart.
bool FixedRateLoop::wait(Schedule& schedule) {
  const HostNs wake = schedule.deadline() - (settings_.robot_paced ? 0 : settings_.spin_ns);
  const HostNs earliest = last_turn_ns_ + settings_.period_ns / 2;
  bool sample = false;
  for (HostNs now = monotonic_now(); now < wake; now = monotonic_now()) {
    if (sample && now >= earliest) return true;
    const bool prompt = driven_.expects_reply(now);
    if (port_.fd < 0 || !(settings_.robot_paced || prompt)) {
      sleep_until(wake);
      break;
    }
    const bool readable = sample || port_wait_.readable(port_.fd, wake);
    settle();
    if (!readable || port_.fd < 0) continue;
    sample = (read(now) || sample) && settings_.robot_paced;
    if (sample && now >= earliest) return true;
    sleep_until(std::min(wake, now + (prompt ? kPromptSpacingNs : kRobotSpacingNs)));
  }
  spin_until(schedule.deadline());
  return sample;
}

// One bounded read. True if it brought a sample; `now` becomes the time right after it.
bool FixedRateLoop::read(HostNs& now) {
  std::array<std::uint8_t, kReadSize> buffer;
  const ssize_t n = ::read(port_.fd, buffer.data(), buffer.size());
  const int error = errno;
  now = monotonic_now();
  if (n > 0) return driven_.received({buffer.data(), static_cast<std::size_t>(n)}, now);
  if (n == 0) {
    lose(PortEnd::kHungUp, 0, now);
  } else if (!temporary(error)) {
    lose(PortEnd::kHungUp, error, now);
  }
  return false;
}

void FixedRateLoop::write(HostNs now) {
  const auto bytes = driven_.output();
  if (!bytes.empty()) {
    const ssize_t n = ::write(port_.fd, bytes.data(), bytes.size());
    const int error = errno;
    statistics_.write.add(monotonic_now() - now);
    if (n > 0) {
      driven_.written(static_cast<std::size_t>(n));
    } else if (n < 0 && !temporary(error)) {
      return lose(PortEnd::kHungUp, error, now);
    }
  }
  if (driven_.output().empty()) {
    stuck_since_ns_ = 0;
  } else if (stuck_since_ns_ == 0) {
    stuck_since_ns_ = now;
  } else if (now - stuck_since_ns_ > kStuckNs) {
    driven_.drop_output();
    stuck_since_ns_ = 0;
  }
}

void FixedRateLoop::lose(PortEnd end, int error, HostNs now) {
  lost_.push({port_.id, end, error});
  port_ = {};
  driven_.closed(now);
}

}  // namespace tp100::loop
