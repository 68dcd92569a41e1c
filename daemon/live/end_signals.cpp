#include "live/end_signals.h"

#include <csignal>
// Asio 1.74 uses std::exchange without including it.
#include <boost/asio/io_context.hpp>
#include <boost/asio/signal_set.hpp>
#include <utility>

namespace tp100::live {

struct EndSignals::State {
  explicit State(boost::asio::io_context& context) : signals(context) {}
  boost::asio::signal_set signals;
};

EndSignals::EndSignals(boost::asio::io_context& context, std::function<void(const char*)> action)
    : state_(std::make_unique<State>(context)) {
  // A log reader that goes away must not end a run without a disarm.
  std::signal(SIGPIPE, SIG_IGN);
  // Reaching the file size limit is an error like any other.
  std::signal(SIGXFSZ, SIG_IGN);
  state_->signals.add(SIGINT);
  state_->signals.add(SIGTERM);
  // The terminal was closed; under nohup the signal is already ignored.
  struct sigaction hang_up {};
  if (::sigaction(SIGHUP, nullptr, &hang_up) == 0 && hang_up.sa_handler == SIG_DFL)
    state_->signals.add(SIGHUP);
  state_->signals.async_wait(
      [action = std::move(action)](const boost::system::error_code& error, int signal) {
        if (error) return;
        action(signal == SIGINT ? "SIGINT" : signal == SIGHUP ? "SIGHUP" : "SIGTERM");
      });
}

EndSignals::~EndSignals() = default;

void EndSignals::cancel() { state_->signals.cancel(); }

}  // namespace tp100::live
