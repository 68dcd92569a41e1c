#include "camera/watch.h"

#include <sys/eventfd.h>
#include <time.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <csignal>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <optional>
#include <random>
#include <string>

#include "camera/image_sender.h"
#include "camera/observer.h"
#include "camera/source.h"
#include "core/clock.h"
#include "core/error.h"
#include "core/time.h"
#include "link/camera_message.h"
#include "link/udp.h"
#include "text/atomic_file.h"
#include "text/format.h"

namespace tp100::camera {
namespace {

/// A line of a TUM file, for evo and others: "t x y z qx qy qz qw", seconds and metres. z is 0: the
/// reference point is on the floor.
std::string tum_line(const MarkerPose& pose, HostNs taken_ns) {
  const double half = pose.yaw_rad / 2.0;
  return text::format("%.6f %.6f %.6f 0 0 0 %.9f %.9f\n", to_s(taken_ns), pose.x_m, pose.y_m,
                      std::sin(half), std::cos(half));
}

// Limits a long pause, so that the number stays far from overflow.
constexpr double kMaxAtOnce = 1e5;

// If a played recording falls behind by this, images are skipped, as by a slow camera.
constexpr HostNs kBehindNs = 200 * kNsPerMs;
constexpr HostNs kReportNs = 10 * kNsPerS;

volatile std::sig_atomic_t g_stop = 0;
// The wait for images also polls this descriptor, so that a signal just before the wait ends it.
volatile std::sig_atomic_t g_stop_fd = -1;
void on_signal(int) {
  g_stop = 1;
  const int before = errno;
  const std::uint64_t one = 1;
  [[maybe_unused]] const ssize_t written = ::write(g_stop_fd, &one, sizeof one);
  errno = before;
}

void sleep_until(HostNs at_ns) {
  const timespec at{at_ns / kNsPerS, at_ns % kNsPerS};
  while (clock_nanosleep(CLOCK_MONOTONIC, TIMER_ABSTIME, &at, nullptr) == EINTR && g_stop == 0) {
  }
}

class MarkerTracking {
 public:
  explicit MarkerTracking(const WatchOptions& options)
      : view_(options.view.empty() ? View{} : read_view(options.view)),
        source_(open_source(options.source, with_delay(options.images))) {
    if (!options.view.empty()) observer_.emplace(read_lens(view_.lens), view_);
    if (!options.tum.empty()) {
      tum_.emplace(options.tum);
      tum_->write("# t_s x_m y_m z_m qx qy qz qw\n");
    }
    if (options.send.empty()) return;
    const link::UdpAddress to = link::parse_udp(options.send, "--send");
    sender_.emplace(to);
    message_.stream = std::random_device{}();
    message_.clock = link::monotonic_clock_name();
    message_.marker = static_cast<std::uint32_t>(view_.marker_id);
    if (view_.images.rate_hz > 0.0) image_sender_.emplace(to, view_.images);
  }

  int run();

 private:
  SourceOptions with_delay(SourceOptions options) const {
    options.delay_s = view_.delay_s;
    options.stop_fd = g_stop_fd;
    return options;
  }
  void take(const Image& image);
  void process(const Image& image, std::uint32_t number);
  bool in_time(HostNs taken_ns) const;
  void report_progress(HostNs now);
  void report_floor();
  int finish(bool gone);
  std::string counts() const;
  std::string floor_problem(const char* before) const;

