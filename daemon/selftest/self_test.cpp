#include "selftest/self_test.h"

#include <algorithm>
#include <array>
#include <filesystem>
#include <string_view>
#include <utility>

#include "doctor/finding.h"
#include "doctor/host_checks.h"
#include "doctor/port_checks.h"
#include "doctor/system.h"
#include "link/port_discovery.h"
#include "messages/messages.h"

namespace tp100::selftest {

using doctor::Findings;

namespace {

/// As it is if the working folder is gone.
std::string absolute(const std::string& path) {
  std::error_code error;
  const std::filesystem::path found = std::filesystem::absolute(path, error);
  return error ? path : found.string();
}

}  // namespace

SelfTest::SelfTest(config::Configuration configuration, const course::Robot& robot, Worker& disk,
                   messages::EventQueue& events)
    : configuration_(std::move(configuration)),
      disk_(disk),
      wheels_up_(configuration_, robot, events),
      battery_cutoff_v_(robot.drive.battery_cutoff_v) {}

std::vector<server::ServiceRow> SelfTest::services() {
  const auto examine_part = [this](const server::Request& request,
                                   const Answer& answer) -> Result<> {
    constexpr std::array<std::string_view, 3> kParts = {"port", "robot", "machine"};
    const auto part = std::ranges::find(kParts, request.arguments.text("part").value_or(""));
    if (part == kParts.end()) return Refusal{"part must be \"port\", \"robot\" or \"machine\""};
    examine(static_cast<DoctorPart>(part - kParts.begin()), answer);
    return Done{};
  };
  const auto watch = [this](const server::Request& request) { return wheels_up_.watch(request); };
  using server::Service;
  return {{Service::kDoctor,
           "doctor",
           R"({"part":""})",
           R"({"port":"","errors":1,"warnings":1,"notes":1,)"
           R"("findings":[{"severity":"","name":"","seen":"","fix":""}]})",
           examine_part,
           {.at_rest = true}},
          {Service::kWheelsUpWatch, "wheels_up_watch",
           R"({"token":"","input_ms":1.5,"question":1,"answer":""})", R"({"step":""})", watch}};
}

void SelfTest::on_event(const link::SessionEvent& event, const wire::Hello& hello,
                        const OpenPort& port) {
  const std::lock_guard lock(mutex_);
  monitor_.on_event(event, hello, port);
}

void SelfTest::note_port(const std::string& line) {
  const std::lock_guard lock(mutex_);
  note_ = line;
}

void SelfTest::set_privileges(const std::vector<loop::Privilege>& privileges) {
  const std::lock_guard lock(mutex_);
  privileges_ = privileges;
}

void SelfTest::choose(const course::Robot& robot) {
  wheels_up_.choose(robot);
  const std::lock_guard lock(mutex_);
  battery_cutoff_v_ = robot.drive.battery_cutoff_v;
}

void SelfTest::take(const StepRecord& record) {
  // Whoever requested the STOP.
  for (std::size_t i = 0; i < record.inputs.requests.size(); ++i)
    if (record.inputs.requests[i] == OperatorRequest::kStop) wheels_up_.stop();
  std::string json;
  {
    const std::lock_guard lock(mutex_);
    monitor_.take(record);
    auto probe = monitor_.done();
    if (!probe) return;
    probe->battery_cutoff_v = battery_cutoff_v_;
    if (monitor_.session() == SessionState::kClosed)
      probe->open_error = note_.empty() ? "no port is open yet" : note_;
    json = doctor::json(doctor::robot_findings(*probe), probe->port);
  }
  finish({}, json);
}

void SelfTest::examine(DoctorPart part, Answer answer) {
  if (wheels_up_.on()) return answer(kTracksRun, "");
  {
    const std::lock_guard lock(mutex_);
    if (answer_ == nullptr) {
      answer_ = std::exchange(answer, {});
      if (part == DoctorPart::kRobot) monitor_.begin();
    }
  }
  if (answer != nullptr) return answer("another examination is under way; try again", "");
  if (part == DoctorPart::kRobot) return;
  disk_.ask(
      [this](const std::string& why, const std::string& json) { finish(why, json); },
      [this, part] { return part == DoctorPart::kPort ? port_findings() : machine_findings(); });
}

void SelfTest::finish(const std::string& why, const std::string& json) {
  Answer answer;
  {
    const std::lock_guard lock(mutex_);
    answer = std::exchange(answer_, {});
  }
  answer(why, json);
}

std::string SelfTest::port_findings() const {
  OpenPort open;
  {
    const std::lock_guard lock(mutex_);
    if (monitor_.session() != SessionState::kClosed) open = monitor_.port();
  }
  const doctor::System system;
  std::string name = configuration_.link.port;
  // All findings name the system's files by absolute path.
  if (name != "auto") name = absolute(name);
  if (!open.path.empty()) open.path = absolute(open.path);
  const doctor::ChosenPort port = doctor::choose_port(system, name, link::list_ports(), open.path);
  Findings findings = doctor::port_findings(system, port, !open.path.empty());
  if (!port.device.empty() && !port.pseudo_terminal)
    append(findings, doctor::usb_findings(system, port.device, port.info));
  return doctor::json(findings, port.path);
}

std::string SelfTest::machine_findings() const {
  std::vector<loop::Privilege> privileges;
  std::string path;
  {
    const std::lock_guard lock(mutex_);
    privileges = privileges_;
    path = monitor_.port().path;
  }
  const doctor::System system;
  Findings findings = doctor::real_time_findings(privileges);
  append(findings, doctor::clock_source_findings(system));
  append(findings, doctor::governor_findings(system));
  append(findings, doctor::load_findings(system));
  findings.push_back(doctor::ok("page-port", "this daemon serves the page"));
  doctor::Disk disk = doctor::try_disk(configuration_.record.directory);
  // Viewers get no path of a folder of this machine.
  const std::string name = std::filesystem::path(disk.folder).filename();
  disk.folder = name.empty() ? "the disk" : name;
  append(findings, doctor::disk_findings(disk));
  return doctor::json(findings, path);
}

}  // namespace tp100::selftest
