#pragma once
// What a viewer may ask of the daemon. The server has checked the arguments and the state; whoever
// implements this passes them on. Every call comes from the thread that serves STOP and must not
// block: not for a disk, nor for a lock that somebody holds while waiting for one.

#include <functional>
#include <string>

#include "core/start_rule.h"
#include "core/time.h"
#include "messages/figures.h"
#include "messages/parameter_text.h"

namespace tp100::server {

class Controls {
 public:
  virtual ~Controls() = default;

  // Each returns why it cannot be done, in one line; empty: accepted.
  virtual std::string start() = 0;
  virtual std::string hold() = 0;
  /// Cannot be refused.
  virtual void stop() = 0;
  /// `value` has the right type and lies within the limits.
  virtual std::string set(const messages::ParameterText& parameter,
                          const messages::ParameterValue& value) = 0;

  /// Why it failed, in one line, or nothing; and the recording, which has begun or ended. Called
  /// once, from any thread, when the disk has done its part.
  using RecordAnswer =
      std::function<void(const std::string& why, const messages::RecordingFigures& recorded)>;
  virtual void record_start(const std::string& name, RecordAnswer answer) = 0;
  virtual void record_stop(RecordAnswer answer) = 0;

  // What only others know; cheap enough to ask often.
  virtual messages::LoopFigures loop() = 0;
  virtual messages::PortFigures port() = 0;
  virtual messages::RecordingFigures recording() = 0;
  /// What a start takes now.
  virtual StartConsent start_consent() = 0;
};

}  // namespace tp100::server
