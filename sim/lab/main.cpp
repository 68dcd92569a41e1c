// tp100-lab: asks whether the model is right. What drives a robot is tp100d and tp100-sim.

#include <CLI/CLI.hpp>
#include <csignal>
#include <cstdint>
#include <functional>
#include <string>

#include "sim/lab/auto_study.h"
#include "sim/lab/body_slope.h"
#include "sim/lab/calibration.h"
#include "sim/lab/reproduce.h"
#include "sim/robot/options.h"
#include "text/command_line.h"

namespace {

using namespace tp100::sim;

/// The requested command.
using Action = std::function<int()>;

void add_seed(CLI::App& app, std::uint64_t& seed) {
  app.add_option("--seed", seed, "First seed, 0 or more")
      ->check(why_no_seed)
      ->type_name("NUMBER")
      ->capture_default_str();
}

void add_reproduce_command(CLI::App& app, Action& action) {
  static ReproduceCommand reproduce;
  CLI::App* command = app.add_subcommand(
      "reproduce", "Drive the paper's whole experiment; writes a page and a JSON file of figures");
  command->add_option("--out", reproduce.out, "Folder for page, JSON and trajectories")
      ->type_name("FOLDER")
      ->capture_default_str();
  command
      ->add_option("--part", reproduce.part,
                   "paper (reference robot), state (slopes and steps, camera noise), robots (all "
                   "others), uneven (floors sampled from the seed), covariance (does it contain "
                   "the true pose?), constants (which of the model's pay), sampled (robots sampled "
                   "from stated ranges), held-out (courses that are not bundled), real (measured "
                   "data of real robots), avr (course 3 on the image), all of these, or random "
                   "(50 random courses a run)")
      ->type_name("PART")
      ->capture_default_str();
  command
      ->add_option("--body", reproduce.body,
                   "ode, or shear: every robot is identified on the other contact law, then driven "
                   "on courses that are not used for calibration (default: ode)")
      ->type_name("BODY");
  add_seed(*command, reproduce.seed);
  command->add_option("--runs", reproduce.runs, "Seeds per course, each driven in both directions")
      ->check(CLI::Range(1, 10000))
      ->type_name("NUMBER")
      ->capture_default_str();
  command
      ->add_option("--sampled", reproduce.sampled,
                   "Robots to sample from the ranges in sim/lab/sampled.h; each is identified "
                   "first, then drives every course")
      ->check(CLI::Range(0, 10000))
      ->type_name("NUMBER")
      ->capture_default_str();
  command->footer("Example: tp100-lab reproduce --part paper --runs 3");
  command->callback([&action] { action = [] { return run_reproduce(reproduce); }; });
}

void add_robot(CLI::App& app, Options& options, const char* standard) {
  app.add_option("--board", options.board, "What runs the firmware: native or avr")
      ->type_name("BOARD")
      ->capture_default_str();
  app.add_option("--body", options.body, "ode or shear (default: the robot file's)")
      ->type_name("BODY");
  app.add_option("--floor", options.floor, "even or uneven (default: the robot file's)")
      ->type_name("FLOOR");
  app.add_option("--robot", options.robot,
                 std::string("Name in config/robots or file (default: ") + standard + ")")
      ->type_name("ROBOT");
  add_seed(app, options.seed);
}

void add_calibrate_command(CLI::App& app, Action& action) {
  static JudgeCommand calibrate;
  CLI::App* command = app.add_subcommand(
      "calibrate", "Drive as tp100-sim calibrate does, identify, compare with the true motion");
  add_robot(*command, calibrate.options, "end-loaded");
  command->add_option("--runs", calibrate.runs, "Calibrations with this and the following seeds")
      ->check(CLI::Range(1, 10000))
      ->type_name("NUMBER")
      ->capture_default_str();
  command->footer("Example: tp100-lab calibrate --robot worn --runs 50");
  command->callback([&action] { action = [] { return run_judge(calibrate); }; });
}

void add_identify_command(CLI::App& app, Action& action) {
  static AutoCommand identify;
  CLI::App* command = app.add_subcommand(
      "identify", "Let emulated robots choose their manoeuvres until they are identified");
  add_robot(*command, identify.options, "end-loaded; with --sampled all");
  command->add_option("--runs", identify.runs, "Identifications with this and the following seeds")
      ->check(CLI::Range(1, 10000))
      ->type_name("NUMBER")
      ->capture_default_str();
  command->add_option("--course", identify.area, "Course whose fence the manoeuvres stay within")
      ->type_name("COURSE")
      ->capture_default_str();
  command
      ->add_option("--sampled", identify.sampled,
                   "Also this many robots sampled from the ranges in sim/lab/sampled.h")
      ->check(CLI::Range(0, 10000))
      ->type_name("NUMBER")
      ->capture_default_str();
  command->footer("Example: tp100-lab identify --robot worn --runs 5");
  command->callback([&action] { action = [] { return run_auto(identify); }; });
}

void add_slope_command(CLI::App& app, Action& action) {
  static std::string robot;
  CLI::App* command =
      app.add_subcommand("slope", "Measure slip up to 28 deg of slope, beside the paper's table");
  command->add_option("--robot", robot, "Name in config/robots or file (default: end-loaded)")
      ->type_name("ROBOT");
  command->footer("Example: tp100-lab slope --robot uniform");
  command->callback([&action] { action = [] { return run_slope(robot); }; });
}

int run(int argc, char** argv) {
  CLI::App app{"The laboratory of tp100: studies that ask whether its model is right", "tp100-lab"};
  app.set_version_flag("--version", TP100_VERSION);
  app.require_subcommand(1);

  Action action;
  add_reproduce_command(app, action);
  add_calibrate_command(app, action);
  add_identify_command(app, action);
  add_slope_command(app, action);
  return tp100::text::run_command_line(app, argc, argv, action);
}

}  // namespace

int main(int argc, char** argv) {
  // Report a file at its size limit as an error instead of ending by a signal.
  std::signal(SIGXFSZ, SIG_IGN);
  return tp100::text::run_program("tp100-lab", [&] { return run(argc, argv); });
}
