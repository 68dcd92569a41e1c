#include "camera/watch.h"

#include <time.h>

#include <cerrno>
#include <csignal>
#include <cstdio>
#include <optional>

#include "camera/device_source.h"
#include "camera/observer.h"
#include "camera/picture_gaps.h"
#include "camera/pose_stream.h"
#include "camera/tum_file.h"
#include "core/clock.h"
#include "core/error.h"

namespace tp100::camera {
namespace {

// A played recording that falls behind by this leaves pictures out, as a slow camera would.
constexpr HostNs kBehindNs = 200 * kNsPerMs;
constexpr HostNs kTellNs = 10 * kNsPerS;

volatile std::sig_atomic_t g_stop = 0;
void on_signal(int) { g_stop = 1; }

void sleep_until(HostNs at_ns) {
  const timespec at{at_ns / kNsPerS, at_ns % kNsPerS};
  while (clock_nanosleep(CLOCK_MONOTONIC, TIMER_ABSTIME, &at, nullptr) == EINTR && g_stop == 0) {
  }
}

class Watch {
 public:
  explicit Watch(const WatchOptions& options)
      : view_(read_view(options.view)),
        observer_(read_lens(view_.lens), view_),
        source_(open_source(options.source, with_delay(options.pictures))) {
    if (!options.send.empty())
      stream_.emplace(link::parse_udp(options.send, "--send"), view_.marker_id);
    if (!options.tum.empty()) tum_.emplace(options.tum);
  }

  int run();

 private:
  SourceOptions with_delay(SourceOptions options) const {
    options.delay_s = view_.delay_s;
    return options;
  }
  void take(const Picture& picture);
  bool in_time(HostNs taken_ns) const;
  void tell(HostNs now);
  void tell_floor();
  int finish(bool gone);

  View view_;
  Observer observer_;
  std::unique_ptr<Source> source_;
  std::optional<PoseStream> stream_;
  std::optional<TumFile> tum_;
  PictureGaps gaps_;
  HostNs begin_ns_ = 0;  ///< what a recording's times are added to
  HostNs next_tell_ns_ = 0;
  std::uint64_t pictures_ = 0, found_ = 0, left_out_ = 0;
};

void Watch::tell_floor() {
  if (!observer_.take_floor_news()) return;
  if (!observer_.floor().plane()) {
    std::fprintf(stderr, "floor: %s\n",
                 observer_.floor().moves() > 0 ? "camera or markers moved; finding it again"
                                               : observer_.floor().problem().c_str());
    return;
  }
  const FloorPlane& plane = *observer_.floor().plane();
  std::fprintf(stderr, "floor: found, %.2f px rms; the lens is %.3f m above x %.3f m, y %.3f m\n",
               plane.rms_px(), plane.lens_m().z, plane.lens_m().x, plane.lens_m().y);
}

void Watch::tell(HostNs now) {
  tell_floor();
  if (!source_->live() || now < next_tell_ns_) return;
  next_tell_ns_ = now + kTellNs;
  std::fprintf(stderr, "pictures %llu, dropped %llu, marker %d seen in %llu%s%s\n",
               static_cast<unsigned long long>(pictures_),
               static_cast<unsigned long long>(gaps_.missing()), view_.marker_id,
               static_cast<unsigned long long>(found_),
               observer_.floor().plane() ? "" : "; floor: ",
               observer_.floor().plane() ? "" : observer_.floor().problem().c_str());
}

/// Waits for the instant of a recorded picture. False: too late for it.
bool Watch::in_time(HostNs taken_ns) const {
  if (source_->live() || !stream_) return true;
  const HostNs due_ns = begin_ns_ + taken_ns;
  if (monotonic_now() - due_ns > kBehindNs) return false;
  sleep_until(due_ns);
  return true;
}

void Watch::take(const Picture& picture) {
  ++pictures_;
  const std::optional<std::uint32_t> number = gaps_.number(picture.taken_ns);
  if (!number || !in_time(picture.taken_ns)) {
    ++left_out_;
    return;
  }
  const std::optional<MarkerPose> pose = observer_.look(picture.grey);
  tell(monotonic_now());
  if (!pose) return;
  ++found_;
  if (tum_) tum_->add(*pose, picture.taken_ns);
  if (stream_) stream_->send(*pose, *number, begin_ns_ + picture.taken_ns, monotonic_now());
}

int Watch::finish(bool gone) {
  if (tum_) tum_->finish();
  std::printf("pictures %llu, dropped %llu, left out %llu, marker %d seen in %llu\n",
              static_cast<unsigned long long>(pictures_),
              static_cast<unsigned long long>(gaps_.missing()),
              static_cast<unsigned long long>(left_out_), view_.marker_id,
              static_cast<unsigned long long>(found_));
  std::fflush(stdout);
  if (gone) {
    std::fprintf(stderr, "tp100-camera: the device gives no more pictures; check its cable\n");
    return 1;
  }
  if (found_ > 0 || source_->live()) return 0;
  const std::string& problem = observer_.floor().problem();
  std::fprintf(stderr, "tp100-camera: no picture shows marker %d%s%s\n", view_.marker_id,
               observer_.floor().plane() ? "" : " over a known floor: ",
               observer_.floor().plane() ? "" : problem.c_str());
  return 1;
}

int Watch::run() {
  Picture picture;
  begin_ns_ = source_->live() || !stream_ ? 0 : monotonic_now();
  bool more = true;
  try {
    while (g_stop == 0 && (more = source_->next(picture))) take(picture);
  } catch (const SetupError&) {
    if (tum_) tum_->finish();
    throw;
  }
  return finish(!more && source_->live());
}

}  // namespace

int watch(const WatchOptions& options) {
  Watch watch(options);
  std::signal(SIGINT, on_signal);
  std::signal(SIGTERM, on_signal);
  if (std::signal(SIGHUP, on_signal) == SIG_IGN) std::signal(SIGHUP, SIG_IGN);
  std::signal(SIGPIPE, SIG_IGN);
  return watch.run();
}

}  // namespace tp100::camera
