#include "record/recorder.h"

#include <chrono>
#include <condition_variable>
#include <ctime>
#include <deque>
#include <exception>
#include <future>
#include <mutex>
#include <thread>
#include <utility>

#include "core/error.h"
#include "record/record_queue.h"
#include "record/step_codec.h"
#include "record/step_journal.h"

namespace tp100::record {
namespace {

constexpr std::size_t kQueueBytes = std::size_t{16} << 20;
constexpr auto kPatience = std::chrono::milliseconds(50);
constexpr std::size_t kMostRequests = 16;
constexpr const char* kSlow = "the disk has not served earlier requests; try again later";

enum class Kind : std::uint8_t { kRequest, kStep, kTruth, kMessage };

/// To begin a recording, or without `make` to end it.
struct Request {
  std::uint64_t number;
  Recorder::Make make;
  Recorder::Answer answer;
  std::uint64_t dropped;  // before it
};

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
    ++dropped;
  }

  /// Where a recording begins or ends: between what was put before and after. With the mutex held.
  void request(Request request) {
    requests.push_back(std::move(request));
    Bytes entry;
    ByteWriter out(entry);
    out.number(static_cast<std::uint8_t>(Kind::kRequest));
    out.number<std::uint32_t>(0);
    queue.mark(entry);
  }

