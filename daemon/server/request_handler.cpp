#include "server/request_handler.h"

#include <algorithm>
#include <array>
#include <utility>

#include "server/motion_services.h"
#include "text/json_writer.h"

namespace tp100::server {
namespace {

constexpr std::size_t kMaxWaiting = 1024;

std::string name_of(const Viewer& viewer) {
  return to_string(Requester{Door::kViewer, viewer.id()});
}

/// The response of stop.
std::string stop_answer(const messages::StopFigures& stop) {
  return text::json_object([&](text::JsonWriter& json) {
    const bool acknowledged = stop.status == messages::StopFigures::Status::kAcknowledged;
    json.field("acknowledged", acknowledged);
    if (acknowledged) json.field("acknowledged_ms", stop.acknowledged_ms);
  });
}

}  // namespace

RequestHandler::RequestHandler(Broker& broker, Publisher& publisher, Controls& controls,
                               std::vector<messages::ParameterText> parameters,
                               std::vector<ServiceRow> services, std::string session_id,
                               std::string name)
    : broker_(broker),
      publisher_(publisher),
      controls_(controls),
      parameters_(broker, publisher, controls, std::move(parameters)),
      services_(std::move(services)),
      session_id_(std::move(session_id)),
      name_(std::move(name)) {
  std::ranges::move(motion_services(controls, publisher), std::back_inserter(services_));
  const auto watch = [this](const Request& request) {
    watched_ns_ = request.now;
    return accepted(Done{});
  };
  constexpr ServiceRow::Rules kOpen{.permission = Permission::kStopOnly};
  services_.push_back(
      {Service::kStop, "stop", "{}", R"({"acknowledged":true,"acknowledged_ms":1.5})", {}, kOpen});
  // Whoever may stop the robot may say that it is watched.
  services_.push_back({Service::kWatch, "watch", "{}", R"({"accepted":true})", watch, kOpen});
  std::ranges::sort(services_, {}, &ServiceRow::service);
}

void RequestHandler::send_server_info(Viewer& viewer, Permission permission) const {
  const messages::RunContext& run_context = publisher_.run_context();
  const std::array<Metadata, 7> metadata = {{
      {"version", run_context.version},
      {"name", name_},
      {"course", run_context.course == nullptr ? "" : run_context.course->name},
      {"robot", run_context.robot.name},
      {"setup", run_context.setup},
      {"commands", permission == Permission::kCommand ? "yes" : "stop"},
      {"start_unix_ns", std::to_string(publisher_.clock().start_unix_ns)},
  }};
  viewer.reply(server_info(session_id_, metadata));
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
    parameters_.get(*viewer, *get);
  } else if (const auto* set = std::get_if<SetParameters>(&message)) {
    parameters_.set(*viewer, *set, permission == Permission::kCommand, now);
  } else if (const auto* watch = std::get_if<ParameterSubscription>(&message)) {
    parameters_.watch(*viewer, *watch);
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
  std::erase_if(waiting_, [&](const Waiting& each) { return each.viewer_id == viewer.id(); });
  parameters_.leave(viewer);
}

bool RequestHandler::under_way() const { return tp100::under_way(publisher_.state().run); }

void RequestHandler::send_answers() {
  std::vector<Answered> all;
  {
    const std::lock_guard lock(arrivals_->mutex);
    all.swap(arrivals_->answers);
  }
  for (const Answered& each : all) {
    const auto viewer = each.viewer.lock();
    if (viewer == nullptr) continue;
    if (each.why.empty()) {
      viewer->reply(service_response(each.service, each.call, each.json), true);
    } else {
      viewer->reply(service_failure(each.service, each.call, each.why));
    }
  }
}

void RequestHandler::on(const std::shared_ptr<Viewer>& viewer, const ServiceCall& call,
                        Permission permission, HostNs now) {
  if (call.service == static_cast<std::uint32_t>(Service::kStop))
    return stop_pressed(viewer, call.call, now);
  const Answer answer = [arrivals = arrivals_, weak = std::weak_ptr(viewer), service = call.service,
                         number = call.call](const std::string& why, const std::string& json) {
    const std::lock_guard lock(arrivals->mutex);
    arrivals->answers.push_back({weak, service, number, why, json});
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
  const messages::StateFigures& state = publisher_.state();
  const Result<Request> request =
      read_request(*row, call.payload, viewer, publisher_.clock(), state, now);
  if (!request) return request.refusal();
  if (rules.at_rest && under_way()) return Refusal{kUnderWay};
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
    viewer->reply(service_response(static_cast<std::uint32_t>(Service::kStop), call,
                                   stop_answer(publisher_.stop().figures())),
                  true);
    return;
  }
  waiting_.push_back({viewer, viewer->id(), call});
  tick(at);
}

void RequestHandler::stop_if_unwatched(HostNs now) {
  if (!under_way()) watched_ns_ = now;
  if (!publisher_.run_context().stop_unwatched || now - watched_ns_ < kUnwatchedNs) return;
  watched_ns_ = now;
  controls_.stop();
  publisher_.stop_pressed("server.stop_unwatched", now);
}

void RequestHandler::tick(HostNs now) {
  stop_if_unwatched(now);
  parameters_.finish_overdue(now);
  send_answers();
  if (waiting_.empty()) return;
  const messages::StopFigures& stop = publisher_.stop().figures();
  if (stop.status == messages::StopFigures::Status::kPending) return;
  const std::string answer = stop_answer(stop);
  for (const Waiting& each : std::exchange(waiting_, {})) {
    if (const auto viewer = each.viewer.lock())
      viewer->reply(service_response(static_cast<std::uint32_t>(Service::kStop), each.call, answer),
                    true);
  }
}

}  // namespace tp100::server
