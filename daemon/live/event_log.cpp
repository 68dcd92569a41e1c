#include "live/event_log.h"

#include <pthread.h>
#include <spdlog/async_logger.h>
#include <spdlog/details/thread_pool.h>
#include <spdlog/sinks/stdout_color_sinks.h>
#include <spdlog/sinks/stdout_sinks.h>
#include <spdlog/spdlog.h>

#include <array>
#include <atomic>
#include <chrono>
#include <csignal>
#include <thread>
#include <utility>

#include "core/arithmetic.h"
#include "text/standard_streams.h"

namespace tp100::live {
namespace {

using namespace std::chrono_literals;

// More lines per second than this are folded.
constexpr int kBurst = 50;
constexpr HostNs kStatusLinePeriodNs = 10 * kNsPerS;
// The gyro's standstill is detected within half a second, and a world replies soon.
constexpr HostNs kRefusalNs = kNsPerS;
constexpr std::size_t kWaiting = 1024;
constexpr auto kFlushTimeout = 1000ms, kLook = 5ms;

// By messages::Event::Level.
constexpr std::array kLevels = {spdlog::level::info, spdlog::level::warn, spdlog::level::err};

/// A sink that knows whether it waits for its reader.
template <class Sink>
class Watched : public Sink {
 public:
  explicit Watched(std::atomic<bool>& waits) : waits_(waits) {}
  void log(const spdlog::details::log_msg& message) override {
    waits_ = true;
    Sink::log(message);
    waits_ = false;
  }

 private:
  std::atomic<bool>& waits_;
};

}  // namespace

struct EventLog::Writer {
  std::atomic<bool> waits{false};
  std::shared_ptr<spdlog::details::thread_pool> pool =
      std::make_shared<spdlog::details::thread_pool>(
          kWaiting, 1, [] { ::pthread_setname_np(::pthread_self(), "log"); });
  // spdlog's asynchronous logger must be owned by a shared_ptr.
  std::shared_ptr<spdlog::async_logger> logger = std::make_shared<spdlog::async_logger>(
      "tp100d", std::make_shared<Watched<spdlog::sinks::stderr_color_sink_mt>>(waits), pool,
      spdlog::async_overflow_policy::overrun_oldest);
  std::shared_ptr<spdlog::async_logger> output = std::make_shared<spdlog::async_logger>(
      "summary", std::make_shared<Watched<spdlog::sinks::stdout_sink_mt>>(waits), pool,
      spdlog::async_overflow_policy::overrun_oldest);
};

EventLog::EventLog() : writer_(std::make_unique<Writer>()) {
  // A reader that goes away must not end a run without a disarm.
  std::signal(SIGPIPE, SIG_IGN);
  // https://no-color.org
  if (!text::environment_variable("NO_COLOR").empty())
    writer_->logger->set_pattern("%H:%M:%S.%e %l %v");
  else
    writer_->logger->set_pattern("%H:%M:%S.%e %^%l%$ %v");
  writer_->logger->flush_on(spdlog::level::info);
  writer_->output->set_pattern("%v");
}

bool EventLog::flush() {
  const auto written = [&] { return writer_->pool->queue_size() == 0 && !writer_->waits; };
  for (std::chrono::milliseconds waited{0}; !written() && waited < kFlushTimeout; waited += kLook)
    std::this_thread::sleep_for(kLook);
  // The last line may still be on its way.
  std::this_thread::sleep_for(kLook);
  return written();
}

EventLog::~EventLog() {
  // The thread hangs in a write that may never return: the end of the process ends it.
  if (!flush()) {
    static_cast<void>(writer_.release());
    return;
  }
  // The pool's thread ends before the logger: a last line may still hold a reference to it.
  writer_->pool.reset();
}

void EventLog::info(const std::string& line) { writer_->logger->info("{}", line); }
void EventLog::warn(const std::string& line) { writer_->logger->warn("{}", line); }

void EventLog::summary(const std::string& lines) { writer_->output->info("{}", lines); }

void EventLog::tick(HostNs now) {
  const std::uint64_t lost = writer_->pool->overrun_counter();
  if (lost > lost_ && writer_->pool->queue_size() == 0) {
    writer_->logger->warn("{} lines of this log are lost: nobody read it", lost - lost_);
    lost_ = lost;
  }
  if (now - burst_began_ns_ <= kNsPerS) return;
  if (burst_ > kBurst)
    writer_->logger->warn("{} more events within a second are not shown", burst_ - kBurst);
  burst_began_ns_ = now;
  burst_ = 0;
}

void EventLog::event(const LiveEvent& event, const std::vector<messages::Event>& described) {
  if (const SessionReport* report = std::get_if<SessionReport>(&event)) {
    // A silent port is logged once.
    const bool silent = link::as<link::Silence>(report->event) != nullptr;
    const bool reported = std::exchange(silence_reported_, silent);
    tick(report->event.at_ns);
    if ((silent && reported) || ++burst_ > kBurst) return;
  }
  write(described);
}

void EventLog::write(const std::vector<messages::Event>& all) {
  for (const messages::Event& one : all) {
    const std::string line = one.text + (one.cause.empty() ? "" : ": " + one.cause) +
                             (one.fix.empty() ? "" : "; " + one.fix);
    writer_->logger->log(kLevels.at(static_cast<std::size_t>(one.level)), "{}", line);
  }
}

void EventLog::recording(const messages::RecordingFigures& now) {
  const messages::RecordingFigures before = std::exchange(recording_, now);
  if (now.file != before.file) info("recording to " + now.file);
  if (!now.warning.empty() && now.warning != before.warning) warn(now.warning);
  if (now.dropped > 0 && before.dropped == 0)
    warn(now.file + ": the disk is too slow, steps are missing in the recording");
}

void EventLog::privileges(const std::vector<loop::Privilege>& privileges) {
  for (const auto& [what, granted, fix] : privileges)
    info("real time: " + (granted ? what : "no " + what + "; " + fix));
}

// Without a course or during a run a start is not expected, and a missing robot is logged
// elsewhere.
void EventLog::refusal(StartRefusal refusal, HostNs now) {
  if (refusal != refusal_) {
    refusal_ = refusal;
    refusal_since_ns_ = now;
    refusal_reported_ = false;
  }
  const bool known = refusal <= StartRefusal::kNoSession;
  if (known || refusal_reported_ || now - refusal_since_ns_ < kRefusalNs) return;
  refusal_reported_ = true;
  warn("a start would be refused: " + std::string(to_string(refusal)));
}

void EventLog::status(const LiveStatus& status, std::uint64_t overruns, HostNs now) {
  refusal(status.snapshot.start_refusal, now);
  if (status.session != SessionState::kReady || now < next_status_ns_) return;
  next_status_ns_ = now + kStatusLinePeriodNs;
  const LinkCounters& link = status.counters;
  const Pose& pose = status.snapshot.estimates[PoseSource::kOdometry].pose;
  writer_->logger->info(
      "x {:.3f} m, y {:.3f} m, yaw {:.1f} deg; samples {}, lost {}, bad frames {}, overruns {}; "
      "clock drift {:.1f} ppm, +-{:.0f} us; battery {:.2f} V",
      pose.x_m, pose.y_m, pose.yaw_rad * kDegPerRad, link.samples, link.lost, link.corrupted(),
      overruns, status.clock.drift * 1e6, status.clock.uncertainty_us,
      status.snapshot.sample.battery_v);
}

}  // namespace tp100::live
