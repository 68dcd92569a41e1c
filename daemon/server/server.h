#pragma once
// The server: one TCP port for the page and the Foxglove WebSocket protocol (CHANNELS.md), in two
// threads: "sockets" owns the sockets and carries out STOP at once (server/sockets.h), "server",
// the server thread, answers all other requests and publishes the steps. Beast stays in the source
// files.

#include <memory>
#include <string>
#include <vector>

#include "config/configuration.h"
#include "messages/messages.h"
#include "messages/parameter_text.h"
#include "messages/sink.h"
#include "server/access.h"
#include "server/broker.h"
#include "server/controls.h"
#include "server/http_content.h"

namespace tp100::server {

struct ServerSettings {
  /// HOST:PORT, with port 0 for any free one; "auto": 127.0.0.1:8765, or any free port of that
  /// address if that one is in use; "off": serves only `listener`.
  std::string listen = "auto";
  AccessRules access{};
  config::CommandsFrom commands = config::CommandsFrom::kLocal;
  std::size_t max_clients = 64;
  double units_per_s = Budgets::kUnitsPerS;  ///< of viewers, and of HTTP requests of an address
  std::string name{};                        ///< of the robot, for people
  /// Pages of other robots, besides those found on this machine.
  std::vector<std::string> robots{};
  HttpSources content{};             ///< the server itself adds health, robots and history
  std::vector<ServiceRow> services;  ///< besides those of motion
  bool real_time = false;            ///< the sockets' thread has loop::kBelowTheLoop, if permitted
  Listener listener;  ///< called from the constructor and the server's thread; must not block
};

class Server : public messages::Sink {
 public:
  /// Listens; serves nothing before start(). Throws UserError if the address is not available.
  /// `controls` must outlive the server; its stop() is called by the sockets' thread, all else by
  /// the server thread's.
  Server(ServerSettings settings, const messages::Messages& messages,
         std::vector<messages::ParameterText> parameters, Controls& controls);
  /// Closes every client's connection, waiting a second at most.
  ~Server() override;

  /// "http://127.0.0.1:8765/"; empty: off.
  const std::string& url() const;
  /// Why this is not the usual port, in one line; empty: it is, or another one was configured.
  const std::string& note() const;
  /// Starts the threads, and lets other daemons of this machine find it.
  void start();

  // Call these from any one thread, never the real-time one; they never wait for a client.
  /// Another course, robot or set-up is in force with the steps that follow; `setup` are its
  /// messages::setup_messages(). Viewers stay.
  void exchange(messages::RunContext run_context, messages::SharedMessages setup,
                std::vector<messages::ParameterText> parameters);
  void take(const StepRecord& record) override;
  void take(const messages::Event& event);
  /// An image of a camera (JPEG), taken at host time `at`.
  void take_image(HostNs at, std::string jpeg);
  /// STOP was pressed elsewhere (a key, a node) and is on its way to the robot. Any thread.
  void stop_pressed(const std::string& by);
  /// The robot acknowledged a STOP at host time `at`.
  void stop_answered(HostNs at);
  /// Waits until all that was taken is published on the channels; a second at most.
  void flush();
  /// Whether a client's request still waits for the disk; the destructor would wait, too.
  bool waits_for_disk();

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace tp100::server
