#include <poll.h>
#include <termios.h>
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <array>
#include <atomic>
#include <cerrno>
#include <csignal>
#include <cstdio>
#include <filesystem>
#include <future>
#include <optional>
#include <string>
#include <vector>

#include "app/commands.h"
#include "bridge/cycle.h"
#include "config/configuration.h"
#include "core/error.h"
#include "course/bundled_files.h"
#include "course/robot_file.h"
#include "doctor/finding.h"
#include "doctor/host_checks.h"
#include "doctor/port_checks.h"
#include "doctor/probe_session.h"
#include "doctor/robot.h"
#include "doctor/system.h"
#include "doctor/wheels_up.h"
#include "link/port_discovery.h"
#include "loop/real_time.h"
#include "text/command_line.h"
#include "text/format.h"

namespace tp100::app {
namespace {

struct DoctorOptions {
  std::string config;
  std::string robot;                        ///< empty: as configured
  std::string port;                         ///< empty: as configured
  double link_test_s = doctor::kLinkTestS;  ///< 0: no link test
  bool wheels_up = false;                   ///< also run the guided test of the tracks
  bool json = false;
};

using doctor::Findings;
using doctor::Severity;

constexpr std::uint16_t kPagePort = 8765;

std::atomic<bool> stop{false};

void on_signal(int) { stop = true; }

/// The person who runs the command: questions go to standard error, answers come from standard
/// input.
class Terminal : public doctor::Operator {
 public:
  void say(const std::string& line) override { std::fprintf(stderr, "%s\n", line.c_str()); }

  void ask(const doctor::Question& question) override {
    drop_typed_ahead();
    std::string line = question.text + ".";
    if (line.ends_with("?.")) line.pop_back();
    const char* separator = " ";
    for (const doctor::Choice& choice : question.choices) {
      line += separator + (choice.answer.empty() ? "Enter" : choice.answer) + ": " + choice.meaning;
      separator = "; ";
    }
    say(line);
  }

  /// Reads all available input, and never waits.
  std::optional<std::string> take_answer() override {
    pollfd input{STDIN_FILENO, POLLIN, 0};
    if (!ended_ && ::poll(&input, 1, 0) > 0) {
      std::array<char, 256> buffer;
      const ssize_t n = ::read(STDIN_FILENO, buffer.data(), buffer.size());
      if (n > 0) pending_.append(buffer.data(), static_cast<std::size_t>(n));
      if (n == 0 || (n < 0 && errno != EINTR && errno != EAGAIN)) ended_ = true;
    }
    const std::size_t end = pending_.find('\n');
    if (end == std::string::npos) {
      if (ended_) pending_.clear();
      return std::nullopt;
    }
    std::string line = pending_.substr(0, end);
    pending_.erase(0, end + 1);
    line.erase(line.find_last_not_of(" \t\r") + 1);
    return line;
  }

  bool ended() const override { return ended_ && pending_.empty(); }
  bool watches() const override { return true; }
  void motors_off(HostNs) override {}

  /// Waits for Enter. False: there was none.
  bool confirms() {
    say("Put the robot on a stand, so that its tracks turn freely. Both tracks will run in "
        "opposite directions, then each one forward and back for a second. Press Enter to start, "
        "Ctrl-C to stop.");
    drop_typed_ahead();
    while (!stop && !ended()) {
      if (take_answer()) return true;
      pollfd input{STDIN_FILENO, POLLIN, 0};
      ::poll(&input, 1, 100);
    }
    return false;
  }

 private:
  /// Discards what was typed at a terminal; a pipe keeps its lines.
  void drop_typed_ahead() {
    if (::isatty(STDIN_FILENO) == 0) return;
    ::tcflush(STDIN_FILENO, TCIFLUSH);
    pending_.clear();
  }

