#include "text/unit.h"

#include <array>
#include <utility>

namespace tp100::text {

std::string_view unit_of(std::string_view key) {
  static constexpr std::array<std::pair<std::string_view, std::string_view>, 36> kUnits = {{
      {"_radps_rts", "rad/s/sqrt(s)"},
      {"_radps_rthz", "rad/s/sqrt(Hz)"},
      {"_mps2_rthz", "m/s^2/sqrt(Hz)"},
      {"_radps_per_lsb", "rad/s"},
      {"_mps_per_v", "m/s/V"},
      {"_bias_per_degc", "rad/s/K"},
      {"_radps_per_degc", "rad/s/K"},
      {"counts_per_metre", "1/m"},
      {"_amps_per_n", "A/N"},
      {"amps_per_n", "A/N"},
      {"_n_per_v", "N/V"},
      {"_radps2", "rad/s^2"},
      {"_radps", "rad/s"},
      {"_mps2", "m/s^2"},
      {"_degc", "degC"},
      {"_mps", "m/s"},
      {"_1pm", "1/m"},
      {"_1ps", "1/s"},
      {"_deg", "deg"},
      {"_rad", "rad"},
      {"_ohm", "ohm"},
      {"_ppm", "ppm"},
      {"_hz", "Hz"},
      {"_ms", "ms"},
      {"_us", "us"},
      {"_kg", "kg"},
      {"_mb", "MB"},
      {"_as", "A s"},
      {"baud", "baud"},
      {"_pa", "Pa"},
      {"_m", "m"},
      {"_s", "s"},
      {"_v", "V"},
      {"_n", "N"},
      {"_a", "A"},
      {"_bytes", "B"},
  }};
  for (const auto& [suffix, unit] : kUnits)
    if (key.ends_with(suffix)) return unit;
  return {};
}

}  // namespace tp100::text
