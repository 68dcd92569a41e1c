#include "live/camera_port.h"

// Asio 1.74 uses std::exchange without including it.
#include <array>
#include <boost/asio/io_context.hpp>
#include <utility>

#include "core/clock.h"
#include "core/error.h"
#include "live/udp_socket.h"

namespace tp100::live {
namespace {

using boost::asio::ip::udp;

// More than a frame's worth at once is a flood: the operator and the log come first.
constexpr int kMostAtOnce = 32;

}  // namespace

struct CameraPort::State : std::enable_shared_from_this<State> {
  State(boost::asio::io_context& context, const config::CameraSettings& settings, Give action)
      : socket(context),
        intake(link::monotonic_clock_name(), from_s(settings.max_age_ms * 1e-3)),
        give(std::move(action)) {}

  void open(const link::UdpAddress& address) {
    if (const auto error = listen_at(socket, endpoint_of(address))) {
      throw SetupError("camera: cannot listen at udp:" + link::to_string(address) + " (" +
                       error.message() + "); choose another port or an address of this machine");
    }
  }
  void wait() {
    socket.async_wait(udp::socket::wait_read,
                      [self = shared_from_this()](const boost::system::error_code& error) {
                        if (!error && self->socket.is_open()) self->take();
                      });
  }
  void take() {
    boost::system::error_code error;
    for (int i = 0; i < kMostAtOnce && !error; ++i) {
      const std::size_t n = socket.receive(boost::asio::buffer(buffer), 0, error);
      if (error) break;
      const auto sample = intake.receive({buffer.data(), n}, monotonic_now());
      if (sample && !give(*sample)) intake.count_dropped();
    }
    wait();
  }

  udp::socket socket;
  link::CameraIntake intake;
  Give give;
  // One more than a datagram may have: a longer one is seen to be too long.
  std::array<char, link::kMaxCameraDatagram + 1> buffer{};
};

CameraPort::CameraPort(boost::asio::io_context& context, const config::CameraSettings& settings,
                       Give give)
    : state_(std::make_shared<State>(context, settings, std::move(give))) {
  state_->open(link::parse_udp(settings.listen, "camera"));
  state_->wait();
}

CameraPort::~CameraPort() { stop(); }

void CameraPort::stop() {
  boost::system::error_code ignored;
  state_->socket.close(ignored);
}

const link::CameraCounters& CameraPort::counters() const { return state_->intake.counters(); }

}  // namespace tp100::live
