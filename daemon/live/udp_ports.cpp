#include "live/udp_ports.h"

// Asio 1.74 uses std::exchange without including it.
#include <utility>
// clang-format off
#include <boost/asio/io_context.hpp>
#include <boost/asio/ip/udp.hpp>
// clang-format on
#include <array>
#include <random>

#include "core/clock.h"
#include "core/error.h"
#include "link/udp.h"

namespace tp100::live {
namespace {

using boost::asio::ip::udp;

// More datagrams than this at once are a flood: operator and log are served first.
constexpr int kMaxAtOnce = 32;
// Images are for people and recordings only, so a slow network does no harm.
constexpr HostNs kMaxImageAgeNs = 2 * kNsPerS;

/// Throws SetupError: unknown host.
udp::endpoint endpoint_of(const link::UdpAddress& address) {
  const sockaddr_in resolved = link::resolve(address);
  return {boost::asio::ip::address_v4(ntohl(resolved.sin_addr.s_addr)), address.port};
}

/// Opens `socket`, non-blocking, to receive datagrams at `local`.
boost::system::error_code listen_at(udp::socket& socket, const udp::endpoint& local) {
  boost::system::error_code error;
  socket.open(udp::v4(), error);
  if (!error) socket.bind(local, error);
  if (!error) socket.non_blocking(true, error);
  return error;
}

/// Local address: as configured, else any port of the interface that reaches the world.
udp::endpoint local_endpoint(const std::string& listen, const udp::endpoint& peer) {
  if (!listen.empty()) return endpoint_of(link::parse_udp(listen, "world.listen"));
  if (peer.address().is_loopback()) return {boost::asio::ip::address_v4::loopback(), 0};
  return {boost::asio::ip::address_v4::any(), 0};
}

}  // namespace

struct CameraPort::State : std::enable_shared_from_this<State> {
  State(boost::asio::io_context& context, const config::CameraSettings& settings, Give action,
        Show image)
      : socket(context),
        detections(link::monotonic_clock_name(), from_s(settings.max_age_ms * 1e-3)),
        images(link::monotonic_clock_name(), kMaxImageAgeNs),
        give(std::move(action)),
        show(std::move(image)) {
    if (settings.image_hz > 0.0) image_interval_ns = from_s(1.0 / settings.image_hz);
  }

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
    for (int i = 0; i < kMaxAtOnce && !error; ++i) {
      const std::size_t n = socket.receive(boost::asio::buffer(buffer), 0, error);
      if (error) break;
      receive({buffer.data(), n}, monotonic_now());
    }
    wait();
  }
  void receive(std::string_view datagram, HostNs now) {
    if (!link::is_image(datagram)) {
      const auto sample = detections.receive(datagram, now);
      if (sample && !give(*sample)) detections.count_dropped();
    } else if (image_interval_ns > 0) {
      auto image = images.receive_image(datagram, image_interval_ns, now);
      if (image) show(image->taken_ns, std::move(image->jpeg));
    }
  }

  udp::socket socket;
  link::CameraIntake detections, images;
  Give give;
  Show show;
  HostNs image_interval_ns = 0;  // 0: images are not wanted
  // One byte more than the longest valid datagram, so that a longer one is recognized.
  std::array<char, link::kMaxImageDatagram + 1> buffer{};
};

CameraPort::CameraPort(boost::asio::io_context& context, const config::CameraSettings& settings,
                       Give give, Show show)
    : state_(std::make_shared<State>(context, settings, std::move(give), std::move(show))) {
  state_->open(link::parse_udp(settings.listen, "camera"));
  state_->wait();
}

CameraPort::~CameraPort() { stop(); }

void CameraPort::stop() {
  boost::system::error_code ignored;
  state_->socket.close(ignored);
}

CameraFigures CameraPort::figures() const {
  return {.detections = state_->detections.counters(), .images = state_->images.counters()};
}

struct WorldPort::State : std::enable_shared_from_this<State> {
  State(boost::asio::io_context& context, const config::WorldRun& run, config::GiveWorld action)
      : socket(context),
        peer(config::peer_settings(run, std::random_device{}(), false)),
        give(std::move(action)) {}

  void open(const config::WorldSettings& settings) {
    const link::UdpAddress address = link::parse_udp(settings.address, "world.address");
    world = endpoint_of(address);
    const udp::endpoint local = local_endpoint(settings.listen, world);
    if (const auto error = listen_at(socket, local)) {
      throw SetupError("world: cannot listen at udp:" + local.address().to_string() + ":" +
                       std::to_string(local.port()) + " (" + error.message() +
                       "); choose another world.listen");
    }
  }
  void send(const std::string& datagram, const udp::endpoint& to) {
    boost::system::error_code ignored;
    socket.send_to(boost::asio::buffer(datagram), to, 0, ignored);
  }
  void wait() {
    socket.async_wait(udp::socket::wait_read,
                      [self = shared_from_this()](const boost::system::error_code& error) {
                        if (!error && self->socket.is_open()) self->take();
                      });
  }
  void take() {
    for (int i = 0; i < kMaxAtOnce; ++i) {
      boost::system::error_code error;
      udp::endpoint sender;
      const std::size_t n = socket.receive_from(boost::asio::buffer(buffer), sender, 0, error);
      if (error) break;
      if (sender.address() != world.address()) {
        ++strangers;
        continue;
      }
      const auto sample = peer.receive({buffer.data(), n}, sender.port(), monotonic_now());
      if (sample && !give(*sample)) peer.count_dropped();
      if (const auto reply = peer.take_reply()) send(*reply, sender);
    }
    wait();
  }

  udp::socket socket;
  udp::endpoint world;
  worlds::Peer peer;
  config::GiveWorld give;
  std::uint64_t strangers = 0;
  // One byte more than the longest valid datagram, so that a longer one is recognized.
  std::array<char, worlds::kMaxWorldDatagram + 1> buffer{};
};

WorldPort::WorldPort(boost::asio::io_context& context, const config::WorldRun& run,
                     config::GiveWorld give)
    : state_(std::make_shared<State>(context, run, std::move(give))) {
  state_->open(run.settings);
  state_->wait();
}

WorldPort::~WorldPort() { stop(); }

void WorldPort::take(const StepRecord& record) {
  if (const auto datagram = state_->peer.step(record, monotonic_now()))
    state_->send(*datagram, state_->world);
}

void WorldPort::stop() {
  boost::system::error_code ignored;
  state_->socket.close(ignored);
}

std::string WorldPort::take_note() { return state_->peer.take_note(); }
const worlds::PeerCounters& WorldPort::counters() const { return state_->peer.counters(); }
std::uint64_t WorldPort::strangers() const { return state_->strangers; }

}  // namespace tp100::live
