#include <CLI/CLI.hpp>
#include <csignal>
#include <functional>
#include <string>
#include <vector>

#include "sim/campaign/campaign_command.h"
#include "sim/robot/commands.h"
#include "sim/trials/commands.h"
#include "text/command_line.h"

namespace {

using namespace tp100::sim;
using tp100::text::option;

void add_seed(CLI::App& app, Options& options) {
  option(&app, "--seed", options.seed, "NUMBER", "Seed of this run's noise, 0 or more")
      ->check(why_no_seed)
      ->capture_default_str();
}

void add_body(CLI::App& app, std::string& body) {
  option(&app, "--body", body, "BODY",
         "Contact of the tracks. ode: rigid bodies; shear: shear stress that builds up along "
         "the track, on level ground only (default: the robot file's contact_law)");
}

void add_floor(CLI::App& app, std::string& floor) {
  option(&app, "--floor", floor, "FLOOR",
         "even, or uneven: friction and slip over the floor, tension of the tracks, payload and "
         "battery are sampled from the seed as the robot file's [emulated.variation] "
         "describes (default: the robot file's floor)");
}

void add_common(CLI::App& app, Options& options) {
  option(&app, "--board", options.board, "BOARD", "What runs the firmware: native or avr")
      ->capture_default_str();
  add_body(app, options.body);
  add_floor(app, options.floor);
  option(&app, "--robot", options.robot, "ROBOT",
         "Name in config/robots or file (default: end-loaded)");
  option(&app, "--setup", options.setup, "SETUP", "stand, flat or terrain (default: flat)");
  add_seed(app, options);
}

void add_faults(CLI::App& app, std::vector<std::string>& faults) {
  option(&app, "--fault", faults, "FAULT",
         "NAME[:NUMBER][:WORD][@T[+D]]: from T s after the port was opened, for D s; may be "
         "repeated; tp100-sim faults lists them")
      ->allow_extra_args(false);
}

/// The requested command.
using Action = std::function<int()>;

void add_course_command(CLI::App& app, Action& action) {
  static CourseCommand course;
  CLI::App* command = app.add_subcommand("course", "Drive a course in virtual time and score it");
  command->add_option("COURSE", course.course, "Name in config/courses or file")->required();
  add_common(*command, course.options);
  option(command, "--config", course.options.config, "FILE",
         "Configuration of the daemon's part (default: as config/tp100.toml)");
  command
      ->add_flag("--camera{overhead}", course.camera,
                 "Add an overhead camera; =CAMERA: name in config/cameras or file; =FILE.tum: "
                 "poses that tp100-camera --tum found in images of the same drive, with times in "
                 "seconds since its beginning")
      ->type_name("CAMERA");
  option(command, "--world", course.world, "WORLD",
         "An external world: udp:PORT or udp:ADDRESS:PORT; every pose waits for its answer "
         "(default: the course's ramps and blocks)");
  add_faults(*command, course.faults);
  option(command, "--runs", course.runs, "NUMBER", "Runs with this and the following seeds")
      ->check(CLI::Range(1, 1000000))
      ->capture_default_str();
  option(command, "--out", course.out, "FOLDER",
         "Folder for the files of each run: figures (JSON), poses and samples (CSV; in both "
         "t_s is 0 where the run begins)");
  option(command, "--record", course.record, "FOLDER",
         "Folder for recordings; each run gets its own folder in it");
  command
      ->add_flag("--ros2{lo}", course.ros2,
                 "Publish all ROS 2 topics, /clock and /ground_truth, at most in real time; "
                 "=INTERFACE: network interface")
      ->type_name("INTERFACE");
  command->add_flag("--json", course.json, "One JSON object a line instead of tables");
  command->footer("Example: tp100-sim course 3 --setup terrain --runs 5");
  command->callback([&action] { action = [] { return run_course(course); }; });
}

void add_robot_command(CLI::App& app, Action& action) {
  static RobotCommand robot;
  CLI::App* command = app.add_subcommand("robot", "A robot on a pseudo-terminal, in real time");
  add_common(*command, robot.options);
  option(command, "--link", robot.link, "PATH", "Symbolic link to make to the port");
  add_faults(*command, robot.faults);
  command->add_flag("--blank", robot.blank, "Only the bootloader is on the avr board: flash it");
  option(command, "--course", robot.course, "COURSE",
         "Course that sets the start pose and the disturbances (default: none)");
  command
      ->add_flag("--camera{overhead}", robot.camera,
                 "Add an overhead camera; =CAMERA: name in config/cameras or file")
      ->type_name("CAMERA");
  option(command, "--camera-to", robot.camera_to, "ADDRESS",
         "Where its detections go, udp:PORT or udp:HOST:PORT (default: udp:47100)");
  command
      ->add_flag(
          "--ros2{lo}", robot.ros2,
          "Publish the true pose on ROS 2's topic /ground_truth; =INTERFACE: network interface")
      ->type_name("INTERFACE");
  command->footer("Example: tp100-sim robot --link /tmp/tp100");
  command->callback([&action] { action = [] { return run_robot(robot); }; });
}

void add_calibrate_command(CLI::App& app, Action& action) {
  static CalibrateCommand calibrate;
  CLI::App* command = app.add_subcommand(
      "calibrate", "Drive the calibration courses and boards; record them for tp100d identify");
  option(command, "--board", calibrate.options.board, "BOARD", "native or avr")
      ->capture_default_str();
  add_body(*command, calibrate.options.body);
  add_floor(*command, calibrate.options.floor);
  option(command, "--robot", calibrate.options.robot, "ROBOT",
         "Name in config/robots or file (default: end-loaded)");
  add_seed(*command, calibrate.options);
  option(command, "--repeats", calibrate.repeats, "NUMBER", "Drives of each kind and direction")
      ->check(CLI::Range(1, 100))
      ->capture_default_str();
  option(command, "--out", calibrate.out, "FOLDER", "Folder for the recordings (CSV)")->required();
  command->footer("Example: tp100-sim calibrate --robot worn --out drives");
  command->callback([&action] { action = [] { return run_calibrate(calibrate); }; });
}

void add_demo_command(CLI::App& app, Action& action) {
  static DemoCommand demo;
  CLI::App* command =
      app.add_subcommand("demo", "Start tp100d and tp100-sim robot and watch them drive");
  option(command, "--course", demo.course, "COURSE", "Name in config/courses or file")
      ->capture_default_str();
  option(command, "--board", demo.options.board, "BOARD", "What runs the firmware: native or avr")
      ->capture_default_str();
  option(command, "--robot", demo.options.robot, "ROBOT",
         "Name in config/robots or file (default: end-loaded)");
  add_seed(*command, demo.options);
  command->add_flag("--headless", demo.headless,
                    "Open no page; end after the run and print the result table");
  command->footer("Example: tp100-sim demo --course 2");
  command->callback([&action] { action = [] { return run_demo(demo); }; });
}

void add_faults_command(CLI::App& app, Action& action) {
  CLI::App* command = app.add_subcommand("faults", "List what --fault can do to a robot");
  command->footer("Example: tp100-sim faults");
  command->callback([&action] { action = run_faults; });
}

void add_campaign_command(CLI::App& app, Action& action) {
  static CampaignCommand campaign;
  CLI::App* command = app.add_subcommand(
      "campaign", "Drive many runs whose variation a file defines; runs already done are kept");
  command
      ->add_option("SPEC", campaign.spec,
                   "Campaign file; config/campaigns/course-3.toml explains the format")
      ->required();
  option(command, "--out", campaign.out, "FOLDER", "Folder of the campaign")->required();
  // By a function, because CLI11 leaves an optional unset for an empty text.
  command
      ->add_option_function<std::string>(
          "--index", [](const std::string& runs) { campaign.index = runs; },
          "Only these runs, as 3, 3-7 or 3,5-7,12 (default: all)")
      ->type_name("RUNS");
  option(command, "--record", campaign.record, "FOLDER",
         "Folder for recordings; each run gets its own folder in it, even if it was done before");
  option(command, "--todo", campaign.todo, "N",
         "Drive nothing; print the missing runs in the form of --index, at most N runs a line")
      ->check(CLI::Range(1, 1000000));
  command->footer("Example: tp100-sim campaign config/campaigns/course-3.toml --out course-3");
  command->callback([&action] { action = [] { return run_campaign(campaign); }; });
}

void add_merge_command(CLI::App& app, Action& action) {
  static std::string merge;
  CLI::App* command = app.add_subcommand(
      "merge", "Merge the runs of a campaign into merged.json, runs.csv and a page");
  command->add_option("FOLDER", merge, "The --out of the campaign")->required();
  command->footer("Example: tp100-sim merge course-3");
  command->callback([&action] { action = [] { return run_merge(merge); }; });
}

int run(int argc, char** argv) {
  CLI::App app{"Emulated TP100: the firmware on a physical body, over a wire with real byte times",
               "tp100-sim"};
  app.set_version_flag("--version", TP100_VERSION);
  app.require_subcommand(1);

  Action action;
  add_course_command(app, action);
  add_robot_command(app, action);
  add_calibrate_command(app, action);
  add_demo_command(app, action);
  add_faults_command(app, action);
  add_campaign_command(app, action);
  add_merge_command(app, action);
  return tp100::text::run_command_line(app, argc, argv, action);
}

}  // namespace

int main(int argc, char** argv) {
  // Report a file at its size limit as an error instead of ending by a signal.
  std::signal(SIGXFSZ, SIG_IGN);
  return tp100::text::run_program("tp100-sim", [&] { return run(argc, argv); });
}
