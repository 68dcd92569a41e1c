// clock_bench SECONDS SEEDS: measures the error of the clock sync against the emulated board's
// clock, in virtual time, with the real session in a 200 Hz loop. Prints rows of JSON.

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <deque>
#include <random>
#include <vector>

#include "bridge/cycle.h"
#include "core/statistics.h"
#include "course/robot_file.h"
#include "link/session.h"
#include "sim/board/native_board.h"
#include "sim/robot/emulated_robot.h"
#include "sim/sensors/mpu6050.h"

namespace tp100::sim {
namespace {

constexpr std::int64_t kPeriodNs = 5 * kNsPerMs;
// The live loop polls with this period for bytes whose arrival time matters.
constexpr std::int64_t kLookNs = 50 * kNsPerUs;
// The window of the clock sync is full of exchanges after this time.
constexpr double kSettledS = 35.0;

struct Case {
  double ppm;
  std::int64_t to_host_ns;   ///< period of the batches in which bytes arrive; 0: each by itself
  std::int64_t to_robot_ns;  ///< the same for bytes that the host writes
};

/// Releases bytes at whole multiples of a period that drifts against the host's clock, as one
/// crystal oscillator drifts against another.
class Batches {
 public:
  Batches(std::int64_t period_ns, std::mt19937_64& random)
      : period_ns_(static_cast<double>(period_ns) * (1.0 + 7e-6)),
        phase_ns_(period_ns == 0 ? 0
                                 : static_cast<std::int64_t>(
                                       random() % static_cast<std::uint64_t>(period_ns))) {}
  std::int64_t release_ns(std::int64_t at_ns) const {
    if (period_ns_ == 0.0) return at_ns;
    const double turns = std::ceil(static_cast<double>(at_ns - phase_ns_) / period_ns_);
    return phase_ns_ + static_cast<std::int64_t>(std::ceil(turns * period_ns_));
  }

 private:
  double period_ns_;
  std::int64_t phase_ns_;
};

struct Errors {
  std::vector<double> first_us, settled_us;
};

class Line {
 public:
  Line(const Case& of, std::uint64_t seed)
      : random_(seed),
        to_host_(of.to_host_ns, random_),
        to_robot_(of.to_robot_ns, random_),
        board_({.seed = seed,
                .clock_ppm = of.ppm,
                .boot_delay_ns = static_cast<std::int64_t>(4'000'000 + random_() % 5'000'000)},
               &imu_),
        next_step_ns_(static_cast<std::int64_t>(20'000'000 + random_() % 5'000'000)) {}

  void run(double seconds, Errors& errors) {
    board_.reset(PowerUp::kPowerOn, 0);
    session_.open(0);
    while (to_s(now_ns_) < seconds) {
      quantum();
      if (session_.state() != SessionState::kReady || now_ns_ % kPeriodNs != 0) continue;
      if (ready_ns_ < 0) ready_ns_ = now_ns_;
      const double us =
          std::abs(static_cast<double>(session_.clock().to_host(true_us()) - now_ns_));
      (to_s(now_ns_ - ready_ns_) < kSettledS ? errors.first_us : errors.settled_us)
          .push_back(us * 1e-3);
    }
  }

 private:
  /// The board's clock starts at 0 and does not wrap within any run here.
  DeviceUs true_us() const { return static_cast<DeviceUs>(board_.device_us()); }

  // Advances by the host's shortest polling period, so that bytes from the host never arrive in the
  // board's past.
  void quantum() {
    const std::int64_t until_ns = now_ns_ + kLookNs;
    if (now_ns_ % kNsPerMs == 0) imu_.measure({}, now_ns_);
    board_.advance(until_ns, {}, wire_.take(until_ns));
    now_ns_ = until_ns;
    for (const TimedByte& byte : board_.take_sent())
      arriving_.push_back({to_host_.release_ns(byte.at_ns), byte.value});
    if (now_ns_ >= next_step_ns_) {
      step(now_ns_);
    } else if (session_.expects_reply(now_ns_)) {
      read(now_ns_);
    }
  }

  void step(std::int64_t at_ns) {
    next_step_ns_ += kPeriodNs;
    read(at_ns);
    session_.take_samples();
    session_.poll(at_ns);
    session_.send({}, at_ns);
    session_.take_events();
    wire_.send(session_.output(), to_robot_.release_ns(at_ns));
    session_.written(session_.output().size());
  }

  void read(std::int64_t at_ns) {
    bytes_.clear();
    for (; !arriving_.empty() && arriving_.front().at_ns <= at_ns; arriving_.pop_front())
      bytes_.push_back(arriving_.front().value);
    if (!bytes_.empty()) session_.receive(bytes_, at_ns);
  }

  std::mt19937_64 random_;
  Batches to_host_, to_robot_;
  Mpu6050 imu_{course::EmulatedImu{}, 1};
  NativeBoard board_;
  UartLine wire_{wire::kBaud};
  link::Session session_{bridge::session_settings({})};
  std::deque<TimedByte> arriving_;
  std::vector<std::uint8_t> bytes_;
  std::int64_t now_ns_ = 0;
  std::int64_t next_step_ns_;
  std::int64_t ready_ns_ = -1;
};

void measure(const Case& of, double seconds, int seeds) {
  Errors errors;
  for (int seed = 1; seed <= seeds; ++seed)
    Line(of, static_cast<std::uint64_t>(seed)).run(seconds, errors);
  std::printf(
      "{\"ppm\":%.0f,\"to_host_ms\":%lld,\"to_robot_ms\":%lld,\"p50_us\":%.1f,\"p99_us\":%.1f,"
      "\"max_us\":%.1f,\"first_p99_us\":%.1f}\n",
      of.ppm, static_cast<long long>(of.to_host_ns / kNsPerMs),
      static_cast<long long>(of.to_robot_ns / kNsPerMs), percentile(errors.settled_us, 0.5),
      percentile(errors.settled_us, 0.99), percentile(errors.settled_us, 1.0),
      percentile(errors.first_us, 0.99));
  std::fflush(stdout);
}

void bench(double seconds, int seeds) {
  for (const std::int64_t to_host_ms : {0, 1, 16})
    for (const double ppm : {0.0, 100.0, -100.0, 1000.0, -1000.0})
      measure({ppm, to_host_ms * kNsPerMs, 0}, seconds, seeds);
  for (const double ppm : {100.0, -100.0}) measure({ppm, kNsPerMs, kNsPerMs}, seconds, seeds);
}

}  // namespace
}  // namespace tp100::sim

int main(int argc, char** argv) {
  const double seconds = argc > 1 ? std::atof(argv[1]) : 300.0;
  tp100::sim::bench(std::max(seconds, 40.0), argc > 2 ? std::max(1, std::atoi(argv[2])) : 5);
  return 0;
}
