#include "parameters.h"

#include "shared/number.h"

namespace tp100 {
namespace firmware {
namespace {

using shared::magnitude;
using shared::within;

const uint8_t kAllFlags = (wire::kSwapTracks << 1) - 1;
const uint8_t kFirstField = 2;

}  // namespace

uint8_t bad_field(const wire::Parameters& p) {
  const bool good[] = {
      within(p.counts_per_metre, 100.0f, 1e6f),
      within(p.wheelbase_m, 0.05f, 2.0f),
      within(p.wheelbase_tight_m, 0.05f, 2.0f),
      within(p.wheelbase_spin_m, 0.05f, 2.0f),
      within(p.turn_slip_share, 0.0f, 1.0f),
      within(p.slip_left, -0.5f, 0.9f),
      within(p.slip_right, -0.5f, 0.9f),
      within(p.max_track_mps, 0.01f, 2.0f),
      within(p.max_track_mps2, 0.05f, 20.0f),
      within(p.feed_forward, 0.0f, 100.0f),
      within(p.dead_band, 0.0f, 0.9f),
      within(p.speed_kp, 0.0f, 100.0f),
      within(p.speed_ki, 0.0f, 1000.0f),
      within(p.yaw_kp, 0.0f, 50.0f),
      within(p.max_yaw_radps, 0.05f, 10.0f),
      within(magnitude(p.gyro_z_radps_per_lsb), 1e-5f, 1e-2f),
      true,  // battery_cutoff_mv
      p.stall_duty <= static_cast<uint16_t>(wire::kFullDuty),
      p.stall_ms >= 50 && p.stall_ms <= 10000,
      p.command_life_ms >= 20 && p.command_life_ms <= wire::kMaxCommandLifeMs,
      p.yaw_window_ms >= 20 && p.yaw_window_ms <= 200,
      (p.flags & ~kAllFlags) == 0,
  };
  uint8_t field = kFirstField;
  for (const bool one : good) {
    if (!one) return field;
    ++field;
  }
  return 0;
}

}  // namespace firmware
}  // namespace tp100
