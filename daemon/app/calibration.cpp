#include "app/calibration.h"

namespace tp100::app {
namespace {

// A radius of 0.4 m is two and a half times the gauge of a TP100.
constexpr double kNarrowGaugeM = 0.2;

}  // namespace

std::vector<std::string> calibration_courses(const course::ShapeValues& shape) {
  const std::string arc = shape.gauge_m <= kNarrowGaugeM ? "arc" : "wide";
  return {"calibrate-straight", "calibrate-" + arc + "-left", "calibrate-" + arc + "-right",
          "calibrate-spin-left", "calibrate-spin-right"};
}

}  // namespace tp100::app
