#pragma once
// The whole experiment of the paper on the emulated robots: the runs and their results.

#include <optional>
#include <string>
#include <vector>

#include "course/robot_file.h"
#include "sim/lab/body_slope.h"
#include "sim/lab/body_turn.h"
#include "sim/lab/real_study.h"
#include "sim/lab/state_study.h"
#include "sim/lab/study.h"
#include "sim/trials/commands.h"

namespace tp100::report {
class HtmlPage;
}

namespace tp100::sim {

struct ReproduceCommand {
  std::string out = "reproduce";  ///< folder
  /// paper, state, robots, uneven, covariance, constants, sampled, held-out, real, avr, all of
  /// these, or random.
  std::string part = "all";
  std::string body{};  ///< ode or shear; empty: ode. With shear `all` is study_shear(), and of the
                       ///< parts there are covariance and constants
  std::uint64_t seed = 1;
  int runs = 10;
  int sampled = 10;  ///< number of sampled robots, each driven with one seed
};

/// Drives the part on all processors, writes index.html, results.json and the trajectories into the
/// folder and prints the table of limits. Returns 0 if every limit holds and every run was
/// completed, else 1. Throws UserError.
int run_reproduce(const ReproduceCommand& command);

// The results of a reproduction, as one page and as one JSON object.

/// Everything that was driven.
struct Reproduction {
  course::Robot reference{};
  std::vector<SlopeSlip> slopes;    ///< of the reference robot, one per row of slope_rows()
  std::vector<BodyTurn> turns;      ///< of the reference robot's body
  std::optional<ClimbCheck> climb;  ///< of the reference robot over the block of course 3
  std::vector<CourseStudy> studies;
  std::vector<RealStudy> real;  ///< `studies` has their figures with limits
  int runs = 0;
  std::uint64_t seed = 1;
  std::string date = {}, program = {};  ///< when and with what it was driven
};

/// Largest difference between measured slip and the paper's table, and its limit.
inline constexpr double kSlopeLimit = 0.02;
double worst_slope_difference(const Reproduction& what);
/// Whether every run was completed and every limit holds.
bool all_hold(const Reproduction& what);

/// One offline HTML page.
std::string reproduction_page(const Reproduction& what);
/// One JSON object.
std::string reproduction_json(const Reproduction& what);
/// The table of limits and that of forms, for a terminal.
std::string reproduction_table(const Reproduction& what);

// Equivalent wheelbase of a tracked robot, eq 7.

/// Geometry used by eq 7; the paper's table prints all but gamma.
struct WheelbaseGeometry {
  double length_m = 0.133;       ///< a, axle spacing
  double width_m = 0.160;        ///< b, distance between the tracks
  double offset_x_m = 0.00174;   ///< centre of mass ahead of the middle
  double offset_y_m = -0.00137;  ///< centre of mass left of the middle
  double gamma = 8.049;          ///< ours: the value that gives the printed 0.2742 m
};

/// L = 2 ((b/2 - gamma dy)^2 + (a/2 - dx)^2) / (b/2 - gamma dy). [m]
double equivalent_wheelbase_m(const WheelbaseGeometry& geometry);

// Sections of the page: the paper's tables and equations beside the emulated robot's.

/// Writes tables 1 to 4, eq 7 and eq 6 beside the emulated robot; each part if it was driven.
void write_tables(report::HtmlPage& page, const Reproduction& what);

// Errors of each form of the model on the same runs.

/// Writes the section of the page; nothing without a study on the flat floor.
void write_forms(report::HtmlPage& page, const Reproduction& what);
/// Largest errors of every form by robot, for a terminal.
std::string forms_table(const Reproduction& what);

}  // namespace tp100::sim
