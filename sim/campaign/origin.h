#pragma once
// What the results of a campaign come from besides its spec. Two programs may put runs into one
// folder, or one of them may take it up later, only if this is the same for both.

#include <map>
#include <string>

#include "sim/campaign/campaign_spec.h"

namespace tp100::sim {

/// "course 3", "robot mine.toml", "program", ... and what stands for its content: 16 hexadecimal
/// digits of a file, version and build of the program, "not there" for a file that is missing.
using Origin = std::map<std::string, std::string>;

/// This program, the libraries that do its sums, and every file that a run of the campaign may
/// read: configuration, courses, robots, cameras and, for the avr board, the firmware's image.
Origin origin_of(const CampaignSpec& spec);

/// One line for each, in alphabetical order, and back; what is none is left out. Pure.
std::string origin_text(const Origin& origin);
Origin read_origin(const std::string& text);

/// In words, what differs; empty: nothing does. Pure.
std::string difference(const Origin& before, const Origin& now);

}  // namespace tp100::sim
