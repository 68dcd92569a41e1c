#include "server/request_handler.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "server/services.h"
#include "text/json_writer.h"

namespace tp100::server {
namespace {

constexpr std::size_t kMaxWaiting = 1024;

Driver driver_of(const Viewer& viewer) {
  const std::string name = to_string(Requester{Door::kViewer, viewer.id()});
  return {.id = name, .name = name};
}

/// Takes `stops` and `t_s` out of the arguments: what the person saw on /state when acting. Returns
/// why that is impossible.
std::string read_consent(Arguments& arguments, const messages::PublishClock& clock, HostNs now,
                         Consent& consent) {
  // Counted exactly by a double.
  constexpr double kMaxStops = 1e15, kMaxSeconds = 1e9;
  constexpr HostNs kRounding = kNsPerMs;
  const auto take = [&](std::string_view name, double most) -> std::optional<double> {
    const auto at = std::ranges::find(arguments, name, &RequestField::name);
    const double* value = at == arguments.end() ? nullptr : std::get_if<double>(&at->value);
    if (value == nullptr || !(*value >= 0.0 && *value <= most)) return std::nullopt;
    const double taken = *value;
    arguments.erase(at);
    return taken;
  };
  const std::optional<double> stops = take("stops", kMaxStops), t_s = take("t_s", kMaxSeconds);
  if (!stops || !t_s || *stops != std::floor(*stops))
    return "stops and t_s are needed: /state.stop.count and /state.t_s as the person saw them when "
           "acting";
  consent.stops_seen = static_cast<std::uint64_t>(*stops);
  consent.acted_ns = std::min(clock.start_ns + from_s(*t_s), now + kRounding);
  consent.seen_ns = consent.acted_ns;
  return consent.acted_ns < now + kRounding
             ? ""
             : "t_s is later than now; send /state.t_s as it was received";
}

/// The answer of a recording request: its run, and with `bytes` its size.
Controls::RecordAnswer recorded(Controls::Answer answer, bool bytes) {
  return [answer = std::move(answer), bytes](const std::string& why,
                                             const messages::RecordingFigures& recording) {
    std::string json;
    text::JsonWriter writer(json);
    writer.begin_object().field("run", recording.run);
    if (bytes) writer.field("bytes", recording.bytes);
    writer.end_object();
    answer(why, json);
  };
}

}  // namespace

RequestHandler::RequestHandler(Broker& broker, Publisher& publisher, Controls& controls,
                               std::vector<messages::ParameterText> parameters,
                               std::string session_id, std::string name)
    : broker_(broker),
      publisher_(publisher),
      controls_(controls),
      parameters_(broker, publisher, controls, std::move(parameters)),
      session_id_(std::move(session_id)),
      name_(std::move(name)) {}

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
  viewer.reply(advertise_services(services()));
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
  controls_.drive_lost(driver_of(viewer).id, now);
  std::erase_if(waiting_, [&](const Waiting& each) { return each.viewer_id == viewer.id(); });
  parameters_.leave(viewer);
}

std::string RequestHandler::start(const Arguments& request, const Consent& consent, HostNs now) {
  bool here = false;
  std::string why = read_start(request, here);
  if (!why.empty()) return why;
  const messages::StateFigures& state = publisher_.state();
  if (!state.can_start) return state.why_not_start;
  if (!here) return controls_.move(OperatorRequest::kStart, consent, now);
  return state.go_on_from
             ? controls_.move(OperatorRequest::kGoOn, consent, now)
             : "no run ended before the end of its course; start from the course's start";
}

std::string RequestHandler::pause(const Viewer& viewer, HostNs now) {
  const messages::StateFigures& state = publisher_.state();
  if (state.run != RunState::kRunning) return "no run is under way";
  std::string why = controls_.pause();
  if (why.empty() && state.pause_left_s == 0.0)
    say(driver_of(viewer).name + " pauses the run", now);
  return why;
}