  View view_;
  std::optional<Observer> observer_;  // nothing: images only
  std::unique_ptr<Source> source_;
  std::optional<link::UdpSender> sender_;
  link::CameraMessage message_{};
  std::optional<ImageSender> image_sender_;
  std::optional<text::FileReplacement> tum_;
  ImageGaps gaps_;
  HostNs begin_ns_ = 0;  ///< offset added to a recording's times
  HostNs next_report_ns_ = 0;
  std::uint64_t images_ = 0, found_ = 0, left_out_ = 0;
};

void MarkerTracking::report_floor() {
  if (!observer_ || !observer_->take_floor_news()) return;
  const FloorMonitor& floor = observer_->floor();
  if (!floor.plane()) {
    std::fprintf(
        stderr, "floor: %s\n",
        floor.moves() > 0 ? "camera or markers moved; finding it again" : floor.problem().c_str());
    return;
  }
  const FloorPlane& plane = *floor.plane();
  std::fprintf(stderr, "floor: found, %.2f px rms; the lens is %.3f m above x %.3f m, y %.3f m\n",
               plane.rms_px(), plane.lens_m().z, plane.lens_m().x, plane.lens_m().y);
}

/// ", marker 0 seen in 12, images sent 5", as far as markers are looked for and images sent.
std::string MarkerTracking::counts() const {
  std::string text;
  if (observer_)
    text += ", marker " + std::to_string(view_.marker_id) + " seen in " + std::to_string(found_);
  if (image_sender_) text += ", images sent " + std::to_string(image_sender_->sent());
  return text;
}

/// `before` and why there is no floor; empty if there is one.
std::string MarkerTracking::floor_problem(const char* before) const {
  if (!observer_ || observer_->floor().plane()) return {};
  return before + observer_->floor().problem();
}

void MarkerTracking::report_progress(HostNs now) {
  report_floor();
  if (!source_->live() || now < next_report_ns_) return;
  next_report_ns_ = now + kReportNs;
  std::fprintf(stderr, "images %llu, dropped %llu%s%s\n", static_cast<unsigned long long>(images_),
               static_cast<unsigned long long>(gaps_.missing()), counts().c_str(),
               floor_problem("; floor: ").c_str());
}

/// Waits for the time of a recorded image. False: it has already passed.
bool MarkerTracking::in_time(HostNs taken_ns) const {
  if (source_->live() || !sender_) return true;
  const HostNs due_ns = begin_ns_ + taken_ns;
  if (monotonic_now() - due_ns > kBehindNs) return false;
  sleep_until(due_ns);
  return true;
}

void MarkerTracking::take(const Image& image) {
  ++images_;
  const std::optional<std::uint32_t> number = gaps_.number(image.taken_ns);
  if (!number || !in_time(image.taken_ns)) {
    ++left_out_;
    return;
  }
  process(image, *number);
  // After the pose, because the step waits for that.
  if (image_sender_) image_sender_->send(image.shown, begin_ns_ + image.taken_ns);
  report_progress(monotonic_now());
}

void MarkerTracking::process(const Image& image, std::uint32_t number) {
  if (!observer_) return;
  const std::optional<MarkerPose> pose = observer_->look(image.grey);
  if (!pose) return;
  ++found_;
  if (tum_) tum_->write(tum_line(*pose, image.taken_ns));
  if (!sender_) return;
  const HostNs taken_ns = begin_ns_ + image.taken_ns;
  message_.sequence = number;
  message_.stamp_us = std::max<HostNs>(0, taken_ns / kNsPerUs);
  message_.age_us = std::max<HostNs>(0, (monotonic_now() - taken_ns) / kNsPerUs);
  message_.x_m = pose->x_m;
  message_.y_m = pose->y_m;
  message_.yaw_rad = pose->yaw_rad;
  sender_->send(link::encode(message_));
}

int MarkerTracking::finish(bool gone) {
  if (tum_) tum_->commit();
  std::printf("images %llu, dropped %llu, left out %llu%s\n",
              static_cast<unsigned long long>(images_),
              static_cast<unsigned long long>(gaps_.missing()),
              static_cast<unsigned long long>(left_out_), counts().c_str());
  std::fflush(stdout);
  if (gone) {
    std::fprintf(stderr, "tp100-camera: the device gives no more images; check its cable\n");
    return 1;
  }
  if (found_ > 0 || !source_->ends() || !observer_) return 0;
  std::fprintf(stderr, "tp100-camera: no image shows marker %d%s\n", view_.marker_id,
               floor_problem(" over a known floor: ").c_str());
  return 1;
}

int MarkerTracking::run() {
  Image image;
  begin_ns_ = source_->live() || !sender_ ? 0 : monotonic_now();
  bool more = true;
  try {
    while (g_stop == 0 && (more = source_->next(image))) take(image);
  } catch (const UserError&) {
    if (tum_) tum_->commit();
    throw;
  }
  return finish(!more && !source_->ends());
}

}  // namespace

HostNs ImageGaps::usual_ns() const {
  if (count_ < kKnown) return 0;
  std::array<HostNs, kRemembered> sorted = intervals_;
  const auto end = sorted.begin() + static_cast<std::ptrdiff_t>(std::min(count_, kRemembered));
  const auto half = sorted.begin() + (end - sorted.begin()) / 2;
  std::nth_element(sorted.begin(), half, end);
  return *half;
}

std::optional<std::uint32_t> ImageGaps::number(HostNs taken_ns) {
  if (number_ == 0) {
    last_ns_ = taken_ns;
    return ++number_;
  }
  const HostNs interval_ns = taken_ns - last_ns_;
  if (interval_ns <= 0) return {};
  const HostNs usual = usual_ns();
  if (usual > 0) {
    const double periods = static_cast<double>(interval_ns) / static_cast<double>(usual);
    const double dropped = std::clamp(std::round(periods) - 1.0, 0.0, kMaxAtOnce);
    number_ += static_cast<std::uint32_t>(dropped);
    missing_ += static_cast<std::uint64_t>(dropped);
  }
  intervals_[count_ % kRemembered] = interval_ns;
  ++count_;
  last_ns_ = taken_ns;
  return ++number_;
}

int watch(const WatchOptions& options) {
  g_stop_fd = ::eventfd(0, EFD_CLOEXEC | EFD_NONBLOCK);
  if (g_stop_fd < 0)
    throw UserError(std::string("no descriptor for signals (") + std::strerror(errno) +
                    "); raise ulimit -n");
  MarkerTracking tracking(options);
  std::signal(SIGINT, on_signal);
  std::signal(SIGTERM, on_signal);
  if (std::signal(SIGHUP, on_signal) == SIG_IGN) std::signal(SIGHUP, SIG_IGN);
  std::signal(SIGPIPE, SIG_IGN);
  return tracking.run();
}

}  // namespace tp100::camera
