#include "server/request_handler.h"

#include <algorithm>
#include <array>
#include <iterator>
#include <utility>

#include "text/json_writer.h"

namespace tp100::server {
namespace {

using messages::ParameterText;

constexpr HostNs kOverdueNs = 500 * kNsPerMs;
constexpr std::size_t kChangeBytes = 4096;  // what every viewer is told of a change
// With server.stop_unwatched: a run or a drive is stopped this long after the last sign of a page
// in sight.
constexpr HostNs kUnwatchedNs = 2 * kNsPerS;
constexpr const char* kSteering = "estimation.steering";

constexpr auto kStop = static_cast<std::uint32_t>(Service::kStop);
constexpr std::size_t kMaxWaiting = 1024;

std::string name_of(const Viewer& viewer) {
  return to_string(Requester{Door::kViewer, viewer.id()});
}

/// The response of stop.
std::string stop_answer(std::uint32_t call, const messages::StopFigures& stop) {
  const bool acknowledged = stop.status == messages::StopFigures::Status::kAcknowledged;
  return service_response(kStop, call, text::json_object([&](text::JsonWriter& json) {
                            json.field("acknowledged", acknowledged);
                            if (acknowledged) json.field("acknowledged_ms", stop.acknowledged_ms);
                          }));
}

}  // namespace

RequestHandler::RequestHandler(Broker& broker, Publisher& publisher, Controls& controls,
                               std::vector<ParameterText> parameters,
                               std::vector<ServiceRow> services, std::string session_id,
                               std::string name)
    : broker_(broker),
      publisher_(publisher),
      controls_(controls),
      parameters_(std::move(parameters)),
      services_(std::move(services)),
      session_id_(std::move(session_id)),
      name_(std::move(name)) {
  const auto tell = [&publisher](const messages::Event& event) { publisher.take(event); };
  std::ranges::move(motion_services(controls, tell), std::back_inserter(services_));
  const auto watch = [this](const Request& request) {
    watched_ns_ = request.now;
    return accepted(Done{});
  };
  constexpr ServiceRow::Rules kOpen{.permission = Permission::kStopOnly};
  services_.push_back(
      {Service::kStop, "stop", "{}", R"({"acknowledged":true,"acknowledged_ms":1.5})", {}, kOpen});
  // Whoever may stop the robot may say that it is watched.
  services_.push_back({Service::kWatch, "watch", "{}", kAccepted, watch, kOpen});
  std::ranges::sort(services_, {}, &ServiceRow::service);
  publish_parameters(publisher_.clock().start_ns);
}

void RequestHandler::send_server_info(Viewer& viewer, Permission permission) {
  const messages::RunContext& run_context = publisher_.run_context();
  viewer.reply(server_info(
      session_id_,
      {{"version", run_context.version},
       {"name", name_},
       {"course", run_context.course == nullptr ? std::string_view() : run_context.course->name},
       {"robot", run_context.robot.name},
       {"setup", run_context.setup},
       {"commands", permission == Permission::kCommand ? "yes" : "stop"},
       {"start_unix_ns", std::to_string(publisher_.clock().start_unix_ns)}}));
  viewer.reply(advertise(broker_.channels()));
  if (advertised_services_.empty()) {
    std::vector<ServiceText> texts;
    for (const ServiceRow& row : services_) texts.push_back(text_of(row));
    advertised_services_ = advertise_services(texts);
  }
  viewer.reply(advertised_services_);
}

bool RequestHandler::handle(const std::shared_ptr<Viewer>& viewer, const ClientMessage& message,
                            Permission permission, HostNs now) {
  if (const auto* subscribe = std::get_if<Subscribe>(&message)) {
    broker_.subscribe(*viewer, *subscribe);
  } else if (const auto* unsubscribe = std::get_if<Unsubscribe>(&message)) {
    broker_.unsubscribe(*viewer, *unsubscribe);
  } else if (const auto* get = std::get_if<GetParameters>(&message)) {
    viewer->reply(parameter_values(select(get->names), get->id));
  } else if (const auto* set = std::get_if<SetParameters>(&message)) {
    set_parameters(*viewer, *set, permission, now);
  } else if (const auto* watch = std::get_if<ParameterSubscription>(&message)) {
    watch_parameters(*viewer, *watch);
  } else if (const auto* call = std::get_if<ServiceCall>(&message)) {
    on(viewer, *call, permission, now);
  } else if (const auto* unserved = std::get_if<Unserved>(&message)) {
    viewer->say(StatusLevel::kWarning, "this server does not serve '" + unserved->what + "'");
  } else {
    viewer->say(StatusLevel::kError, std::get<Malformed>(message).why);
    return false;
  }
  return true;
}

void RequestHandler::leave(const Viewer& viewer, HostNs now) {
  controls_.drive_lost(name_of(viewer), now);
  watched_.erase(viewer.id());
}

void RequestHandler::send_answers() {
  std::vector<Answers::One> all;
  {
    const std::lock_guard lock(answers_->mutex);
    all.swap(answers_->answers);
  }
  for (Answers::One& each : all)
    if (const auto viewer = each.viewer.lock()) viewer->reply(std::move(each.message), each.binary);
}

void RequestHandler::on(const std::shared_ptr<Viewer>& viewer, const ServiceCall& call,
                        Permission permission, HostNs now) {
  if (call.service == kStop) return stop_pressed(viewer, call.call, now);
  const Answer answer = [answers = answers_, weak = std::weak_ptr(viewer), service = call.service,
                         number = call.call](const std::string& why, const std::string& json) {
    const bool done = why.empty();
    std::string message =
        done ? service_response(service, number, json) : service_failure(service, number, why);
    const std::lock_guard lock(answers->mutex);
    answers->answers.push_back({weak, std::move(message), done});
  };
  const Result<> begun = begin(call, viewer->id(), permission, now, answer);
  if (!begun) answer(begun.why(), {});
  send_answers();
}

Result<> RequestHandler::begin(const ServiceCall& call, std::uint32_t viewer, Permission permission,
                               HostNs now, const Answer& answer) const {
  const auto row =
      std::ranges::find(services_, static_cast<Service>(call.service), &ServiceRow::service);
  if (row == services_.end()) return Refusal{"there is no service " + std::to_string(call.service)};
  const ServiceRow::Rules& rules = row->rules;
  if (permission != Permission::kCommand && rules.permission == Permission::kCommand)
    return Refusal{"only stop is taken from this client (server.commands)"};
  if (call.encoding != "json") return Refusal{"the encoding must be json"};
  const Result<Request> request =
      read_request(*row, call.payload, viewer, publisher_.clock(), publisher_.state(), now);
  if (!request) return request.refusal();
  if (rules.at_rest && request->under_way()) return Refusal{kUnderWay};
  if (const Later* later = std::get_if<Later>(&row->does)) return (*later)(*request, answer);
  const Result<std::string> done = std::get<AtOnce>(row->does)(*request);
  if (!done) return done.refusal();
  answer({}, *done);
  return Done{};
}

void RequestHandler::stop_pressed(const std::shared_ptr<Viewer>& viewer, std::uint32_t call,
                                  HostNs at) {
  publisher_.stop_pressed(name_of(*viewer), at);
  if (waiting_.size() >= kMaxWaiting) {
    viewer->reply(stop_answer(call, publisher_.stop().figures()), true);
    return;
  }
  waiting_.push_back({viewer, call});
  tick(at);
}

void RequestHandler::stop_if_unwatched(HostNs now) {
  if (!under_way(publisher_.state().run)) watched_ns_ = now;
  if (!publisher_.run_context().stop_unwatched || now - watched_ns_ < kUnwatchedNs) return;
  watched_ns_ = now;
  controls_.stop();
  publisher_.stop_pressed("server.stop_unwatched", now);
}

void RequestHandler::tick(HostNs now) {
  stop_if_unwatched(now);
  correct_steering(now);
  send_answers();
  const messages::StopFigures& stop = publisher_.stop().figures();
  if (stop.status == messages::StopFigures::Status::kPending) return;
  for (const Waiting& each : std::exchange(waiting_, {}))
    if (const auto viewer = each.viewer.lock()) viewer->reply(stop_answer(each.call, stop), true);
}

void RequestHandler::publish_parameters(HostNs now) {
  broker_.publish(messages::Channel::kParameter, publisher_.clock().unix_ns(now),
                  messages::parameters_message(parameters_));
}

void RequestHandler::exchange(std::vector<ParameterText> parameters, HostNs now) {
  for (ParameterText& next : parameters) {
    const auto old = std::ranges::find(parameters_, next.name, &ParameterText::name);
    if (next.live && old != parameters_.end()) next.value = old->value;
  }
  parameters_ = std::move(parameters);
  publish_parameters(now);
}

std::vector<const ParameterText*> RequestHandler::select(
    const std::vector<std::string>& names) const {
  const std::set<std::string_view> wanted(names.begin(), names.end());
  std::vector<const ParameterText*> out;
  for (const ParameterText& parameter : parameters_)
    if (wanted.empty() || wanted.contains(parameter.name)) out.push_back(&parameter);
  return out;
}

void RequestHandler::watch_parameters(const Viewer& viewer, const ParameterSubscription& wanted) {
  // Keeps existing names only, so that a client cannot make this grow.
  std::set<std::string>& names = watched_[viewer.id()];
  for (const ParameterText* parameter : select(wanted.names)) {
    if (wanted.watch) {
      names.insert(parameter->name);
    } else {
      names.erase(parameter->name);
    }
  }
}

Result<const ParameterText*> RequestHandler::set_one(const NamedValue& one, Permission permission) {
  if (permission != Permission::kCommand)
    return Refusal{"parameters are not taken from this client (server.commands)"};
  const auto found = std::ranges::find(parameters_, one.name, &ParameterText::name);
  if (found == parameters_.end()) return no_such("parameter", one.name);
  if (!found->live)
    return Refusal{found->name + " cannot be changed while the daemon runs; set it in the file"};
  if (!one.value) return Refusal{found->name + " takes no value of that type"};
  if (found->only_at_standstill && under_way(publisher_.state().run))
    return Refusal{found->name + " cannot be changed during a run"};
  if (std::string why = messages::why_not(*found, *one.value); !why.empty()) return Refusal{why};
  if (const Result<> done = controls_.set(*found, *one.value); !done) return done.refusal();
  found->value = *one.value;
  return &*found;
}

void RequestHandler::set_parameters(Viewer& viewer, const SetParameters& wanted,
                                    Permission permission, HostNs now) {
  std::vector<std::string> names;
  bool changed = false;
  for (const NamedValue& one : wanted.parameters) {
    names.push_back(one.name);
    const Result<const ParameterText*> done = set_one(one, permission);
    if (!done) {
      viewer.say(StatusLevel::kError, done.why());
      continue;
    }
    overdue_ns_ = now + kOverdueNs;
    viewer.charge(kChangeBytes);
    parameter_changed(**done, now);
    changed = true;
  }
  if (changed) publish_parameters(now);
  if (!names.empty()) viewer.reply(parameter_values(select(names), wanted.id));
}

void RequestHandler::parameter_changed(const ParameterText& parameter, HostNs now) {
  std::string value;
  std::visit([&](const auto& content) { text::JsonWriter(value).value(content); }, parameter.value);
  publisher_.take(
      messages::Event{.at_ns = now, .kind = "parameter", .text = parameter.name + " = " + value});
  const std::array<const ParameterText*, 1> changed = {&parameter};
  const std::string message = parameter_values(changed, "");
  for (const auto& viewer : broker_.viewers()) {
    const auto watched = watched_.find(viewer->id());
    if (watched != watched_.end() && watched->second.contains(parameter.name))
      viewer->reply(message);
  }
}

// The step may have ignored a change of the steering pose, because a run began before it.
void RequestHandler::correct_steering(HostNs now) {
  const auto steering = std::ranges::find(parameters_, kSteering, &ParameterText::name);
  if (now < overdue_ns_ || publisher_.last_step_ns() == 0 || steering == parameters_.end()) return;
  const messages::ParameterValue used = std::string(to_string(publisher_.state().steering));
  if (steering->value == used) return;
  steering->value = used;
  publish_parameters(now);
  parameter_changed(*steering, now);
}

}  // namespace tp100::server
