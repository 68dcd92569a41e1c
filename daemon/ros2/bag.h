#pragma once
// A recording as a bag of rosbag2: MCAP with the messages of topics.h. Needs no DDS.

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "messages/messages.h"
#include "record/recording.h"

namespace tp100::ros2 {

/// Moments that people marked: Unix time and text.
using Marks = std::multimap<std::uint64_t, std::string>;

/// Writes FOLDER/FOLDER_0.mcap and FOLDER/metadata.yaml, creating the folder if absent; returns
/// their paths. A recording from virtual time also has /clock and
/// /ground_truth. Throws UserError.
std::vector<std::string> write_bag(const record::Recording& recording,
                                   const messages::RunContext& run_context, const Marks& marks,
                                   const std::string& folder);

}  // namespace tp100::ros2
