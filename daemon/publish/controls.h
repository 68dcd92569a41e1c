#pragma once
// What a viewer may ask of the daemon. The server has checked the arguments and the state; whoever
// implements this passes them on. Every call comes from the server's thread and must not block.

#include <string>

#include "core/time.h"
#include "publish/figures.h"
#include "publish/parameter_text.h"

namespace tp100::publish {

class Controls {
 public:
  virtual ~Controls() = default;

  // Each returns why it cannot be done, in one line; empty: accepted.
  virtual std::string start() = 0;
  virtual std::string hold() = 0;
  /// Cannot be refused.
  virtual void stop() = 0;
  /// `value` has the right type and lies within the limits.
  virtual std::string set(const ParameterText& parameter, const ParameterValue& value) = 0;
  /// `run` gets the name of what is recorded.
  virtual std::string record_start(const std::string& name, std::string& run) = 0;
  virtual std::string record_stop(RecordingFigures& recorded) = 0;

  // What only others know; cheap enough to ask often.
  virtual LoopFigures loop() = 0;
  virtual PortFigures port() = 0;
  virtual RecordingFigures recording() = 0;
};

}  // namespace tp100::publish
