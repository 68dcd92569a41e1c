#include <CLI/CLI.hpp>
#include <cstdio>
#include <exception>

#include "core/error.h"
#include "sim/run/course_command.h"
#include "sim/run/demo_command.h"
#include "sim/run/robot_command.h"

namespace {

using namespace tp100::sim;

void add_common(CLI::App& app, Options& options) {
  app.add_option("--board", options.board, "What runs the firmware: native or avr")
      ->capture_default_str();
  app.add_option("--robot", options.robot, "Robot: bundled name or file (default: end-loaded)");
  app.add_option("--setup", options.setup, "bench, flat or terrain (default: flat)");
  app.add_option("--seed", options.seed, "Noise of this run")->capture_default_str();
}

int run(int argc, char** argv) {
  CLI::App app{"Emulated TP100: the firmware on a physical body, over a wire with real byte times"};
  app.require_subcommand(1);

  CourseCommand course;
  CLI::App* course_app =
      app.add_subcommand("course", "Drive a course in virtual time and score it");
  course_app->add_option("COURSE", course.course, "Course: bundled name or file")->required();
  add_common(*course_app, course.options);
  course_app->add_option("--config", course.options.config, "Configuration of the daemon's part");
  course_app->add_option("--runs", course.runs, "Runs with this and the following seeds")
      ->check(CLI::Range(1, 1000000))
      ->capture_default_str();
  course_app->add_option("--out", course.out, "Folder for one JSON and one CSV file a run");
  course_app->add_flag("--json", course.json, "One JSON object a line instead of tables");

  RobotCommand robot;
  CLI::App* robot_app = app.add_subcommand("robot", "A robot on a pseudo-terminal, in real time");
  add_common(*robot_app, robot.options);
  robot_app->add_option("--link", robot.link, "Symbolic link to the port");
  robot_app->add_flag("--blank", robot.blank, "Only the bootloader is on the avr board: flash it");
  robot_app->add_option("--course", robot.course, "Course whose start pose it stands at");

  DemoCommand demo;
  CLI::App* demo_app =
      app.add_subcommand("demo", "Start tp100d and tp100-sim robot and watch them drive");
  demo_app->add_option("--course", demo.course, "Course: bundled name or file")
      ->capture_default_str();
  demo_app->add_option("--board", demo.options.board, "What runs the firmware: native or avr")
      ->capture_default_str();
  demo_app->add_option("--robot", demo.options.robot, "Robot: bundled name or file");
  demo_app->add_option("--seed", demo.options.seed, "Noise of this run")->capture_default_str();
  demo_app->add_flag("--headless", demo.headless, "No live line; end with the result table");

  try {
    app.parse(argc, argv);
  } catch (const CLI::CallForHelp& help) {
    return app.exit(help);
  } catch (const CLI::ParseError& error) {
    std::fprintf(stderr, "tp100-sim: %s; see tp100-sim --help\n", error.what());
    return 2;
  }
  if (*course_app) return run_course(course);
  if (*robot_app) return run_robot(robot);
  return run_demo(demo);
}

}  // namespace

int main(int argc, char** argv) {
  try {
    return run(argc, argv);
  } catch (const tp100::SetupError& error) {
    std::fprintf(stderr, "tp100-sim: %s\n", error.what());
    return 2;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "tp100-sim: %s; this is a defect, please report it\n", error.what());
    return 1;
  }
}
