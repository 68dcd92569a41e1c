#include "bridge/parameters.h"

namespace tp100::bridge {

const char* to_string(Setup setup) {
  switch (setup) {
    case Setup::kBench:
      return "bench";
    case Setup::kFlat:
      return "flat";
    case Setup::kTerrain:
      return "terrain";
  }
  return "unknown";
}

const char* to_string(WorldKind kind) {
  switch (kind) {
    case WorldKind::kInternal:
      return "internal";
    case WorldKind::kUdp:
      return "udp";
    case WorldKind::kFiles:
      return "files";
  }
  return "unknown";
}

std::optional<WorldKind> world_kind_named(std::string_view name) {
  for (const WorldKind kind : {WorldKind::kInternal, WorldKind::kUdp, WorldKind::kFiles}) {
    if (name == to_string(kind)) return kind;
  }
  return std::nullopt;
}

std::optional<Setup> setup_named(std::string_view name) {
  for (const Setup setup : {Setup::kBench, Setup::kFlat, Setup::kTerrain}) {
    if (name == to_string(setup)) return setup;
  }
  return std::nullopt;
}

model::TrackParameters track_parameters(const Parameters& parameters) {
  const course::ModelValues& values = parameters.model;
  return {.slip_left = values.slip_left,
          .slip_right = values.slip_right,
          .slip_angle_straight_rad = values.slip_angle_straight_rad,
          .slip_angle_turning_rad = values.slip_angle_turning_rad,
          .turning_threshold_radps = values.turning_threshold_radps,
          .wheelbase_m = values.wheelbase_m,
          .x_icr_m = values.x_icr_m,
          .wheelbase_tight_m = values.wheelbase_tight_m,
          .x_icr_tight_shift_m = values.x_icr_tight_shift_m,
          .wheelbase_spin_m = values.wheelbase_spin_m,
          .x_icr_spin_shift_m = values.x_icr_spin_shift_m,
          .turn_slip = values.turn_slip,
          .turn_slip_tight = values.turn_slip_tight,
          .slip_curve = parameters.slip_curve};
}

model::TrackParameters paper_parameters(const course::ModelValues& values) {
  return {.turning_threshold_radps = values.turning_threshold_radps};
}

}  // namespace tp100::bridge
