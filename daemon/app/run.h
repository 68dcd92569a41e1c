#pragma once
// `tp100d run`: the live bridge.

#include <optional>
#include <string>
#include <vector>

#include "messages/sink.h"

namespace tp100::app {

struct RunOptions {
  std::string config;
  std::string port;  ///< empty: as configured
  std::string course;
  std::string robot;
  std::string setup;
  std::string listen;       ///< "ADDRESS:PORT", "auto" or "off"; empty: as configured
  std::string camera;       ///< "udp:[HOST:]PORT"; empty: as configured
  std::string record;       ///< folder for recordings; empty: as configured
  std::string world;        ///< internal, files or "udp:[HOST:]PORT"; empty: as configured
  std::string stats;        ///< JSON file; empty: none
  bool wait = false;        ///< wait for a port and a robot instead of failing
  bool go = false;          ///< start by itself on a physical port too
  bool ran_before = false;  ///< the program drove before: a start takes the word
  bool verbose = false;     ///< the loop's times in the log once a second
  bool stay = false;  ///< a run that is over does not end the program: wait for the next start
  std::optional<double> duration_s;
  std::vector<messages::Sink*> sinks{};  ///< get every step; outlive the command
};

/// The command. 0: course completed; 1: aborted, interrupted or --duration passed. Throws
/// SetupError.
int run_run(const RunOptions& options);

}  // namespace tp100::app
