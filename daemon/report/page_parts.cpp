#include "report/page_parts.h"

#include <cmath>

#include "core/arithmetic.h"
#include "core/error.h"
#include "report/metrics.h"
#include "text/format.h"

namespace tp100::report {
namespace {

constexpr std::size_t kLongestFact = 200;

std::string fact(const RecordedRun& run, const char* name) {
  const auto found = run.facts.find(name);
  return found == run.facts.end() ? std::string() : plain(found->second);
}

}  // namespace

const Rows::value_type kPoseHead = {"",         "max [cm]",   "mean [cm]",
                                    "rms [cm]", "final [cm]", "yaw max [deg]"};
const Rows::value_type kDurationHead = {"[us]", "count", "mean", "50 %", "99 %", "99.9 %", "max"};

const char* const kBaselinesCaption =
    "Simpler forms of the model on the same counts against the truth, piece by piece between "
    "disturbances: what slip compensation improves, and the extension beyond eqs 1-5";

std::string decimals(double value, int count) {
  return std::isfinite(value) ? text::format("%.*f", count, value) : "-";
}

std::string plain(const std::string& text) { return one_line(text, kLongestFact); }

std::string title_of(const RecordedRun& run) {
  const std::string course = run.result.course.empty() ? "no course" : run.result.course;
  return plain(course) + ", " + plain(run.result.robot) + ", " + plain(run.result.setup);
}

std::string date_of(const RecordedRun& run) {
  if (run.driven_unix_s > 0) return text::utc_minute(run.driven_unix_s);
  if (run.written_unix_s == 0) return "not recorded (virtual time)";
  return text::utc_minute(run.written_unix_s) + " (date of the file; driven in virtual time)";
}

std::string program_of(const RecordedRun& run) {
  const std::string program = fact(run, "program"), version = fact(run, "version");
  return (program.empty() ? "unknown program" : program) + " " + version;
}

Cell outcome(const RecordedRun& run) {
  if (run.result.completed) return "completed";
  return {"not completed: " + plain(run.result.cause), true};
}

Rows::value_type pose_row(const std::string& name, const PoseErrors& e) {
  return {name,
          decimals(e.max_position_error_m * kCmPerM, 2),
          decimals(e.mean_position_error_m * kCmPerM, 2),
          decimals(e.rms_position_error_m * kCmPerM, 2),
          decimals(e.final_position_error_m * kCmPerM, 2),
          decimals(e.max_yaw_error_rad * kDegPerRad, 2)};
}

void add_baselines(Rows& rows, const std::string& run, const RunFigures& judged) {
  for (std::size_t i = 0; i < model::kBaselines.size(); ++i)
    if (judged.baselines[i])
      rows.push_back(pose_row(run + std::string(model::kBaselines[i].key), *judged.baselines[i]));
}

Rows::value_type duration_row(const std::string& name, const messages::Durations& d) {
  return {name,
          std::to_string(d.count),
          decimals(d.mean_us, 1),
          decimals(d.p50_us, 1),
          decimals(d.p99_us, 1),
          decimals(d.p999_us, 1),
          decimals(d.max_us, 1)};
}

void add_figures(HtmlPage& page, const std::vector<Figure>& figures) {
  page.heading("Figures");
  for (const Figure& figure : figures) page.figure(figure.svg, figure.caption);
}

}  // namespace tp100::report