  void run() {
    Bytes taken;
    for (bool more = true; more;) {
      more = queue.take(taken, kPatience);
      ByteReader in(taken);
      while (in.left() > 0) {
        const auto kind = static_cast<Kind>(in.number<std::uint8_t>());
        const auto payload = in.bytes(in.number<std::uint32_t>());
        try {
          write(kind, payload);
        } catch (const std::exception& error) {
          fail(error);
        }
      }
      report();
    }
  }
  // Out of memory, for instance: the robot must not stop for it.
  void fail(const std::exception& error) {
    writer.reset();
    journal.reset();
    const std::lock_guard lock(mutex);
    status.active = false;
    status.warning = status.path + ": recording stopped (" + error.what() + ")";
    if (number == writing) number = 0;
  }
  void serve() {
    Request request;
    {
      const std::lock_guard lock(mutex);
      request = std::move(requests.front());
      requests.pop_front();
    }
    const std::string why = request.make ? begin(request) : finish();
    request.answer(why);
    if (request.make && why.empty()) write_before();
  }
  std::string begin(const Request& request) {
    try {
      writer = request.make();
    } catch (const std::exception& error) {
      const std::lock_guard lock(mutex);
      if (number == request.number) number = 0;
      return error.what();
    }
    writing = request.number;
    late.clear();
    const std::lock_guard lock(mutex);
    status = {
        .active = true, .path = writer->path(), .bytes = writer->bytes(), .cpu_s = status.cpu_s};
    dropped_before = request.dropped;
    return {};
  }
  std::string finish() {
    if (writer == nullptr) return "nothing is recorded";
    try {
      writer->finish();
    } catch (const std::exception& error) {
      fail(error);
    }
    report();
    return {};
  }
  void write_before() {
    if (steps == 0) return;
    std::string lost = journal == nullptr ? std::string("nobody kept them") : journal->problem();
    if (lost.empty()) {
      journal->read(
          [this](std::span<const std::uint8_t> block) { writer->before(record->now_ns, block); });
      lost = journal->problem();
    }
    if (!lost.empty()) late = "it cannot be replayed, the steps before it are lost (" + lost + ")";
  }
  void write(Kind kind, std::span<const std::uint8_t> payload) {
    switch (kind) {
      case Kind::kRequest:
        serve();
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
  void write_truth(ByteReader in) {
    messages::Truth truth;
    truth.at_ns = in.number<HostNs>();
    for (double Pose::*value : kPose) truth.pose.*value = in.number<double>();
    if (writer != nullptr) writer->truth(truth);
  }
  void write_message(ByteReader in) {
    const auto channel = static_cast<messages::Channel>(in.number<std::uint32_t>());
    const auto at = in.number<HostNs>();
    if (writer != nullptr) writer->message(channel, at, in.text());
  }
  void report() {
    std::unique_ptr<RecordingWriter> ended;  // its file is closed without the lock
    const std::lock_guard lock(mutex);
    status.cpu_s = thread_cpu_s();
    if (writer == nullptr) return;
    status.active = writer->active();
    status.bytes = writer->bytes();
    status.warning = writer->warning();
    if (status.warning.empty() && !late.empty()) status.warning = status.path + ": " + late;
    status.first_ns = writer->first_ns();
    if (status.first_ns != 0) status.last_ns = record->now_ns;
    if (status.active) return;
    ended = std::move(writer);
    if (number == writing) number = 0;
  }

  static constexpr std::size_t kHead = 5;

  RecordQueue queue;
  // Of the thread.
  std::unique_ptr<StepJournal> journal;
  std::unique_ptr<RecordingWriter> writer;
  std::unique_ptr<StepRecord> record = std::make_unique<StepRecord>();
  std::uint64_t steps = 0;
  std::string late;
  std::uint64_t writing = 0;  // number of the writer's recording

  mutable std::mutex mutex;  // of what follows; never held while the disk is waited for
  std::deque<Request> requests;
  std::uint64_t number = 0, last_number = 0;
  std::uint64_t dropped = 0, dropped_before = 0;
  RecordingStatus status;
  std::thread thread;
};

Recorder::Recorder(const RecorderSettings& settings) : state_(std::make_unique<State>(settings)) {}

Recorder::~Recorder() {
  end();
  state_->queue.end();
  state_->thread.join();
}

std::uint64_t Recorder::ask_begin(Make make, Answer answer) {
  std::string why;
  {
    const std::lock_guard lock(state_->mutex);
    if (state_->number != 0) {
      why = "a recording is running already";
      if (state_->status.active) why += ": " + state_->status.path;
    } else if (state_->requests.size() >= kMostRequests) {
      why = kSlow;
    } else {
      state_->number = ++state_->last_number;
      state_->request({state_->number, std::move(make), std::move(answer), state_->dropped});
      return state_->number;
    }
  }
  answer(why);
  return 0;
}

void Recorder::ask_end(std::uint64_t number, Answer answer) {
  std::string why;
  {
    const std::lock_guard lock(state_->mutex);
    if (state_->number == 0 || (number != 0 && number != state_->number)) {
      why = "nothing is recorded";
    } else if (state_->requests.size() >= kMostRequests) {
      why = kSlow;
    } else {
      state_->request({std::exchange(state_->number, 0), {}, std::move(answer), 0});
      return;
    }
  }
  answer(why);
}

void Recorder::begin(Make make) {
  // Shared with an answer that may still be returning from the promise.
  const auto answered = std::make_shared<std::promise<std::string>>();
  ask_begin(std::move(make), [answered](const std::string& why) { answered->set_value(why); });
  if (const std::string why = answered->get_future().get(); !why.empty()) throw SetupError(why);
}

void Recorder::begin(const RecordingSettings& recording, const RunFacts& facts) {
  begin([&] { return std::make_unique<RecordingWriter>(recording, facts); });
}

bool Recorder::end(Clock::time_point deadline) {
  const auto answered = std::make_shared<std::promise<void>>();
  {
    const std::lock_guard lock(state_->mutex);
    state_->request({std::exchange(state_->number, 0),
                     {},
                     [answered](const std::string&) { answered->set_value(); },
                     0});
  }
  return answered->get_future().wait_until(deadline) == std::future_status::ready;
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

void Recorder::message(messages::Channel channel, HostNs at, std::string_view json) {
  state_->put(Kind::kMessage, [&](Bytes& entry) {
    ByteWriter out(entry);
    out.number(static_cast<std::uint32_t>(channel));
    out.number(at);
    out.text(json);
  });
}

RecordingStatus Recorder::status() const {
  const std::lock_guard lock(state_->mutex);
  RecordingStatus status = state_->status;
  status.dropped = state_->dropped - state_->dropped_before;
  return status;
}

std::uint64_t Recorder::number() const {
  const std::lock_guard lock(state_->mutex);
  return state_->number;
}

}  // namespace tp100::record
