#include "live/world_files.h"

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

}  // namespace

struct WorldFiles::State {
  State(const config::WorldRun& r, config::GiveWorld action, messages::EventQueue& queue)
      : run(r),
        give(std::move(action)),
        events(queue),
        orientation(run.settings.orientation_file) {}

  void live() {
    std::unique_lock lock(mutex);
    while (!ending) {
      wake.wait_for(lock, kLook, [this] { return ending || text.has_value(); });
      const std::optional<std::string> next = std::exchange(text, std::nullopt);
      lock.unlock();
      const std::string error =
          next ? replace_file(run.settings.encoder_file, *next) : std::string();
      const std::optional<std::string> seen = orientation.look();
      const HostNs now = monotonic_now();
      const auto orientation_seen =
          seen
              ? worlds::orientation_of(*seen, run.settings.orientation_template, run.settings.frame)
              : std::nullopt;
      const bool given = orientation_seen && give(sample_of(*orientation_seen, now));
      lock.lock();
      if (next) ++(error.empty() ? counters.written : counters.write_errors);
      if (seen) ++(orientation_seen ? counters.read : counters.rejected);
      if (orientation_seen && !given) ++counters.dropped;
      if (!error.empty() && !std::exchange(reported_write, true)) events.note(error, kInfo);
      if (seen && !orientation_seen && !std::exchange(reported_read, true))
        events.note(
            run.settings.orientation_file + ": cannot be parsed; see world.orientation_template",
            kInfo);
    }
    ended = true;
    wake.notify_all();
  }

  WorldSample sample_of(const worlds::Orientation& received, HostNs now) const {
    WorldSample sample;
    sample.session = 1;
    sample.answered_ns = now;
    sample.has_ground = true;
    sample.height_m = received.pose.z_m;
    sample.roll_rad = received.pose.roll_rad;
    sample.pitch_rad = received.pose.pitch_rad;
    if (run.parameters.owns_pose && received.has_turn && received.has_place) {
      sample.has_pose = true;
      sample.pose = received.pose;
    }
    return sample;
  }

  const config::WorldRun run;
  const config::GiveWorld give;
  messages::EventQueue& events;
  Watched orientation;  // used by the thread only
  HostNs next_ns = 0;   // used by take() only

  mutable std::mutex mutex;
  std::condition_variable wake;
  std::optional<std::string> text;
  WorldFileCounters counters;
  bool reported_write = false, reported_read = false;
  bool ending = false, ended = false;
  std::thread thread;
};

WorldFiles::WorldFiles(const config::WorldRun& run, config::GiveWorld give,
                       messages::EventQueue& events)
    : state_(std::make_unique<State>(run, std::move(give), events)) {
  const config::WorldSettings& settings = run.settings;
  worlds::require_encoder_template(settings.encoder_template, "world.encoder_template");
  worlds::require_orientation_template(settings.orientation_template, "world.orientation_template");
  if (const std::string why = replace_file(settings.encoder_file, "\n"); !why.empty())
    throw UserError("world.encoder_file " + why);
  state_->thread = std::thread([state = state_.get()] { state->live(); });
  ::pthread_setname_np(state_->thread.native_handle(), "world files");
}

WorldFiles::~WorldFiles() {
  stop();
  if (state_->thread.joinable()) state_->thread.join();
}

void WorldFiles::stop() {
  {
    const std::lock_guard lock(state_->mutex);
    state_->ending = true;
  }
  state_->wake.notify_one();
}

bool WorldFiles::ended_by(std::chrono::steady_clock::time_point deadline) {
  std::unique_lock lock(state_->mutex);
  return state_->wake.wait_until(lock, deadline, [this] { return state_->ended; });
}

void WorldFiles::take(const StepRecord& record) {
  if (record.now_ns < state_->next_ns) return;
  state_->next_ns = record.now_ns + from_s(1.0 / state_->run.settings.rate_hz);
  std::string text = worlds::encoder_text(state_->run.settings.encoder_template, record,
                                          state_->run.settings.frame);
  {
    const std::lock_guard lock(state_->mutex);
    state_->text = std::move(text);
  }
  state_->wake.notify_one();
}

WorldFigures WorldFiles::figures() const {
  const std::lock_guard lock(state_->mutex);
  return {.files = state_->counters};
}

}  // namespace tp100::live