  std::string pending_;
  bool ended_ = false;
};

/// Runs `work` with the privileges of a run's loop, in a thread that ends with them.
template <class Work>
auto with_privileges(const config::LoopConfiguration& settings, const Work& work) {
  const auto privileged = [&] {
    return work(loop::apply_to_this_thread({settings.priority, settings.cpu}));
  };
  return std::async(std::launch::async, privileged).get();
}

/// Requests the privileges of a run.
std::vector<loop::Privilege> ask_privileges(const config::LoopConfiguration& settings) {
  const loop::RealTimeProcess process(
      {settings.lock_memory, settings.hold_cpu_latency, settings.priority > 0});
  std::vector<loop::Privilege> privileges = process.privileges();
  const auto more =
      with_privileges(settings, [](const std::vector<loop::Privilege>& of) { return of; });
  privileges.insert(privileges.end(), more.begin(), more.end());
  return privileges;
}

std::optional<std::uint16_t> page_port(const std::string& listen) {
  if (listen == "off") return std::nullopt;
  const std::size_t colon = listen.rfind(':');
  std::optional<std::uint16_t> port;
  if (colon != std::string::npos)
    port = text::number_in<std::uint16_t>(std::string_view(listen).substr(colon + 1));
  if (port == 0) return std::nullopt;
  return port.value_or(kPagePort);
}

/// The subject of an examination, and its findings.
struct Examination {
  doctor::System system{};
  config::Configuration configuration{};
  course::Robot robot{};
  doctor::ChosenPort port{};
  std::optional<doctor::LinkTest> link{};
  Findings findings{};
};

Examination begin(const DoctorOptions& options) {
  Examination all;
  if (!options.config.empty()) {
    const course::TextFile file = course::read_text_file(options.config);
    all.configuration = config::parse_configuration(file.text, file.path);
  }
  const course::TextFile robot = course::read_bundled(
      course::Bundled::kRobots, options.robot.empty() ? all.configuration.robot : options.robot);
  all.robot = course::parse_robot(robot.text, robot.path);
  return all;
}

doctor::ProbeOptions probe_options(const Examination& all, const DoctorOptions& options) {
  doctor::ProbeOptions probe;
  probe.port = all.port.path;
  probe.serial = {all.configuration.link.baud, all.configuration.link.hang_up};
  probe.session = bridge::session_settings(config::bridge_parameters(all.configuration, all.robot));
  probe.session.baud = static_cast<std::uint32_t>(all.configuration.link.baud);
  probe.battery_cutoff_v = all.robot.drive.battery_cutoff_v;
  probe.link_test_s = options.link_test_s;
  return probe;
}

void examine_port(Examination& all, const DoctorOptions& options) {
  std::string name = options.port.empty() ? all.configuration.link.port : options.port;
  // All findings name the system's files by absolute path.
  if (name != "auto") name = std::filesystem::absolute(name);
  all.port = doctor::choose_port(all.system, name, link::list_ports());
  append(all.findings, doctor::port_findings(all.system, all.port));
}

void examine_robot(Examination& all, const DoctorOptions& options) {
  const doctor::ProbeResult probe = doctor::probe_robot(probe_options(all, options), stop);
  append(all.findings, doctor::robot_findings(probe));
  all.link = probe.link;
}

void examine_tracks(Examination& all, const DoctorOptions& options) {
  if (count(all.findings, Severity::kError) > 0) {
    all.findings.push_back(
        {Severity::kNote, "wheels-up", "the tracks were not tried", "fix the errors above first"});
    return;
  }
  const doctor::ProbeOptions probe = probe_options(all, options);
  try {
    // Driven tracks need a command every 200 ms, however busy the machine is.
    Terminal terminal;
    append(all.findings, !terminal.confirms()
                             ? doctor::wheels_up_broken_off("nobody pressed Enter, nothing moved",
                                                            "run it in a terminal")
                             : with_privileges(all.configuration.loop, [&](const auto&) {
                                 return doctor::try_wheels_up(
                                     {probe.port, probe.serial, probe.session, all.robot.drive},
                                     terminal, stop);
                               }));
  } catch (const UserError& error) {
    append(all.findings, doctor::robot_findings({.port = probe.port, .open_error = error.what()}));
  }
}

void examine_host(Examination& all) {
  append(all.findings, doctor::real_time_findings(ask_privileges(all.configuration.loop)));
  append(all.findings, doctor::clock_source_findings(all.system));
  append(all.findings, doctor::governor_findings(all.system));
  append(all.findings, doctor::load_findings(all.system));
  if (const auto port = page_port(all.configuration.server.listen))
    append(all.findings, doctor::page_port_findings(all.system, *port));
  append(all.findings, doctor::disk_findings(doctor::try_disk(all.configuration.record.directory)));
}

int run_doctor(const DoctorOptions& options) {
  for (const int signal : {SIGINT, SIGTERM, SIGHUP}) std::signal(signal, on_signal);
  Examination all = begin(options);
  examine_port(all, options);
  // If the port is in use or not permitted, opening it would only report the same again.
  if (count(all.findings, Severity::kError) == 0) examine_robot(all, options);
  if (options.wheels_up) examine_tracks(all, options);
  if (!all.port.device.empty() && !all.port.pseudo_terminal)
    append(all.findings, doctor::usb_findings(all.system, all.port.device, all.port.info));
  examine_host(all);
  const std::string text = options.json ? doctor::json(all.findings, all.port.path, all.link)
                                        : doctor::table(all.findings);
  std::fputs(text.c_str(), stdout);
  return stop || count(all.findings, Severity::kError) > 0 ? 1 : 0;
}

}  // namespace

void add_doctor(CLI::App& app, Action& action) {
  static DoctorOptions options;
  CLI::App* command = app.add_subcommand(
      "doctor", "Find what prevents the robot from driving, with a remedy for each problem");
  text::option(command, "--port", options.port, "DEVICE",
               "Serial port, or auto for a Mega by its USB ids (default: auto)");
  command->add_flag("--json", options.json, "One JSON object instead of a table");
  command->add_flag("--wheels-up", options.wheels_up,
                    "Then, on a stand and after Enter, drive each track and check that motors, "
                    "encoders and gyro have the right sign");
  text::option(command, "--link-test", options.link_test_s, "SECONDS",
               "How long to test the link [s]; 0: no link test")
      ->check(CLI::Range(0.0, 3600.0))
      ->capture_default_str();
  text::option(command, "--config", options.config, "FILE",
               "Configuration (default: as config/tp100.toml)");
  text::option(command, "--robot", options.robot, "ROBOT",
               "Name in config/robots or file (default: end-loaded)");
  command->footer("Example: tp100d doctor --wheels-up");
  command->callback([&action] { action = [] { return run_doctor(options); }; });
}

}  // namespace tp100::app
