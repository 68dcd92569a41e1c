#include "record/recorder.h"

#include <pthread.h>

#include <algorithm>
#include <chrono>
#include <deque>
#include <exception>
#include <future>
#include <mutex>
#include <thread>
#include <utility>
#include <variant>

#include "core/clock.h"
#include "core/error.h"
#include "record/record_queue.h"
#include "record/step_codec.h"

namespace tp100::record {
namespace {

constexpr std::size_t kQueueBytes = std::size_t{16} << 20;
constexpr auto kTakeTimeout = std::chrono::milliseconds(50);
constexpr std::size_t kMaxRequests = 16;
// Most bytes of inputs of earlier steps in a recording that looks back: twenty minutes.
constexpr std::uint64_t kMaxBeforeLookBack = 50'000'000;
constexpr const char* kSlow = "the disk has not served earlier requests; try again later";

// Requests to the recorder's thread.
struct Begin {
  std::uint64_t number;
  Recorder::Make make;
  Recorder::Answer answer;
  std::uint64_t dropped;  // before it
};
struct LookBack {
  std::uint64_t number;
  Recorder::Make make;
  Recorder::Ended ended;
};
struct End {
  Recorder::Answer answer = [](const std::string&) {};
};
struct Forget {
  std::uint64_t next;  // the steps before this one
};
using Request = std::variant<Begin, LookBack, End, Forget>;

}  // namespace

struct Recorder::State {
  explicit State(const RecorderSettings& settings)
      : queue(kQueueBytes, settings.blocking), recent(settings.look_back_ns) {
    if (settings.history) history.emplace(*settings.history);
    thread = std::thread([this] { run(); });
    ::pthread_setname_np(thread.native_handle(), "recorder");
  }

  /// An entry of the queue; `fill` appends its content.
  template <class Fill>
  static const Bytes& entry_of(EntryKind kind, Fill fill) {
    thread_local Bytes entry;
    entry.clear();
    ByteWriter out(entry);
    out.number(static_cast<std::uint8_t>(kind));
    out.number<std::uint32_t>(0);
    fill(entry);
    out.patch(1, static_cast<std::uint32_t>(entry.size() - kHead));
    return entry;
  }
  template <class Fill>
  void put(EntryKind kind, Fill fill) {
    if (queue.put(entry_of(kind, fill))) return;
    const std::lock_guard lock(mutex);
    ++dropped;
  }

  /// Marks where a recording begins or ends in the queue. Call with the mutex held.
  void request(Request request) {
    requests.push_back(std::move(request));
    queue.mark(entry_of(EntryKind::kRequest, [](const Bytes&) {}));
  }

  /// Asks for a recording by the request that `of` makes with its number. Returns that; 0: it is
  /// refused, and `refused` has received why.
  template <class Of>
  std::uint64_t ask(bool looks_back, Of of, const Recorder::Answer& refused) {
    std::string why;
    {
      const std::lock_guard lock(mutex);
      if (number != 0 && (looks_back || !makes_way)) {
        why = "a recording is running already" + (status.active ? ": " + status.path : "");
      } else if (requests.size() >= kMaxRequests) {
        why = kSlow;
      } else {
        if (number != 0) request(End{});
        makes_way = looks_back;
        number = ++last_number;
        request(of(number));
        return number;
      }
    }
    refused(why);
    return 0;
  }
  /// Number of the recording that others see. Call with the mutex held.
  std::uint64_t shown() const { return makes_way ? 0 : number; }

