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
#include "live/world_files.h"

namespace tp100::live {
namespace {

using boost::asio::ip::udp;

// More datagrams than this at once are a flood: operator and log are served first.
constexpr int kMaxAtOnce = 32;
// Images are for people and recordings only, so a slow network does no harm.
constexpr HostNs kMaxImageAgeNs = 2 * kNsPerS;

/// Throws UserError: unknown host.
udp::endpoint endpoint_of(const link::UdpAddress& address) {
  const sockaddr_in resolved = link::resolve(address);
  return {boost::asio::ip::address_v4(ntohl(resolved.sin_addr.s_addr)), address.port};
}

/// Receives datagrams of at most `kLongest` bytes, in the context's thread.
template <class Of, std::size_t kLongest>
class Receiver : public std::enable_shared_from_this<Of> {
 public:
  explicit Receiver(boost::asio::io_context& context) : socket_(context) {}

  boost::system::error_code listen_at(const udp::endpoint& local) {
    boost::system::error_code error;
    socket_.open(udp::v4(), error);
    if (!error) socket_.bind(local, error);
    if (!error) socket_.non_blocking(true, error);
    return error;
  }
  /// Passes each datagram to Of::receive() until it is stopped.
  void wait() {
    socket_.async_wait(udp::socket::wait_read,
                       [self = this->shared_from_this()](const boost::system::error_code& error) {
                         if (!error && self->socket_.is_open()) self->take();
                       });
  }
  void send(const std::string& datagram, const udp::endpoint& to) {
    boost::system::error_code ignored;
    socket_.send_to(boost::asio::buffer(datagram), to, 0, ignored);
  }
  void stop() {
    boost::system::error_code ignored;
    socket_.close(ignored);
  }

 private:
  void take() {
    for (int i = 0; i < kMaxAtOnce; ++i) {
      boost::system::error_code error;
      udp::endpoint sender;
      const std::size_t n = socket_.receive_from(boost::asio::buffer(buffer_), sender, 0, error);
      if (error) break;
      static_cast<Of*>(this)->receive({buffer_.data(), n}, sender, monotonic_now());
    }
    wait();
  }

  udp::socket socket_;
  // One byte more than the longest valid datagram, so that a longer one is recognized.
  std::array<char, kLongest + 1> buffer_{};
};

/// Local address: as configured, else any port of the interface that reaches the world.
udp::endpoint local_endpoint(const std::string& listen, const udp::endpoint& peer) {
  if (!listen.empty()) return endpoint_of(link::parse_udp(listen, "world.listen"));
  if (peer.address().is_loopback()) return {boost::asio::ip::address_v4::loopback(), 0};
  return {boost::asio::ip::address_v4::any(), 0};
}

}  // namespace

struct CameraPort::State : Receiver<CameraPort::State, link::kMaxImageDatagram> {
  State(boost::asio::io_context& context, const config::CameraSettings& settings, Give action,
        Show image)
      : Receiver(context),
        detections(link::monotonic_clock_name(), from_s(settings.max_age_ms * 1e-3)),
        images(link::monotonic_clock_name(), kMaxImageAgeNs),
        give(std::move(action)),
        show(std::move(image)) {
    if (settings.image_hz > 0.0) image_interval_ns = from_s(1.0 / settings.image_hz);
  }

  void open(const link::UdpAddress& address) {
    if (const auto error = listen_at(endpoint_of(address))) {
      throw UserError("camera: cannot listen at udp:" + link::to_string(address) + " (" +
                      error.message() + "); choose another port or an address of this machine");
    }
  }
  void receive(std::string_view datagram, const udp::endpoint& /*sender*/, HostNs now) {
    if (!link::is_image(datagram)) {
      const auto sample = detections.receive(datagram, now);
      if (sample && !give(*sample)) detections.count_dropped();
    } else if (image_interval_ns > 0) {
      auto image = images.receive_image(datagram, image_interval_ns, now);
      if (image) show(image->taken_ns, std::move(image->jpeg));
    }
  }

  link::CameraIntake detections, images;
  Give give;
  Show show;
  HostNs image_interval_ns = 0;  // 0: images are not wanted
};

CameraPort::CameraPort(boost::asio::io_context& context, const config::CameraSettings& settings,
                       Give give, Show show)
    : state_(std::make_shared<State>(context, settings, std::move(give), std::move(show))) {
  state_->open(link::parse_udp(settings.listen, "camera"));
  state_->wait();
}

CameraPort::~CameraPort() { stop(); }
void CameraPort::stop() { state_->stop(); }

CameraFigures CameraPort::figures() const {
  return {.detections = state_->detections.counters(), .images = state_->images.counters()};
}

struct WorldPort::State : Receiver<WorldPort::State, worlds::kMaxWorldDatagram> {
  State(boost::asio::io_context& context, const config::WorldRun& run, config::GiveWorld action,
        messages::EventQueue& queue)
      : Receiver(context),
        peer(config::peer_settings(run, std::random_device{}(), false)),
        give(std::move(action)),
        events(queue) {}

  void open(const config::WorldSettings& settings) {
    const link::UdpAddress address = link::parse_udp(settings.address, "world.address");
    world = endpoint_of(address);
    const udp::endpoint local = local_endpoint(settings.listen, world);
    if (const auto error = listen_at(local)) {
      throw UserError("world: cannot listen at udp:" + local.address().to_string() + ":" +
                      std::to_string(local.port()) + " (" + error.message() +
                      "); choose another world.listen");
    }
  }
  void receive(std::string_view datagram, const udp::endpoint& sender, HostNs now) {
    if (sender.address() != world.address()) {
      ++strangers;
      return;
    }
    const auto sample = peer.receive(datagram, sender.port(), now);
    if (sample && !give(*sample)) peer.count_dropped();
    if (const auto reply = peer.take_reply()) send(*reply, sender);
  }

  udp::endpoint world;
  worlds::Peer peer;
  config::GiveWorld give;
  messages::EventQueue& events;
  std::uint64_t strangers = 0;
};

WorldPort::WorldPort(boost::asio::io_context& context, const config::WorldRun& run,
                     config::GiveWorld give, messages::EventQueue& events)
    : state_(std::make_shared<State>(context, run, std::move(give), events)) {
  state_->open(run.settings);
  state_->wait();
}

WorldPort::~WorldPort() { stop(); }

void WorldPort::take(const StepRecord& record) {
  if (const auto datagram = state_->peer.step(record, monotonic_now()))
    state_->send(*datagram, state_->world);
  if (std::string note = state_->peer.take_note(); !note.empty())
    state_->events.note(std::move(note), messages::Event::Level::kInfo);
}

void WorldPort::stop() { state_->stop(); }

WorldFigures WorldPort::figures() const {
  return {.udp = state_->peer.counters(), .strangers = state_->strangers};
}

std::unique_ptr<WorldLink> open_world(boost::asio::io_context& context, const config::WorldRun& run,
                                      const config::GiveWorld& give, messages::EventQueue& events) {
  switch (run.parameters.kind) {
    case bridge::WorldKind::kUdp:
      return std::make_unique<WorldPort>(context, run, give, events);
    case bridge::WorldKind::kFiles:
      return std::make_unique<WorldFiles>(run, give, events);
    case bridge::WorldKind::kInternal:
      break;
  }
  return nullptr;
}

}  // namespace tp100::live