std::string RequestHandler::resume(const Viewer& viewer, const Consent& consent, HostNs now) {
  const messages::StateFigures& state = publisher_.state();
  if (state.run != RunState::kRunning || state.pause_left_s == 0.0) return "the run is not paused";
  std::string why = controls_.move(OperatorRequest::kResume, consent, now);
  if (why.empty()) say(driver_of(viewer).name + " continues the run", now);
  return why;
}

std::string RequestHandler::drive_take(const Viewer& viewer, const Consent& consent, HostNs now,
                                       std::string& token) {
  const Driver driver = driver_of(viewer);
  // A driver who asks again gets a new token.
  const std::string& why = publisher_.state().why_not_drive;
  const messages::DriverFigures figures = controls_.driver(now);
  if (!why.empty() && figures.by.empty()) return why;
  std::string refused = controls_.drive_take(driver, consent, now, token);
  if (refused.empty()) say(driver.name + " takes the wheel", now);
  return refused;
}

std::string RequestHandler::wheels_up_begin(const Viewer& viewer, const Arguments& request,
                                            const Consent& consent, HostNs now,
                                            std::string& token) {
  std::string why = read_wheels_up(request);
  if (why.empty()) why = publisher_.state().why_not_drive;
  if (why.empty() && under_way()) why = kUnderWay;
  const Driver driver = driver_of(viewer);
  if (why.empty()) why = controls_.wheels_up_begin(driver, consent, now, token);
  if (why.empty()) say(driver.name + " starts the check of the tracks", now);
  return why;
}

std::string RequestHandler::drive(const Arguments& request, HostNs now) {
  std::string why;
  const auto input = drive_request(request, why);
  return input ? controls_.drive(*input, now) : why;
}

std::string RequestHandler::drive_release(const Arguments& request, HostNs now) {
  const std::string* token =
      request.empty() ? nullptr : std::get_if<std::string>(&request.front().value);
  return token == nullptr ? "token must be a string" : controls_.drive_release(*token, now);
}

std::string RequestHandler::record_start(const Arguments& request, Controls::RecordAnswer answer) {
  std::string name;
  std::string why = read_record_name(request, name);
  if (why.empty()) controls_.record_start(name, std::move(answer));
  return why;
}

void RequestHandler::say(const std::string& text, HostNs now) {
  publisher_.take(messages::Event{.at_ns = now, .kind = "run", .text = text});
}

bool RequestHandler::under_way() const { return tp100::under_way(publisher_.state().run); }

Controls::Answer RequestHandler::answer_later(Service service,
                                              const std::shared_ptr<Viewer>& viewer,
                                              std::uint32_t call) const {
  return [arrivals = arrivals_, service, weak = std::weak_ptr(viewer), call](
             const std::string& why, const std::string& json) {
    const std::lock_guard lock(arrivals->mutex);
    arrivals->results.push_back({service, weak, call, why, json});
  };
}

void RequestHandler::answer_results() {
  std::vector<Result> all;
  {
    const std::lock_guard lock(arrivals_->mutex);
    all.swap(arrivals_->results);
  }
  for (const Result& each : all) {
    const auto viewer = each.viewer.lock();
    if (viewer == nullptr) continue;
    const auto service = static_cast<std::uint32_t>(each.service);
    if (each.why.empty()) {
      viewer->reply(service_response(service, each.call, each.json), true);
    } else {
      viewer->reply(service_failure(service, each.call, each.why));
    }
  }
}

