// tp100d: the command line. Each subcommand is a file in app/; this file only defines the options.

#include <CLI/CLI.hpp>
#include <functional>
#include <string>
#include <vector>

#include "app/commands.h"
#include "doctor/hello.h"
#include "text/command_line.h"

namespace tp100::app {
namespace {

using text::option;

/// Action to run after parsing the command line. Returns the exit status.
using Action = std::function<int()>;

void add_run(CLI::App& app, Action& action) {
  static RunOptions options;
  CLI::App* command = app.add_subcommand("run", "Drive a robot, or just watch its pose");
  option(command, "--config", options.config, "FILE",
         "Configuration (default: as config/tp100.toml)");
  option(command, "--port", options.port, "DEVICE",
         "Serial port, or auto for a Mega by its USB ids (default: auto)");
  command->add_flag("--wait", options.daemon.wait,
                    "Wait for port and robot instead of ending with status 2");
  command->add_flag("--go", options.daemon.go,
                    "Start the first run without Enter on a physical port, too, within 10 s and if "
                    "the robot is there at once, but not in a service; end after every fault. "
                    "Every later run takes the word go and Enter; Enter alone is STOP");
  option(command, "--course", options.course, "COURSE",
         "Name in config/courses or file (default: none, poses only)");
  option(command, "--robot", options.robot, "ROBOT",
         "Name in config/robots or file (default: end-loaded)");
  option(command, "--setup", options.setup, "SETUP", "stand, flat or terrain (default: flat)");
  option(command, "--camera", options.camera, "ADDRESS",
         "Listen for an overhead camera: udp:PORT or udp:ADDRESS:PORT (default: none)");
  option(command, "--world", options.world, "WORLD",
         "Terrain source of the virtual robot: internal, files, or an external world at "
         "udp:PORT or udp:ADDRESS:PORT (default: internal)");
  option(command, "--listen", options.listen, "ADDRESS",
         "Page and viewers: ADDRESS:PORT (port 0: any free one), auto or off (default: "
         "auto, 127.0.0.1:8765)");
  command->add_flag("--stay", options.daemon.stay,
                    "When a run is over, wait for the next start instead of ending");
  option(command, "--duration", options.daemon.duration_s, "SECONDS",
         "End with status 1 after this time [s] (default: no limit)")
      ->check(CLI::Range(0.001, 1e9));
  option(command, "--record", options.record, "FOLDER",
         "Folder for recordings; each run gets its own folder in it (default: none)");
  option(command, "--stats", options.daemon.stats_path, "FILE",
         "JSON file for the figures of the run, written once a second and at the end");
  command->footer("Example: tp100d run --port auto --wait --course 1-curve");
  command->callback([&action] { action = [] { return run_run(options); }; });
}

void add_ports(CLI::App& app, Action& action) {
  static doctor::HelloOptions hello;
  CLI::App* command = app.add_subcommand("ports", "List serial ports, likely robots first");
  option(command, "--hello", hello.port, "DEVICE",
         "Wait for the firmware on this port and print its version");
  command->add_option("--timeout", hello.timeout_s, "How long to wait for it [s]")
      ->check(CLI::Range(0.1, 3600.0))
      ->capture_default_str();
  command->footer("Example: tp100d ports --hello /dev/ttyACM0");
  command->callback([&action] {
    action = [] { return hello.port.empty() ? run_ports() : doctor::run_hello(hello); };
  });
}

void add_doctor(CLI::App& app, Action& action) {
  static DoctorOptions options;
  CLI::App* command = app.add_subcommand(
      "doctor", "Find what prevents the robot from driving, with a remedy for each problem");
  option(command, "--port", options.port, "DEVICE",
         "Serial port, or auto for a Mega by its USB ids (default: auto)");
  command->add_flag("--json", options.json, "One JSON object instead of a table");
  command->add_flag("--wheels-up", options.wheels_up,
                    "Then, on a stand and after Enter, drive each track and check that motors, "
                    "encoders and gyro have the right sign");
  option(command, "--link-test", options.link_test_s, "SECONDS",
         "How long to test the link [s]; 0: no link test")
      ->check(CLI::Range(0.0, 3600.0))
      ->capture_default_str();
  option(command, "--config", options.config, "FILE",
         "Configuration (default: as config/tp100.toml)");
  option(command, "--robot", options.robot, "ROBOT",
         "Name in config/robots or file (default: end-loaded)");
  command->footer("Example: tp100d doctor --wheels-up");
  command->callback([&action] { action = [] { return run_doctor(options); }; });
}

void add_check(CLI::App& app, Action& action) {
  static std::vector<std::string> files;
  static bool json = false;
  CLI::App* command = app.add_subcommand("check", "Check configuration, course and robot files");
  option(command, "FILE", files, "FILE", "Files of any of these kinds")->required();
  command->add_flag("--json", json, "Course files only: also where path, ground and fence lie");
  command->footer("Example: tp100d check config/tp100.toml config/courses/2.toml");
  command->callback([&action] { action = [] { return run_check(files, json); }; });
}

void add_replay(CLI::App& app, Action& action) {
  static ReplayOptions options;
  CLI::App* command = app.add_subcommand("replay", "Repeat a recording, and write its poses");
  option(command, "IN", options.in, "FILE", "Recording or its folder: verified bit for bit")
      ->required();
  option(command, "--out", options.out, "FILE", "CSV file of poses to write [s, m, rad]")
      ->required();
  option(command, "--config", options.config, "FILE", "Configuration (default: as recorded)");
  option(command, "--model", options.model, "MODEL",
         "paper, extended, odometry or fused (default: the pose that steered)");
  command->footer("Example: tp100d replay runs/RUN");
  command->callback([&action] { action = [] { return run_replay(options); }; });
}

void add_identify(CLI::App& app, Action& action) {
  static IdentifyOptions options;
  CLI::App* command =
      app.add_subcommand("identify", "Find slip, wheelbase and gyro scale from recorded drives");
  option(command, "RUN", options.runs, "FILE",
         "Recordings, or CSV t_s,left_count,right_count,gyro_z_radps"
         "[,camera_x_m,camera_y_m,camera_yaw_rad], one file a run");
  option(command, "--out", options.out, "FILE", "Robot file to write")->required();
  option(command, "--robot", options.robot, "ROBOT",
         "Source of all other values: name in config/robots or file (default: the "
         "recordings', else end-loaded)");
  option(command, "--measured", options.measured, "FILE",
         "CSV of hand measurements: run[,distance_m][,ahead_m][,left_m][,turned_deg]"
         "[,slope_deg]; run counts from 1, slope_deg is that of a board on which the run "
         "was");
  option(command, "--config", options.config, "FILE",
         "Configuration (default: the recordings', else as config/tp100.toml)");
  command->add_flag("--json", options.json, "Print what was found as JSON");
  command->add_flag_callback("--background", become_background,
                             "Run at idle priority; end when the parent process ends");
  option(command, "--date", options.date, "DATE", "Day of the runs for the file (default: today)");
  command->add_flag("--drive", options.drive,
                    "Drive the calibration courses on a port first, instead of RUN; without a "
                    "camera it asks for what was measured");
  command->add_flag("--auto", options.by_itself,
                    "--drive chooses the manoeuvres that narrow the intervals most, until all are "
                    "narrow enough; prints the seconds of driving");
  option(command, "--narrow", options.guided.narrow, "PARTS",
         "Goal of --auto: half width of each interval, relative to a harmless error")
      ->check(CLI::Range(0.05, 10.0))
      ->capture_default_str();
  option(command, "--port", options.guided.run.port, "DEVICE",
         "Serial port of --drive (default: auto)");
  option(command, "--camera", options.guided.run.camera, "ADDRESS",
         "Overhead camera of --drive: udp:PORT or udp:ADDRESS:PORT (default: none)");
  command->add_flag(
      "--go", options.guided.run.daemon.go,
      "Start the first drive of --drive without confirmation on a physical port, too");
  option(command, "--course", options.guided.courses, "COURSE",
         "Courses of --drive: names in config/courses or files (default: those that "
         "calibrate a robot of this size); with --auto the one whose fence holds the "
         "manoeuvres (default: 1-straight)");
  option(command, "--repeats", options.guided.repeats, "NUMBER",
         "Number of times that --drive drives each course")
      ->check(CLI::Range(1, 100))
      ->capture_default_str();
  option(command, "--runs-dir", options.guided.folder, "FOLDER",
         "Folder for the recordings of --drive (default: beside --out)");
  command->footer(
      "Example: tp100d identify --drive --port auto --robot mine.toml --out mine-identified.toml");
  command->callback([&action] { action = [] { return run_identify(options); }; });
}

void add_recover(CLI::App& app, Action& action) {
  static RecoverOptions options;
  CLI::App* command =
      app.add_subcommand("recover", "Rebuild a recording that was truncated or corrupted");
  option(command, "FILE", options.in, "FILE", "Recording, or its folder")->required();
  option(command, "--out", options.out, "FILE",
         "File to write (default: beside it, ...-recovered.mcap)");
  command->footer("Example: tp100d recover runs/RUN");
  command->callback([&action] { action = [] { return run_recover(options); }; });
}

void add_export(CLI::App& app, Action& action) {
  static ExportOptions options;
  CLI::App* command =
      app.add_subcommand("export", "Turn recordings into CSV and TUM files, a ROS 2 bag or images");
  option(command, "RUN", options.runs, "RUN", "Recordings, or their folders")->required();
  command->add_flag("--csv", options.csv, "Only samples.csv and poses.csv");
  command->add_flag("--tum", options.tum, "Only the trajectories, for evo: time x y z qx qy qz qw");
  option(command, "--ros2", options.ros2, "FOLDER",
         "A bag for ros2 bag, Foxglove and PlotJuggler, instead of CSV and TUM files");
  option(command, "--images", options.images, "FOLDER",
         "The camera's images as JPEG files, instead of CSV and TUM files");
  option(command, "--out", options.out, "FOLDER",
         "Folder to write to (default: beside the recording)");
  command->footer("Example: tp100d export runs/RUN --csv --out figures");
  command->callback([&action] { action = [] { return run_export(options); }; });
}

void add_report(CLI::App& app, Action& action) {
  static ReportOptions options;
  CLI::App* command =
      app.add_subcommand("report", "Turn recordings into report.html, metrics.json and figures");
  option(command, "RUN", options.runs, "RUN", "Recordings, or their folders")->required();
  option(command, "--out", options.out, "FOLDER",
         "Folder to write to (default: beside the recording)");
  command->add_flag_callback("--background", become_background,
                             "Run at idle priority; end when the parent process ends");
  command->footer("Example: tp100d report runs/RUN");
  command->callback([&action] { action = [] { return run_report(options); }; });
}

void add_compare(CLI::App& app, Action& action) {
  static ReportOptions options{.runs = {}, .out = "."};
  CLI::App* command = app.add_subcommand("compare", "Compare recorded runs in overlaid figures");
  option(command, "RUN", options.runs, "RUN", "Recordings, or their folders")->required();
  option(command, "--out", options.out, "FOLDER",
         "Folder to write compare.html to (default: here)");
  command->add_flag_callback("--background", become_background,
                             "Run at idle priority; end when the parent process ends");
  command->footer("Example: tp100d compare runs/before runs/after --out compared");
  command->callback([&action] { action = [] { return run_compare(options); }; });
}

int run(int argc, char** argv) {
  CLI::App app("Real-time bridge for the TP100 crawler", "tp100d");
  app.set_version_flag("--version", TP100_VERSION);
  app.require_subcommand(1);
  Action action;
  add_run(app, action);
  add_ports(app, action);
  add_doctor(app, action);
  add_check(app, action);
  add_replay(app, action);
  add_identify(app, action);
  add_recover(app, action);
  add_export(app, action);
  add_report(app, action);
  add_compare(app, action);
  return text::run_command_line(app, argc, argv, action);
}

}  // namespace
}  // namespace tp100::app

int main(int argc, char** argv) {
  return tp100::text::run_program("tp100d", [&] { return tp100::app::run(argc, argv); });
}
