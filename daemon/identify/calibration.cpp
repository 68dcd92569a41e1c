#include "identify/calibration.h"

namespace tp100::identify {
namespace {

// Half a metre is a wide arc for a TP100 and a tight one for a robot of twice its size.
constexpr double kNarrowGaugeM = 0.2;

}  // namespace

std::vector<std::string> calibration_courses(const course::ShapeValues& shape) {
  const bool narrow = shape.gauge_m <= kNarrowGaugeM;
  const std::string wide = narrow ? "arc" : "wide", tight = narrow ? "tight" : "arc";
  return {"calibrate-straight",
          "calibrate-" + wide + "-left",
          "calibrate-" + wide + "-right",
          "calibrate-" + tight + "-left",
          "calibrate-" + tight + "-right",
          "calibrate-spin-left",
          "calibrate-spin-right"};
}

}  // namespace tp100::identify
