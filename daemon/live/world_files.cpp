#include <fcntl.h>
#include <pthread.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <chrono>
#include <condition_variable>
#include <mutex>
#include <optional>
#include <thread>
#include <utility>

#include "core/clock.h"
#include "core/descriptor.h"
#include "core/error.h"
#include "live/external_inputs.h"
#include "text/atomic_file.h"
#include "worlds/text_files.h"

namespace tp100::live {
namespace {

using namespace std::chrono_literals;

// Polling period of the file: a game engine's tick is 8 ms or more.
constexpr auto kLook = 4ms;

constexpr auto kInfo = messages::Event::Level::kInfo;

/// Replaces `path`: a reader sees either the old text or the new one. Why it failed, or nothing.
std::string replace_file(const std::string& path, std::string_view text) {
  try {
    text::write_file(path, text, text::Flush::kNo);
    return {};
  } catch (const UserError& error) {
    return error.what();
  }
}

/// Identifies one version of a file: a changed file has another stamp.
struct Stamp {
  ino_t file = 0;
  off_t size = 0;
  std::int64_t changed_ns = 0;
  bool operator==(const Stamp&) const = default;
};

/// Watches one small file written by another program.
class Watched {
 public:
  explicit Watched(std::string path) : path_(std::move(path)) {}

  /// The text, if the file has changed since it was last accepted; nothing if it has not, or if it
  /// may be half written.
  std::optional<std::string> look() {
    // Regular files only: opening a pipe would wait for its other end.
    const Descriptor file(::open(path_.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK | O_NOCTTY));
    struct stat status {};
    if (!file || ::fstat(file.get(), &status) != 0 || !S_ISREG(status.st_mode)) return std::nullopt;
    const Stamp stamp{status.st_ino, status.st_size,
                      status.st_mtim.tv_sec * kNsPerS + status.st_mtim.tv_nsec};
    return stamp == accepted_ ? std::nullopt : read(file.get(), stamp);
  }

 private:
  std::optional<std::string> read(int file, const Stamp& stamp) {
    std::array<char, worlds::kMaxOrientationText + 1> buffer{};
    const ssize_t n = ::read(file, buffer.data(), buffer.size());
    if (n <= 0) return std::nullopt;
    std::string text(buffer.data(), static_cast<std::size_t>(n));
    // Without a final newline it may be incomplete: accept it only when read twice in a row.
    const bool whole = text.ends_with('\n') || text == before_;
    before_ = text;
    if (!whole) return std::nullopt;
    before_.clear();
    accepted_ = stamp;
    return text;
  }

  std::string path_;
  Stamp accepted_{};
  std::string before_;
};

class WorldFiles : public WorldLink {
 public:
  WorldFiles(const config::WorldRun& run, config::GiveWorld give, messages::EventQueue& events)
      : run_(run),
        give_(std::move(give)),
        events_(events),
        orientation_(run.settings.orientation_file) {
    const config::WorldSettings& settings = run.settings;
    worlds::require_encoder_template(settings.encoder_template, "world.encoder_template");
    if (const std::string why = replace_file(settings.encoder_file, "\n"); !why.empty())
      throw UserError("world.encoder_file " + why);
    thread_ = std::thread([this] { live(); });
    ::pthread_setname_np(thread_.native_handle(), "world files");
  }
  ~WorldFiles() override {
    WorldFiles::stop();
    thread_.join();
  }

  /// Queues the newest step for the file; never waits for the disk.
  void take(const StepRecord& record) override {
    if (record.now_ns < next_ns_) return;
    next_ns_ = record.now_ns + from_s(1.0 / run_.settings.rate_hz);
    std::string text =
        worlds::encoder_text(run_.settings.encoder_template, record, run_.settings.frame);
    {
      const std::lock_guard lock(mutex_);
      text_ = std::move(text);
    }
    wake_.notify_one();
  }
  void stop() override {
    {
      const std::lock_guard lock(mutex_);
      ending_ = true;
    }
    wake_.notify_one();
  }
  bool ended_by(std::chrono::steady_clock::time_point deadline) override {
    std::unique_lock lock(mutex_);
    return wake_.wait_until(lock, deadline, [this] { return ended_; });
  }
  WorldFigures figures() const override {
    const std::lock_guard lock(mutex_);
    return {.files = counters_};
  }

 private:
  void live();
  WorldSample sample_of(const worlds::Orientation& received, HostNs now) const;

  const config::WorldRun run_;
  const config::GiveWorld give_;
  messages::EventQueue& events_;
  Watched orientation_;  // used by the thread only
  HostNs next_ns_ = 0;   // used by take() only

  mutable std::mutex mutex_;
  std::condition_variable wake_;
  std::optional<std::string> text_;
  WorldFileCounters counters_;
  bool reported_write_ = false, reported_read_ = false;
  bool ending_ = false, ended_ = false;
  std::thread thread_;
};

void WorldFiles::live() {
  const config::WorldSettings& settings = run_.settings;
  std::unique_lock lock(mutex_);
  while (!ending_) {
    wake_.wait_for(lock, kLook, [this] { return ending_ || text_.has_value(); });
    const std::optional<std::string> next = std::exchange(text_, std::nullopt);
    lock.unlock();
    const std::string error = next ? replace_file(settings.encoder_file, *next) : std::string();
    const std::optional<std::string> seen = orientation_.look();
    const HostNs now = monotonic_now();
    const auto orientation_seen =
        seen ? worlds::orientation_of(*seen, settings.frame) : std::nullopt;
    const bool given = orientation_seen && give_(sample_of(*orientation_seen, now));
    lock.lock();
    if (next) ++(error.empty() ? counters_.written : counters_.write_errors);
    if (seen) ++(orientation_seen ? counters_.read : counters_.rejected);
    if (orientation_seen && !given) ++counters_.dropped;
    if (!error.empty() && !std::exchange(reported_write_, true)) events_.note(error, kInfo);
    if (seen && !orientation_seen && !std::exchange(reported_read_, true))
      events_.note(settings.orientation_file + ": cannot be parsed; write P=0 Y=0 R=0 or numbers",
                   kInfo);
  }
  ended_ = true;
  wake_.notify_all();
}

WorldSample WorldFiles::sample_of(const worlds::Orientation& received, HostNs now) const {
  WorldSample sample;
  sample.session = 1;
  sample.answered_ns = now;
  sample.has_ground = true;
  sample.height_m = received.pose.z_m;
  sample.roll_rad = received.pose.roll_rad;
  sample.pitch_rad = received.pose.pitch_rad;
  if (run_.parameters.owns_pose && received.has_turn && received.has_place) {
    sample.has_pose = true;
    sample.pose = received.pose;
  }
  return sample;
}

}  // namespace

std::unique_ptr<WorldLink> open_world_files(const config::WorldRun& run, config::GiveWorld give,
                                            messages::EventQueue& events) {
  return std::make_unique<WorldFiles>(run, std::move(give), events);
}

}  // namespace tp100::live