  void run() {
    Bytes taken;
    for (bool more = true; more;) {
      more = queue.take(taken, kTakeTimeout);
      ByteReader in(taken);
      while (in.left() > 0) {
        const auto kind = static_cast<EntryKind>(in.number<std::uint8_t>());
        const auto payload = in.bytes(in.number<std::uint32_t>());
        guarded([&] { take(kind, payload); });
      }
      guarded([&] { report(); });
    }
  }
  // An error such as lack of memory must not stop the robot.
  template <class Part>
  void guarded(Part part) {
    try {
      try {
        part();
      } catch (const std::exception& error) {
        fail(error);
      }
    } catch (...) {
      // There is not even memory for the message.
    }
  }
  void fail(const std::exception& error) {
    const std::string path = writer == nullptr ? std::string() : writer->path();
    writer.reset();
    history.reset();
    recent.take();
    const Recorder::Ended looked_back = std::exchange(ended, {});
    const std::string warning = path + ": recording stopped (" + error.what() + ")";
    {
      const std::lock_guard lock(mutex);
      if (!looked_back && !path.empty()) {
        status.active = false;
        status.warning = warning;
      }
      if (number == writing) number = 0;
    }
    if (looked_back) looked_back({.path = path, .warning = warning});
  }
  void serve() {
    Request request;
    {
      const std::lock_guard lock(mutex);
      request = std::move(requests.front());
      requests.pop_front();
    }
    std::visit([this](auto& one) { serve(one); }, request);
  }
  void serve(Begin& request) {
    const std::string why = open(request.number, request.make);
    if (why.empty()) {
      const std::lock_guard lock(mutex);
      status = {
          .active = true, .path = writer->path(), .bytes = writer->bytes(), .cpu_s = status.cpu_s};
      dropped_before = request.dropped;
    }
    request.answer(why);
    if (why.empty()) write_before();
  }
  void serve(LookBack& request) {
    if (const std::string why = open(request.number, request.make); !why.empty())
      return request.ended({.warning = why});
    ended = std::move(request.ended);
    write_before();
  }
  void serve(End& request) { request.answer(finish()); }
  void serve(Forget& request) {
    if (history) history->forget(request.next);
    recent.take();
    steps = 0;
  }
  /// Creates the recording's file. Returns why not.
  std::string open(std::uint64_t of, const Recorder::Make& make) {
    try {
      writer = make();
    } catch (const std::exception& error) {
      const std::lock_guard lock(mutex);
      if (number == of) number = 0;
      return error.what();
    }
    writing = of;
    ended = {};
    late.clear();
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
    const std::deque<Entry> again = ended ? recent.take() : std::deque<Entry>{};
    const auto oldest = std::ranges::find(again, EntryKind::kStep, &Entry::kind);
    std::uint64_t first = last_step + 1;
    HostNs at_ns = last_ns;
    if (oldest != again.end()) {
      decode_step(oldest->payload, *record);
      first = record->step;
      at_ns = record->now_ns;
    }
    const std::string lost = history
                                 ? history->read(first, ended ? kMaxBeforeLookBack : UINT64_MAX,
                                                 [&](auto block) { writer->before(at_ns, block); })
                                 : "no history";
    if (!lost.empty())
      late = "it cannot be replayed: the earlier steps were not kept (" + lost + ")";
    for (const Entry& entry : again) write(entry.kind, entry.payload);
  }
  void take(EntryKind kind, std::span<const std::uint8_t> payload) {
    if (kind == EntryKind::kRequest) return serve();
    if (kind == EntryKind::kStep) {
      decode_step(payload, *record);
      ++steps;
      last_step = record->step;
      last_ns = record->now_ns;
      if (history) history->add(*record);
    }
    recent.add(last_ns, kind, payload);
    if (writer == nullptr) return;
    if (kind == EntryKind::kStep) return writer->step(*record, payload);
    write(kind, payload);
  }
  void write(EntryKind kind, std::span<const std::uint8_t> payload) {
    ByteReader in(payload);
    switch (kind) {
      case EntryKind::kRequest:
        break;
      case EntryKind::kStep:
        decode_step(payload, *record);
        writer->step(*record, payload);
        break;
      case EntryKind::kTruth: {
        messages::Truth truth;
        truth.at_ns = in.number<HostNs>();
        visit_fields([&](auto, double& value) { value = in.number<double>(); }, truth.pose);
        writer->truth(truth);
        break;
      }
      case EntryKind::kMessage: {
        const auto channel = static_cast<messages::Channel>(in.number<std::uint32_t>());
        const auto at = in.number<HostNs>();
        writer->message(channel, at, in.text());
        break;
      }
    }
  }
  void report() {
    RecordingStatus now;
    if (writer != nullptr) {
      now = {.active = writer->active(),
             .path = writer->path(),
             .bytes = writer->bytes(),
             .first_ns = writer->first_ns(),
             .warning = writer->warning()};
      if (now.warning.empty() && !late.empty()) now.warning = now.path + ": " + late;
      if (now.first_ns != 0) now.last_ns = last_ns;
    }
    now.cpu_s = to_s(thread_cpu_ns());
    const bool over = writer != nullptr && !now.active;
    if (over) writer.reset();
    {
      const std::lock_guard lock(mutex);
      if (now.path.empty() || ended) {
        status.cpu_s = now.cpu_s;
      } else {
        status = now;
      }
      if (over && number == writing) number = 0;
    }
    if (!over || !ended) return;
    recent.take();  // two recordings that look back share no step
    std::exchange(ended, {})(now);
  }

