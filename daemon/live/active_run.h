#pragma once
// What is in force: one immutable value, exchanged as a whole when an operator chooses another
// course, robot or set-up. Whoever needs a part of it shares it.

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "config/run_setup.h"
#include "core/command.h"
#include "messages/channels.h"
#include "messages/parameter_text.h"
#include "ros2/topics.h"

namespace tp100::live {

struct ActiveRun {
  explicit ActiveRun(config::LoadedRun run);

  /// Name; empty: none.
  std::string course() const {
    return loaded.setup.course == nullptr ? "" : loaded.setup.course->name;
  }

  const config::LoadedRun loaded;      ///< the files, and what was parsed from them
  const messages::RunContext context;  ///< of its messages
  /// Every key of configuration and robot, as published to viewers.
  const std::vector<messages::ParameterText> parameters;
};

/// One exchange, and what it needs of messages: they grow with the path up to some MB, and are made
/// by a thread that nobody waits for.
struct Exchange {
  std::shared_ptr<const ActiveRun> run{};
  std::uint64_t first_step = 0;  ///< the first with it, by StepRecord::step; it restarts the step
  HostNs at_ns = 0;              ///< before anybody heard of it
  messages::SharedMessages for_viewers{};
  std::shared_ptr<const ros2::SetupMessages> for_nodes{};  ///< null: no node wants them
};

/// Hears of each exchange from the thread that drains the steps, before that passes on the first
/// step with it. Listeners do not depend on each other: whoever hears first, what begins with that
/// step agrees. A recording that ends there may end with messages of the new run.
using ExchangeListener = std::function<void(const Exchange&)>;

/// The parameter change that gives a live parameter this value; nothing if it is not live.
std::optional<ParameterChange> change_for(const messages::ParameterText& parameter,
                                          const messages::ParameterValue& value);

}  // namespace tp100::live