void RequestHandler::on(const std::shared_ptr<Viewer>& viewer, const ServiceCall& call,
                        Permission permission, HostNs now) {
  const auto service = static_cast<Service>(call.service);
  if (service == Service::kStop) return stop_pressed(viewer, call.call, now);
  const auto fail = [&](const std::string& why) {
    viewer->reply(service_failure(call.service, call.call, why));
  };
  const auto answer = [&](const std::string& json) {
    viewer->reply(service_response(call.service, call.call, json), true);
  };
  const auto accept = [&](const std::string& refused) {
    return refused.empty() ? answer(R"({"accepted":true})") : fail(refused);
  };
  if (call.service == 0 || call.service > services().size())
    return fail("there is no service " + std::to_string(call.service));
  // Whoever may stop the robot may say that it is watched.
  if (permission != Permission::kCommand && service != Service::kWatch)
    return fail("only stop is taken from this client (server.commands)");
  if (call.encoding != "json") return fail("the encoding must be json");
  auto request = parse_request(call.payload);
  if (!request) return fail("the request must be a JSON object");

  std::string why = unknown_argument(service, *request);
  if (!why.empty()) return fail(why);
  Consent consent{.by = {Door::kViewer, viewer->id()}};
  if (needs_consent(service)) why = read_consent(*request, publisher_.clock(), now, consent);
  if (!why.empty()) return fail(why);
  const auto later = [&] { return answer_later(service, viewer, call.call); };
  switch (service) {
    case Service::kStart:
      return accept(start(*request, consent, now));
    case Service::kHold:
      return accept(controls_.hold());
    case Service::kPause:
      return accept(pause(*viewer, now));
    case Service::kResume:
      return accept(resume(*viewer, consent, now));
    case Service::kRecordStart:
      why = record_start(*request, recorded(later(), false));
      break;
    case Service::kRecordStop:
      controls_.record_stop(recorded(later(), true));
      break;
    case Service::kChoose: {
      SetupChoice choice;
      why = read_choice(*request, choice);
      if (why.empty() && under_way()) why = kUnderWay;
      if (why.empty()) controls_.choose(choice, later());
      break;
    }
    case Service::kPlace: {
      std::optional<Pose> at;
      why = read_place(*request, at);
      if (why.empty() && under_way()) why = kUnderWay;
      if (why.empty()) controls_.place(at, later());
      break;
    }
    case Service::kFileSave:
    case Service::kFileDelete:
    case Service::kFileCheck: {
      SetupFile file;
      why = read_file(*request, file);
      if (!why.empty()) break;
      if (service == Service::kFileSave) controls_.save_file(file, later());
      if (service == Service::kFileDelete) controls_.delete_file(file, later());
      if (service == Service::kFileCheck) controls_.check_file(file, later());
      break;
    }
    case Service::kParametersSave:
      why = parameters_.save(*request, later());
      break;
    case Service::kParametersRestore:
      why = parameters_.restore(*request, later());
      break;
    case Service::kRunNote:
    case Service::kRunDelete:
    case Service::kRunReport:
    case Service::kRunCompare:
    case Service::kRunIdentify: {
      RunRequest run;
      why = read_run(service, *request, run);
      if (why.empty()) controls_.manage_run(run, later());
      break;
    }
    case Service::kDoctor: {
      DoctorPart part{};
      why = read_part(*request, part);
      if (why.empty() && under_way()) why = kUnderWay;
      if (why.empty()) controls_.examine(part, later());
      break;
    }
    case Service::kDriveTake: {
      std::string token;
      why = drive_take(*viewer, consent, now, token);
      return why.empty() ? answer(R"({"token":")" + token + R"("})") : fail(why);
    }
    case Service::kWheelsUpBegin: {
      std::string token;
      why = wheels_up_begin(*viewer, *request, consent, now, token);
      return why.empty() ? answer(R"({"token":")" + token + R"("})") : fail(why);
    }
    case Service::kWheelsUpWatch: {
      WheelsUpWatch watch;
      std::string json;
      why = read_watch(*request, watch);
      if (why.empty()) why = controls_.wheels_up_watch(watch, now, json);
      return why.empty() ? answer(json) : fail(why);
    }
    case Service::kWatch:
      watched_ns_ = now;
      return accept({});
    case Service::kDrive:
      return accept(drive(*request, now));
    case Service::kDriveRelease:
      return accept(drive_release(*request, now));
    case Service::kStop:
      return;
  }
  if (!why.empty()) return fail(why);
  answer_results();
}

void RequestHandler::stop_pressed(const std::shared_ptr<Viewer>& viewer, std::uint32_t call,
                                  HostNs at) {
  publisher_.stop_pressed(driver_of(*viewer).name, at);
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
  answer_results();
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
