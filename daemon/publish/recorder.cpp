#include "publish/recorder.h"

#include <chrono>
#include <condition_variable>
#include <ctime>
#include <exception>
#include <mutex>
#include <thread>
#include <utility>

#include "core/error.h"
#include "publish/record_queue.h"
#include "publish/recording_file.h"
#include "publish/step_codec.h"
#include "publish/step_journal.h"

namespace tp100::publish {
namespace {

constexpr std::size_t kQueueBytes = std::size_t{16} << 20;
constexpr auto kPatience = std::chrono::milliseconds(50);

enum class Kind : std::uint8_t { kBegin, kEnd, kStep, kTruth, kMessage };

constexpr double Pose::*kPose[] = {&Pose::x_m,      &Pose::y_m,       &Pose::z_m,
                                   &Pose::roll_rad, &Pose::pitch_rad, &Pose::yaw_rad};

double thread_cpu_s() {
  timespec used{};
  ::clock_gettime(CLOCK_THREAD_CPUTIME_ID, &used);
  return static_cast<double>(used.tv_sec) + static_cast<double>(used.tv_nsec) * 1e-9;
}

}  // namespace

struct Recorder::State {
  explicit State(const RecorderSettings& settings) : queue(kQueueBytes, settings.patient) {
    if (!settings.journal_folder.empty())
      journal = std::make_unique<StepJournal>(settings.journal_folder, settings.journal_bytes);
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

  /// Where a recording begins or ends: between what was put before and after.
  void mark(Kind kind) {
    Bytes entry;
    ByteWriter out(entry);
    out.number(static_cast<std::uint8_t>(kind));
    out.number<std::uint32_t>(0);
    queue.mark(entry);
  }

  void run() {
    Bytes taken;
    for (bool more = true; more;) {
      try {
        more = queue.take(taken, kPatience);
        write(taken);
        report();
      } catch (const std::exception& error) {
        // Out of memory, for instance: the robot must not stop for it.
        writer.reset();
        journal.reset();
        const std::lock_guard lock(mutex);
        status.active = false;
        status.warning = path + ": recording stopped (" + error.what() + ")";
        changed.notify_all();
      }
    }
  }
  void begin() {
    {
      const std::lock_guard lock(mutex);
      writer = std::move(asked);
    }
    late.clear();
    if (steps == 0) return;
    std::string lost = journal == nullptr ? std::string("nobody kept them") : journal->problem();
    if (lost.empty()) {
      journal->read(
          [this](std::span<const std::uint8_t> block) { writer->before(record->now_ns, block); });
      lost = journal->problem();
    }
    if (!lost.empty()) late = "it cannot be replayed, the steps before it are lost (" + lost + ")";
  }
  void write(std::span<const std::uint8_t> entries) {
    ByteReader in(entries);
    while (in.left() > 0) {
      const auto kind = static_cast<Kind>(in.number<std::uint8_t>());
      const auto payload = in.bytes(in.number<std::uint32_t>());
      switch (kind) {
        case Kind::kBegin:
          begin();
          break;
        case Kind::kEnd:
          if (writer != nullptr) writer->finish();
          report();
          break;
        case Kind::kStep:
          decode_step(payload, *record);
          ++steps;
          if (journal != nullptr) journal->add(*record);
          if (writer != nullptr) writer->step(*record, payload);
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
    if (writer != nullptr) writer->truth(truth);
  }
  void write_message(ByteReader in) {
    const auto channel = static_cast<Channel>(in.number<std::uint32_t>());
    const auto at = in.number<HostNs>();
    if (writer != nullptr) writer->message(channel, at, in.text());
  }
  void report() {
    const std::lock_guard lock(mutex);
    status.cpu_s = thread_cpu_s();
    if (writer == nullptr) return;
    status.active = writer->active();
    status.bytes = writer->bytes();
    status.warning = writer->warning();
    if (status.warning.empty() && !late.empty()) status.warning = path + ": " + late;
    status.last_ns = record->now_ns;
    if (status.active) return;
    writer.reset();
    changed.notify_all();
  }

  static constexpr std::size_t kHead = 5;

  RecordQueue queue;
  // Of the thread.
  std::unique_ptr<StepJournal> journal;
  std::unique_ptr<RecordingWriter> writer;
  std::unique_ptr<StepRecord> record = std::make_unique<StepRecord>();
  std::uint64_t steps = 0;
  std::string late;

  mutable std::mutex mutex;  // of what follows
  std::condition_variable changed;
  std::string path;
  std::unique_ptr<RecordingWriter> asked;
  RecordingStatus status;
  std::thread thread;
};

Recorder::Recorder(const RecorderSettings& settings) : state_(std::make_unique<State>(settings)) {}

Recorder::~Recorder() {
  end();
  state_->queue.end();
  state_->thread.join();
}

void Recorder::begin(const RecordingSettings& recording, const RunFacts& facts) {
  auto writer = std::make_unique<RecordingWriter>(recording, facts);
  const std::lock_guard lock(state_->mutex);
  state_->path = recording.path;
  state_->status = {.active = true, .bytes = writer->bytes(), .cpu_s = state_->status.cpu_s};
  state_->asked = std::move(writer);
  state_->mark(Kind::kBegin);
}

void Recorder::end() {
  std::unique_lock lock(state_->mutex);
  if (!state_->status.active) return;
  state_->mark(Kind::kEnd);
  state_->changed.wait(lock, [this] { return !state_->status.active; });
}

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

void Recorder::discard() {
  end();
  remove_recording(path());
}

RecordingStatus Recorder::status() const {
  const std::lock_guard lock(state_->mutex);
  return state_->status;
}

std::string Recorder::path() const {
  const std::lock_guard lock(state_->mutex);
  return state_->path;
}

}  // namespace tp100::publish