  static constexpr std::size_t kHead = 5;

  RecordQueue queue;
  // Used by the thread only:
  std::optional<StepHistory> history;
  RecentEntries recent;
  std::unique_ptr<RecordingWriter> writer;
  Recorder::Ended ended;  // of the writer's recording, if that looks back
  std::unique_ptr<StepRecord> record = std::make_unique<StepRecord>();
  std::uint64_t steps = 0, last_step = 0;
  HostNs last_ns = 0;
  std::string late;
  std::uint64_t writing = 0;  // number of the writer's recording

  mutable std::mutex mutex;  // guards what follows; never held while waiting for the disk
  std::deque<Request> requests;
  std::uint64_t number = 0, last_number = 0;
  bool makes_way = false;  // recording `number` looks back
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

std::uint64_t Recorder::ask_begin(Make make, const Answer& answer) {
  return state_->ask(
      false,
      [&](std::uint64_t number) {
        return Begin{number, std::move(make), answer, state_->dropped};
      },
      answer);
}

std::uint64_t Recorder::ask_look_back(Make make, const Ended& ended) {
  return state_->ask(
      true,
      [&](std::uint64_t number) {
        return LookBack{number, std::move(make), ended};
      },
      [&](const std::string& why) { ended({.warning = why}); });
}

void Recorder::ask_end(std::uint64_t number, Answer answer) {
  {
    const std::lock_guard lock(state_->mutex);
    // An end is never refused: each belongs to a begin that was accepted.
    if (number == 0 ? state_->shown() != 0 : number == state_->number) {
      state_->number = 0;
      return state_->request(End{std::move(answer)});
    }
  }
  answer("nothing is recorded");
}

void Recorder::forget(std::uint64_t next) {
  const std::lock_guard lock(state_->mutex);
  if (std::exchange(state_->number, 0) != 0) state_->request(End{});
  state_->request(Forget{next});
}

void Recorder::begin(Make make) {
  // Shared with an answer that may still be returning from the promise.
  const auto answered = std::make_shared<std::promise<std::string>>();
  ask_begin(std::move(make), [answered](const std::string& why) { answered->set_value(why); });
  if (const std::string why = answered->get_future().get(); !why.empty()) throw UserError(why);
}

void Recorder::begin(const RecordingSettings& recording, const RunFacts& facts) {
  begin([&] { return std::make_unique<RecordingWriter>(recording, facts); });
}

bool Recorder::end(Clock::time_point deadline) {
  const auto answered = std::make_shared<std::promise<void>>();
  {
    const std::lock_guard lock(state_->mutex);
    state_->number = 0;
    state_->request(End{[answered](const std::string&) { answered->set_value(); }});
  }
  return answered->get_future().wait_until(deadline) == std::future_status::ready;
}

void Recorder::take(const StepRecord& record) {
  state_->put(EntryKind::kStep, [&](Bytes& entry) { encode_step(record, entry); });
}

void Recorder::take_truth(HostNs at, const Pose& truth) {
  state_->put(EntryKind::kTruth, [&](Bytes& entry) {
    ByteWriter out(entry);
    out.number(at);
    visit_fields([&](auto, double value) { out.number(value); }, truth);
  });
}

void Recorder::message(messages::Channel channel, HostNs at, std::string_view json) {
  state_->put(EntryKind::kMessage, [&](Bytes& entry) {
    ByteWriter out(entry);
    out.number(static_cast<std::uint32_t>(channel));
    out.number(at);
    out.text(json);
  });
}

RecordingStatus Recorder::status() const {
  const std::lock_guard lock(state_->mutex);
  RecordingStatus status = state_->status;
  status.dropped = status.path.empty() ? 0 : state_->dropped - state_->dropped_before;
  return status;
}

std::uint64_t Recorder::number() const {
  const std::lock_guard lock(state_->mutex);
  return state_->shown();
}

}  // namespace tp100::record
