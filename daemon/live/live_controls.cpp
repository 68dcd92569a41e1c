#include "live/live_controls.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <iterator>
#include <utility>

#include "core/board.h"
#include "core/clock.h"
#include "live/services.h"
#include "text/file_name.h"

namespace tp100::live {
namespace {

// After this time a step has taken a request.
constexpr HostNs kTakesEffectNs = 200 * kNsPerMs;
constexpr double kLatestMarkS = 1e9;
constexpr const char* kChanging = "course, robot or place are being changed; try again";
constexpr const char* kShuttingDown = "the daemon is shutting down";
constexpr const char* kBusy = "too many requests wait; try again";

Result<> unless_busy(bool passed_on) {
  if (!passed_on) return Refusal{kBusy};
  return Done{};
}

}  // namespace

std::vector<server::ServiceRow> LiveControls::services() {
  std::vector<server::ServiceRow> all = self_test_.services();
  for (auto rows : {recording_.services(), file_services(setup_), run_services(runs_)})
    std::ranges::move(rows, std::back_inserter(all));
  const auto begin = [this](const server::Request& request) { return begin_wheels_up(request); };
  all.push_back({server::Service::kWheelsUpBegin,
                 "wheels_up_begin",
                 R"({"tracks":""})",
                 R"({"token":""})",
                 begin,
                 {.consents = true}});
  all.push_back({server::Service::kMark, "mark", R"({"text":"","run":"","t_s":1.5})",
                 server::kAccepted, std::bind_front(&LiveControls::mark, this)});
  return all;
}

// Of now: an event, which recordings hold; of a recorded run: in its note.
Result<> LiveControls::mark(const server::Request& request, const server::Answer& answer) {
  const server::Arguments& given = request.arguments;
  runs::Mark mark{.text = given.text("text").value_or("mark")};
  if (std::string why = runs::why_not(mark); !why.empty()) return Refusal{why};
  const auto run = given.text("run");
  const auto t_s = given.number("t_s");
  if (!run && !t_s) {
    events_.post({.at_ns = request.now, .kind = "mark", .text = mark.text});
    answer("", server::kAccepted);
    return Done{};
  }
  if (!run || !t_s || !text::is_found_name(*run) || std::abs(*t_s) > kLatestMarkS)
    return Refusal{
        "give run, a name of GET /api/runs, and t_s, the time in its messages; or neither, to mark "
        "this moment"};
  mark.t_s = *t_s;
  runs_.change_note(*run, {.mark = mark}, [answer](const std::string& why, const std::string&) {
    answer(why, why.empty() ? server::kAccepted : "");
  });
  return Done{};
}

// The rules that every motion obeys, whichever door asks for it.
Result<> LiveControls::may_move(const Consent& consent, HostNs now) const {
  if (ending_) return Refusal{kShuttingDown};
  if (setup_.changing()) return Refusal{kChanging};
  if (self_test_.wheels_up().on()) return Refusal{selftest::kTracksRun};
  const ConsentLoss loss = cycle_.consents().judge(consent, now);
  if (loss != ConsentLoss::kNone) return Refusal{to_string(loss)};
  return Done{};
}

Result<> LiveControls::move(OperatorRequest request, const Consent& consent, HostNs now) {
  const std::lock_guard lock(mutex_);
  const Result<> may = may_move(consent, now);
  if (!may) return may;
  const StartRefusal where = refusal_of(cycle_.start_places(), request);
  if (where != StartRefusal::kNone) return Refusal{std::string(to_string(where))};
  return unless_busy(cycle_.request(request, consent));
}

Result<> LiveControls::hold() {
  self_test_.wheels_up().stop();
  return unless_busy(cycle_.request(OperatorRequest::kHold));
}

Result<> LiveControls::pause() { return unless_busy(cycle_.request(OperatorRequest::kPause)); }

void LiveControls::stop() {
  cycle_.stop();
  self_test_.wheels_up().stop();
}

Result<std::string> LiveControls::begin_wheels_up(const server::Request& request) {
  if (request.arguments.text("tracks") != "free")
    return Refusal{"somebody has to confirm that the tracks turn freely: send tracks = \"free\""};
  if (!request.state.why_not_drive.empty()) return Refusal{request.state.why_not_drive};
  if (request.under_way()) return Refusal{server::kUnderWay};
  const std::lock_guard lock(mutex_);
  if (const Result<> may = may_move(request.consent, request.now); !may) return may.refusal();
  if (driving(request.now)) return Refusal{server::kUnderWay};
  const Result<std::string> token = self_test_.wheels_up().begin(request.by, request.now);
  if (!token) return token;
  // A STOP since the consent was judged: the check forgot it when it began.
  if (stop_count() != request.consent.stops_seen) self_test_.wheels_up().stop();
  cycle_.give_up_port();
  events_.post({.at_ns = request.now,
                .kind = "run",
                .text = request.by + " starts the check of the tracks"});
  return server::json_of({{"token", *token}});
}

Result<std::string> LiveControls::drive_take(const std::string& driver, const Consent& consent,
                                             HostNs now) {
  const std::lock_guard lock(mutex_);
  if (const Result<> may = may_move(consent, now); !may) return may.refusal();
  if (!driving(now)) lease_.clear();
  const std::optional<std::string> token = lease_.take(driver, now);
  if (!token) return Refusal{lease_.figures(now).by + " drives; ask for a release"};
  // The previous driver's token is no longer valid.
  cycle_.velocity({.at_ns = now});
  if (cycle_.request(OperatorRequest::kDrive, consent)) return *token;
  lease_.clear();
  return Refusal{kBusy};
}

Result<> LiveControls::drive(const server::DriveRequest& request, HostNs now) {
  const std::lock_guard lock(mutex_);
  if (!driving(now)) lease_.clear();
  std::string why;
  const std::optional<VelocityInput> input = lease_.drive(request, now, why);
  if (input) return unless_busy(cycle_.velocity(*input));
  if (why.empty()) return Refusal{"this token does not hold the lease; take it"};
  static_cast<void>(end_drive(now));
  return Refusal{why};
}

Result<> LiveControls::drive_release(const std::string& token, HostNs now) {
  const std::lock_guard lock(mutex_);
  if (!lease_.release(token)) return Refusal{"this token does not hold the lease"};
  return end_drive(now);
}

Result<> LiveControls::end_drive(HostNs now) {
  cycle_.velocity({.at_ns = now});
  // Do not hold a run that somebody else may have started meanwhile.
  if (cycle_.run_state() == RunState::kRunning) return Done{};
  return unless_busy(cycle_.request(OperatorRequest::kHold));
}

void LiveControls::drive_lost(const std::string& driver, HostNs now) {
  const std::lock_guard lock(mutex_);
  if (lease_.lose(driver)) cycle_.velocity({.at_ns = now});
  self_test_.wheels_up().lose(driver);
}

messages::DriverFigures LiveControls::driver(HostNs now) {
  const std::lock_guard lock(mutex_);
  if (!driving(now)) lease_.clear();
  return lease_.figures(now);
}

/// Driven by hand, or about to be.
bool LiveControls::driving(HostNs now) {
  const RunState state = cycle_.run_state();
  return state == RunState::kDriving || state == RunState::kArming ||
         now - lease_.taken_ns() < kTakesEffectNs;
}

Result<> LiveControls::set(const messages::ParameterText& parameter,
                           const messages::ParameterValue& value) {
  const auto change = change_for(parameter, value);
  if (!change) return Refusal{parameter.name + " cannot be changed while the daemon runs"};
  return unless_busy(cycle_.change(*change));
}

void LiveControls::choose(const server::SetupChoice& choice, server::Answer answer) {
  if (self_test_.wheels_up().on()) return answer(selftest::kTracksRun, {});
  setup_.choose(choice, std::move(answer));
}

// Viewers get no path of this machine.
messages::RecordingFigures LiveControls::recording() {
  messages::RecordingFigures figures = recording_.figures();
  const std::size_t folder = figures.file.rfind(figures.run + '/');
  if (figures.run.empty() || folder == std::string::npos) return figures;
  const std::string before = figures.file.substr(0, folder);
  if (figures.warning.starts_with(before)) figures.warning.erase(0, folder);
  figures.file.erase(0, folder);
  return figures;
}

messages::LoopFigures LiveControls::loop() {
  const loop::LoopStatistics& statistics = loop_.statistics();
  messages::LoopFigures out;
  out.cycles = statistics.cycles.load();
  out.overruns = statistics.overruns.load();
  out.missed = statistics.missed.load();
  out.frame_timeouts = statistics.frame_timeouts.load();
  out.lateness = messages::durations_of(statistics.lateness);
  out.work = messages::durations_of(statistics.work);
  out.compute = messages::durations_of(statistics.compute);
  out.write = messages::durations_of(statistics.write);
  out.sample_wire = messages::durations_of(cycle_.sample_latency().wire);
  out.sample_wait = messages::durations_of(cycle_.sample_latency().wait);
  out.sample_age = messages::durations_of(cycle_.sample_latency().age);
  out.lost_records = cycle_.lost_records();
  out.lost_events = cycle_.lost_events();
  out.lateness_counts = messages::lateness_counts_of(statistics.lateness);
  const std::lock_guard lock(mutex_);
  out.privileges = privileges_;
  return out;
}

messages::PortFigures LiveControls::port() {
  const std::lock_guard lock(mutex_);
  return port_;
}

void LiveControls::set_session(const SessionReport& report, const std::string& path,
                               bool pseudo_terminal) {
  self_test_.on_event(report.event, report.hello, {path, pseudo_terminal});
  const bool identified = report.hello.boot_nonce != 0;
  const std::lock_guard lock(mutex_);
  start_.emulator = identified && is_emulator(pseudo_terminal, report.hello.board);
  port_.path = path;
  port_.kind = robot_kind(pseudo_terminal, report.hello.board);
  port_.firmware = identified ? firmware_text(report.hello) : std::string();
}

void LiveControls::note_port(const std::string& line) {
  self_test_.note_port(line);
  const std::lock_guard lock(mutex_);
  port_.note = line;
}

void LiveControls::set_start(const StartFacts& facts) {
  const std::lock_guard lock(mutex_);
  start_ = facts;
}

bool LiveControls::start_by_itself(bool came_later, HostNs program_start_ns, HostNs now) {
  if (start_consent() != StartConsent::kNone || setup_.in_force()->course().empty()) return false;
  // This thread alone writes start_.
  const Consent consent = option_consent(start_.emulator, came_later, program_start_ns, now);
  const Result<> moves = move(OperatorRequest::kStart, consent, now);
  if (moves) return true;
  events_.post({.at_ns = now,
                .kind = "run",
                .level = messages::Event::Level::kWarning,
                .text = "nothing starts by itself",
                .cause = moves.why(),
                .fix = "--go counts for 10 s after the program's start, for a robot that is "
                       "there then; start it at the terminal or on the page"});
  return false;
}

StartConsent LiveControls::start_consent() {
  const std::lock_guard lock(mutex_);
  StartFacts facts = start_;
  facts.has_run = cycle_.consents().ran();
  return tp100::start_consent(facts);
}

std::vector<loop::Privilege> LiveControls::set_privileges(std::vector<loop::Privilege> privileges) {
  std::ranges::copy(loop_.privileges(), std::back_inserter(privileges));
  self_test_.set_privileges(privileges);
  const std::lock_guard lock(mutex_);
  for (const loop::Privilege& privilege : privileges)
    privileges_.emplace_back(privilege.what, privilege.granted);
  return privileges;
}

void LiveControls::end() {
  const std::lock_guard lock(mutex_);
  ending_ = true;
  self_test_.wheels_up().stop();
}

}  // namespace tp100::live
