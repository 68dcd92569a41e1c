#include "publish/recorder.h"

#include <chrono>
#include <ctime>
#include <exception>
#include <filesystem>
#include <mutex>
#include <thread>
#include <utility>

#include "core/error.h"
#include "publish/record_queue.h"
#include "publish/step_codec.h"

namespace tp100::publish {
namespace {

constexpr std::size_t kQueueBytes = std::size_t{16} << 20;
constexpr auto kPatience = std::chrono::milliseconds(50);

enum class Kind : std::uint8_t { kStep, kTruth, kMessage };

constexpr double Pose::*kPose[] = {&Pose::x_m,      &Pose::y_m,       &Pose::z_m,
                                   &Pose::roll_rad, &Pose::pitch_rad, &Pose::yaw_rad};

double thread_cpu_s() {
  timespec used{};
  ::clock_gettime(CLOCK_THREAD_CPUTIME_ID, &used);
  return static_cast<double>(used.tv_sec) + static_cast<double>(used.tv_nsec) * 1e-9;
}

}  // namespace

struct Recorder::State {
  State(const RecorderSettings& settings, const RunFacts& facts)
      : path(settings.recording.path),
        writer(settings.recording, facts),
        queue(kQueueBytes, settings.patient) {
    status.active = true;
    status.bytes = writer.bytes();
    thread = std::thread([this] { run(); });
  }

  /// An entry of the queue; `fill` appends its content.
  template <class Fill>
  void put(Kind kind, Fill fill) {
    thread_local Bytes entry;
    entry.clear();
    ByteWriter out(entry);
    out.number(static_cast<std::uint8_t>(kind));
    out.number<std::uint32_t>(0);
    fill(entry);
    out.patch(1, static_cast<std::uint32_t>(entry.size() - kHead));
    if (queue.put(entry)) return;
    const std::lock_guard lock(mutex);
    ++status.dropped;
  }

  void run() {
    try {
      Bytes taken;
      for (bool more = true; more;) {
        more = queue.take(taken, kPatience);
        write(taken);
        if (!more) writer.finish();
        report();
      }
    } catch (const std::exception& error) {
      // Out of memory, for instance: the robot must not stop for it.
      queue.end();
      const std::lock_guard lock(mutex);
      status.active = false;
      status.warning = path + ": recording stopped (" + error.what() + ")";
    }
  }
  void write(std::span<const std::uint8_t> entries) {
    ByteReader in(entries);
    while (in.left() > 0) {
      const auto kind = static_cast<Kind>(in.number<std::uint8_t>());
      const auto payload = in.bytes(in.number<std::uint32_t>());
      switch (kind) {
        case Kind::kStep:
          decode_step(payload, *record);
          writer.step(*record, payload);
          break;
        case Kind::kTruth:
          write_truth(ByteReader(payload));
          break;
        case Kind::kMessage:
          write_message(ByteReader(payload));
          break;
      }
    }
  }
  void write_truth(ByteReader in) {
    Truth truth;
    truth.at_ns = in.number<HostNs>();
    for (double Pose::*value : kPose) truth.pose.*value = in.number<double>();
    writer.truth(truth);
  }
  void write_message(ByteReader in) {
    const auto channel = static_cast<Channel>(in.number<std::uint32_t>());
    const auto at = in.number<HostNs>();
    writer.message(channel, at, in.text());
  }
  void report() {
    const std::lock_guard lock(mutex);
    status.active = writer.active();
    status.bytes = writer.bytes();
    status.warning = writer.warning();
    status.last_ns = record->now_ns;
    status.cpu_s = thread_cpu_s();
  }

  static constexpr std::size_t kHead = 5;

  std::string path;
  RecordingWriter writer;
  RecordQueue queue;
  std::unique_ptr<StepRecord> record = std::make_unique<StepRecord>();
  std::mutex ending;
  mutable std::mutex mutex;
  RecordingStatus status;
  std::thread thread;
};

Recorder::Recorder(const RecorderSettings& settings, const RunFacts& facts)
    : state_(std::make_unique<State>(settings, facts)) {}

Recorder::~Recorder() { finish(); }

void Recorder::take(const StepRecord& record) {
  state_->put(Kind::kStep, [&](Bytes& entry) { encode_step(record, entry); });
}

void Recorder::take_truth(HostNs at, const Pose& truth) {
  state_->put(Kind::kTruth, [&](Bytes& entry) {
    ByteWriter out(entry);
    out.number(at);
    for (double Pose::*value : kPose) out.number(truth.*value);
  });
}

void Recorder::message(Channel channel, HostNs at, std::string_view json) {
  state_->put(Kind::kMessage, [&](Bytes& entry) {
    ByteWriter out(entry);
    out.number(static_cast<std::uint32_t>(channel));
    out.number(at);
    out.text(json);
  });
}

void Recorder::finish() {
  const std::lock_guard lock(state_->ending);
  if (!state_->thread.joinable()) return;
  state_->queue.end();
  state_->thread.join();
}

void Recorder::discard() {
  finish();
  std::error_code ignored;
  std::filesystem::remove(state_->path, ignored);
  std::filesystem::remove(std::filesystem::path(state_->path).parent_path(), ignored);
}

RecordingStatus Recorder::status() const {
  const std::lock_guard lock(state_->mutex);
  return state_->status;
}

const std::string& Recorder::path() const { return state_->path; }

}  // namespace tp100::publish
