#include "runs/run_result.h"

#include <array>
#include <span>
#include <utility>

#include "core/error.h"
#include "core/faults.h"
#include "text/key.h"

namespace tp100::runs {
namespace {

constexpr text::Range kAny{0.0, 1e9};

std::span<const text::Key<RunResult>> result_keys() {
  using T = RunResult;
  static const std::array<text::Key<T>, 8> kKeys = {{
      {"outcome", &T::outcome, {}, "How the run ended"},
      {"cause", &T::cause, {}, "Why it was aborted"},
      {"course", &T::course, {}, "Course in force"},
      {"robot", &T::robot, {}, "Robot in force"},
      {"duration_s", &T::duration_s, kAny, "Time under way"},
      {"distance_m", &T::distance_m, kAny, "Way along the path"},
      {"largest_m", &T::largest_m, kAny, "Largest distance from the path"},
      {"by_hand", &T::by_hand, {}, "The robot was driven by hand"},
  }};
  return kKeys;
}

}  // namespace

RunResult result_of(const RunSummary& summary, std::string course, std::string robot) {
  RunResult out{.course = std::move(course),
                .robot = std::move(robot),
                .duration_s = to_s(summary.ended_ns - summary.began_ns),
                .distance_m = summary.distance_m,
                .largest_m = summary.largest_m,
                .by_hand = summary.by_hand};
  const FaultMask others = summary.faults & ~fault_bit(Fault::stop_requested);
  if (summary.began_ns == 0) return out;
  if (summary.end == RunState::kFinished) {
    out.outcome = "completed";
  } else if (summary.end != RunState::kAborted) {
    out.outcome = "ended";
  } else if (const auto fault = first_fault(others)) {
    out.outcome = "aborted";
    out.cause = describe(*fault).cause;
  } else {
    out.outcome = "stopped";
  }
  return out;
}

std::optional<RunResult> parse_run_result(const std::string& text) {
  try {
    const text::TomlDocument document(text, kRunResultFile);
    text::TomlTable root = document.root();
    RunResult out;
    text::read_keys(root, result_keys(), out);
    return out;
  } catch (const UserError&) {
    return std::nullopt;
  }
}

std::string write_run_result(const RunResult& result) {
  return text::toml_comment("How this run went; tp100d wrote this for its list of runs.") + "\n" +
         text::write_keys(result_keys(), result);
}

}  // namespace tp100::runs
