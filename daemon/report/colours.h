#pragma once
// The colours of figures by what they show, the same in every figure of every page.

#include <array>
#include <cstddef>

#include "core/estimates.h"

namespace tp100::report {

/// A colour on paper and on light pages, and on dark ones. Figures are drawn with `light`, so that
/// they are complete files; a page exchanges it for its custom property `--<name>`.
struct Colour {
  const char *name, *light, *dark;
};

/// Path, poses and tracks: both as on the live page (daemon/web/page/theme.css). Each has a
/// contrast of at least 4.5 against its ground.
inline constexpr std::array kColours = {
    Colour{"path", "#5b6672", "#f2f5f8"}, Colour{"truth", "#806200", "#ffd23f"},
    Colour{"model", "#c42b24", "#ff5b52"}, Colour{"odometry", "#1c61bd", "#4d9fff"},
    Colour{"fused", "#12733d", "#3ad07c"}, Colour{"left", "#0f6f9c", "#58b7e8"},
    Colour{"right", "#a04f0c", "#f0a35e"},
    // For everything else: one value, one run of several.
    Colour{"value", "#6a4aa5", "#b79df2"}, Colour{"run-2", "#0b7285", "#4fd1e0"},
    Colour{"run-3", "#b0246e", "#ff85c0"}, Colour{"run-4", "#7a4a1a", "#d9a066"},
    Colour{"run-5", "#4d6b00", "#b4d94a"}, Colour{"run-6", "#3f4ea8", "#93a4ff"},
    Colour{"run-7", "#a3352c", "#ff9d8a"}, Colour{"run-8", "#45505c", "#c3ccd6"}};
inline constexpr Colour kGround{"ground", "#ffffff", "#0a0e13"};

inline constexpr const char* kPathColour = kColours[0].light;
inline constexpr const char* kTruthColour = kColours[1].light;
inline constexpr const char* kLeftColour = kColours[5].light;
inline constexpr const char* kRightColour = kColours[6].light;
inline constexpr const char* kValueColour = kColours[7].light;

constexpr const char* colour_of(PoseSource source) {
  return kColours[2 + static_cast<std::size_t>(source)].light;
}

inline constexpr std::size_t kRunColours = 8;
/// The colour of one of several runs; repeats after kRunColours.
constexpr const char* colour_of_run(std::size_t run) {
  return kColours[7 + run % kRunColours].light;
}

}  // namespace tp100::report
