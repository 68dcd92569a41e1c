#include "server/publisher.h"

#include <algorithm>
#include <initializer_list>
#include <utility>

#include "messages/foxglove.h"
#include "messages/status_messages.h"

namespace tp100::server {
namespace {

using messages::Channel;
using messages::Event;
using messages::RecordingFigures;
using messages::StateFigures;
using Status = messages::StopFigures::Status;

constexpr HostNs kMarkNs = 100 * kNsPerMs;
constexpr HostNs kWindowNs = kNsPerS;

std::uint64_t bad(const LinkCounters& link) {
  return link.corrupted() + link.unknown_type + link.wrong_size + link.implausible;
}

constexpr HostNs kStopEventNs = 100 * kNsPerMs;

/// The fields whose change makes a state message due at once.
std::string key_of(const StateFigures& state) {
  std::string key;
  for (const std::uint64_t part : std::initializer_list<std::uint64_t>{
           state.faults, state.robot_faults, static_cast<unsigned>(state.run),
           static_cast<unsigned>(state.session), static_cast<unsigned>(state.steering),
           state.robot ? static_cast<unsigned>(*state.robot) : 99U,
           static_cast<unsigned>(state.stop.status), state.stop.latched, state.stop.count,
           state.can_record, state.motors_on, state.confirm_start, state.driver.fresh,
           state.pause_left_s > 0.0, static_cast<unsigned>(state.start_places.unsaid),
           static_cast<unsigned>(state.start_places.placed),
           static_cast<unsigned>(state.start_places.here)})
    key += std::to_string(part) + ' ';
  return key + state.why_not_start + '\n' + state.why_not_drive + '\n' + state.driver.by + '\n' +
         state.driver.asked_by;
}

}  // namespace

void LinkMeter::take(const StepRecord& record) {
  last_.session = record.inputs.session;
  last_.counters = record.link;
  last_.clock = record.inputs.clock;
  last_ns_ = record.now_ns;
  if (!marks_.empty() && last_ns_ - marks_.back().at_ns < kMarkNs) return;
  marks_.push_back({last_ns_, record.link});
  while (marks_.size() > 1 && last_ns_ - marks_.front().at_ns > kWindowNs) marks_.pop_front();
}

messages::LinkFigures LinkMeter::figures() const {
  messages::LinkFigures out = last_;
  if (marks_.empty() || last_ns_ <= marks_.front().at_ns) return out;
  const LinkCounters &then = marks_.front().counters, &now = last_.counters;
  const double window_s = to_s(last_ns_ - marks_.front().at_ns);
  const auto rate = [&](std::uint64_t from, std::uint64_t to) {
    return to < from ? 0.0 : static_cast<double>(to - from) / window_s;
  };
  out.samples_hz = rate(then.samples, now.samples);
  out.lost_hz = rate(then.lost, now.lost);
  out.bad_hz = rate(bad(then), bad(now));
  out.in_bytes_ps = rate(then.bytes_in, now.bytes_in);
  out.out_bytes_ps = rate(then.bytes_out, now.bytes_out);
  return out;
}

void StopMonitor::press(const std::string& by, HostNs now) {
  figures_.by = by;
  figures_.latched = true;
  pressed_ns_ = now;
  if (unanswered()) return;
  figures_.requested_ns = now;
  figures_.status = Status::kPending;
  answered(answered_ns_);
}

void StopMonitor::answered(HostNs at) {
  answered_ns_ = std::max(answered_ns_, at);
  // An acknowledgement from before the press belongs to an older STOP.
  if (!unanswered() || at < figures_.requested_ns) return;
  figures_.status = Status::kAcknowledged;
  figures_.acknowledged_ms = to_s(at - figures_.requested_ns) * 1e3;
}

bool StopMonitor::tick(HostNs now) {
  if (figures_.status != Status::kPending || now - figures_.requested_ns < kAnswerNs) return false;
  figures_.status = Status::kNotAcknowledged;
  return true;
}

bool History::due(Channel channel, HostNs now) const {
  const auto line = std::ranges::find(lines_, channel, &Line::channel);
  return line != lines_.end() && now >= line->due_ns;
}

void History::take(Channel channel, HostNs now, std::string_view json) {
  if (!due(channel, now)) return;
  Line& line = *std::ranges::find(lines_, channel, &Line::channel);
  line.due_ns = now + kIntervalNs;
  line.messages.push_back({now, std::string(json)});
  line.bytes += json.size();
  while (!line.messages.empty() &&
         (line.bytes > kMaxBytes || now - line.messages.front().at_ns > kSpanNs)) {
    line.bytes -= line.messages.front().json.size();
    line.messages.pop_front();
  }
}

std::optional<std::string> History::json(std::string_view topic, double span_s) const {
  const auto line = std::ranges::find(lines_, topic, &Line::topic);
  if (line == lines_.end()) return std::nullopt;
  std::string text = "[";
  text.reserve(line->bytes + line->messages.size() + 2);
  for (const Message& each : line->messages) {
    if (to_s(line->messages.back().at_ns - each.at_ns) > span_s) continue;
    if (text.size() > 1) text += ',';
    text += each.json;
  }
  return text + "]";
}

Publisher::Publisher(Broker& broker, messages::Messages messages, Controls& controls)
    : broker_(broker),
      messages_(std::move(messages)),
      step_messages_(messages_, false),
      controls_(controls) {
  publish_setup(messages::setup_messages(messages_, clock().start_ns), clock().start_ns);
  broker_.catch_up(Channel::kPathHistory, [this]() -> Broker::Message {
    if (whole_path_history_ == nullptr)
      whole_path_history_ =
          std::make_shared<const std::string>(path_history_.whole(clock(), last_step_ns_));
    return {clock().unix_ns(last_step_ns_), whole_path_history_};
  });
  state_.why_not_start = to_string(run_context().course == nullptr ? StartRefusal::kNoCourse
                                                                   : StartRefusal::kNoSession);
}

void Publisher::publish_setup(const messages::SharedMessages& setup, HostNs at) {
  for (const auto& [channel, text] : setup) broker_.publish(channel, clock().unix_ns(at), text);
  state_.length_m.reset();
  if (messages_.path() != nullptr) state_.length_m = messages_.path()->length_m();
}

void Publisher::exchange(messages::RunContext run_context, const messages::SharedMessages& setup,
                         HostNs now) {
  messages_ = messages::Messages(std::move(run_context), clock());
  path_history_.clear();
  publish_setup(setup, now);
  state_.progress_m = 0.0;
  state_.start_places = {};
  publish_state(now, true);
}

void Publisher::publish(Channel channel, HostNs at, std::string json) {
  history_.take(channel, at, json);
  broker_.publish(channel, clock().unix_ns(at), std::move(json));
}

void Publisher::take(const StepRecord& record) {
  last_step_ns_ = record.now_ns;
  link_.take(record);
  path_history_.add(record.snapshot);
  update_state(record);
  step_messages_.take(
      record,
      [&](Channel channel) {
        return broker_.wanted(channel, clock().unix_ns(record.now_ns)) ||
               history_.due(channel, record.now_ns);
      },
      [this](Channel channel, HostNs at, std::string json) {
        publish(channel, at, std::move(json));
      });
  publish_state(record.now_ns, false);
}

void Publisher::update_state(const StepRecord& record) {
  const Snapshot& snapshot = record.snapshot;
  const RunState before = std::exchange(state_.run, snapshot.run_state);
  if (armed(state_.run) && !armed(before)) run_began_ns_ = record.now_ns;
  if (armed(state_.run)) state_.run_s = to_s(record.now_ns - run_began_ns_);
  summary_.take(record);
  state_.largest_m = summary_.largest_m;
  if (under_way(state_.run)) stop_.under_way(record.now_ns, !under_way(before));
  state_.steering = snapshot.steering;
  state_.session = record.inputs.session;
  state_.robot = snapshot.has_sample ? std::optional(snapshot.sample.state) : std::nullopt;
  const bool battery_on = snapshot.has_sample && snapshot.sample.battery_v >= kBatteryOffV;
  state_.battery_v = battery_on ? std::optional(snapshot.sample.battery_v) : std::nullopt;
  state_.pose = snapshot.world;
  state_.pause_left_s = snapshot.pause_left_s;
  state_.progress_m = snapshot.progress_m;
  state_.start_places = snapshot.start_places;
  state_.onward_m = snapshot.onward_m;
  state_.faults = snapshot.faults;
  state_.robot_faults = snapshot.has_sample ? snapshot.sample.faults : 0;
  state_.motors_on = snapshot.has_sample && motors_on(snapshot.sample);
  state_.why_not_start = to_string(snapshot.start_refusal);
  state_.can_start = state_.why_not_start.empty();
  drive_refusal_ = snapshot.drive_refusal;
}

// A robot that is driven by hand can be taken over from a driver who gives no input.
std::string Publisher::why_not_drive() const {
  if (drive_refusal_ != StartRefusal::kDriven) return std::string(to_string(drive_refusal_));
  return state_.driver.fresh ? state_.driver.by + " drives" : std::string();
}

void Publisher::publish_state(HostNs now, bool always) {
  state_.stop = stop_.figures();
  state_.stop.count = controls_.stop_count();
  state_.driver = controls_.driver(now);
  state_.why_not_drive = why_not_drive();
  state_.confirm_start = controls_.start_consent() != StartConsent::kNone;
  std::string key = key_of(state_);
  if (!always && key == last_state_key_) return;
  last_state_key_ = std::move(key);
  state_due_.restart(now);
  publish(Channel::kState, now, messages::state_message(now, clock(), state_, run_context()));
}

void Publisher::take(const Event& event) {
  publish(Channel::kEvent, event.at_ns, messages_.event(event));
  publish(Channel::kLog, event.at_ns, messages::log_text(messages_, event));
}

void Publisher::take_image(HostNs at, std::string_view jpeg) {
  publish(Channel::kCameraImage, at, messages::image_text(messages_, at, jpeg));
}

void Publisher::take(messages::ClientsFigures figures, HostNs now) {
  for (messages::ClientFigures& each : figures.clients)
    for (const auto& viewer : broker_.viewers())
      if (viewer->id() == each.id) each.subscriptions = viewer->subscriptions();
  publish(Channel::kClient, now, messages::clients_message(figures));
}

void Publisher::failed(const std::string& why, HostNs now) {
  take(Event{.at_ns = now,
             .level = Event::Level::kError,
             .text = "the server could not do what a viewer asked for",
             .cause = why});
}

void Publisher::stop_pressed(const std::string& by, HostNs now) {
  stop_.press(by, now);
  publish_state(now, false);
  // Key repeats count as one press.
  if (now - last_stop_event_ns_ < kStopEventNs) return;
  last_stop_event_ns_ = now;
  take(Event{.at_ns = now,
             .kind = "stop",
             .level = Event::Level::kWarning,
             .text = "STOP pressed by " + by});
}

void Publisher::stop_answered(HostNs at, HostNs now) {
  stop_.answered(at);
  publish_state(now, false);
}

void Publisher::publish_recording(HostNs now) {
  const RecordingFigures recording = controls_.recording();
  const bool changed = recording.active != last_recording_.active ||
                       recording.available != last_recording_.available ||
                       recording.warning != last_recording_.warning ||
                       recording.run != last_recording_.run;
  const bool first = recording_due_.next_ns == 0;
  const bool again = recording.active && now >= recording_due_.next_ns;
  if (!changed && !first && !again) return;
  recording_due_.restart(now);
  last_recording_ = recording;
  state_.can_record = recording.available && !recording.active;
  publish(Channel::kRecording, now, messages::recording_message(recording));
}

void Publisher::tick(HostNs now) {
  if (stop_.unanswered()) stop_answered(controls_.motors_off_ns(), now);
  if (stop_.tick(now)) publish_state(now, true);
  publish_recording(now);
  if (state_due_.due(now)) publish_state(now, true);
  const bool link_due = link_due_.due(now), loop_due = loop_due_.due(now);
  if (link_due || loop_due) {
    const messages::LoopFigures loop = controls_.loop();
    if (loop_due)
      publish(Channel::kLoop, now, messages::loop_message(clock().t_s(now), loop, run_context()));
    if (link_due) {
      messages::LinkFigures link = link_.figures();
      link.port = controls_.port();
      link.sample_age = loop.sample_age;
      publish(Channel::kLink, now, messages::link_message(clock().t_s(now), link));
    }
  }
  if (path_history_due_.due(now)) {
    std::string update = path_history_.take_update(clock(), now);
    if (!update.empty()) {
      whole_path_history_.reset();
      publish(Channel::kPathHistory, now, std::move(update));
    }
  }
}

}  // namespace tp100::server
