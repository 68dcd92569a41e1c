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
#include "live/external_inputs.h"

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
class Receiver {
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
    socket_.async_wait(udp::socket::wait_read, [this](const boost::system::error_code& error) {
      if (!error && socket_.is_open()) take();
    });
  }
  void send(const std::string& datagram, const udp::endpoint& to) {
    boost::system::error_code ignored;
    socket_.send_to(boost::asio::buffer(datagram), to, 0, ignored);
  }
  void close() {
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

class WorldPort : public WorldLink, public Receiver<WorldPort, worlds::kMaxWorldDatagram> {
 public:
  /// Sends hello at the first step.
  WorldPort(boost::asio::io_context& context, const config::WorldRun& run, config::GiveWorld give,
            messages::EventQueue& events)
      : Receiver(context),
        world_(endpoint_of(link::parse_udp(run.settings.address, "world.address"))),
        peer_(config::peer_settings(run, std::random_device{}(), false)),
        give_(std::move(give)),
        events_(events) {
    const udp::endpoint local = local_endpoint(run.settings.listen, world_);
    if (const auto error = listen_at(local)) {
      throw UserError("world: cannot listen at udp:" + local.address().to_string() + ":" +
                      std::to_string(local.port()) + " (" + error.message() +
                      "); choose another world.listen");
    }
    wait();
  }

  void receive(std::string_view datagram, const udp::endpoint& sender, HostNs now) {
    if (sender.address() != world_.address()) {
      ++strangers_;
      return;
    }
    const auto sample = peer_.receive(datagram, sender.port(), now);
    if (sample && !give_(*sample)) peer_.count_dropped();
    if (const auto reply = peer_.take_reply()) send(*reply, sender);
  }

  void take(const StepRecord& record) override {
    if (const auto datagram = peer_.step(record, monotonic_now())) send(*datagram, world_);
    if (std::string note = peer_.take_note(); !note.empty())
      events_.note(std::move(note), messages::Event::Level::kInfo);
  }
  void stop() override { close(); }
  bool ended_by(std::chrono::steady_clock::time_point) override { return true; }
  WorldFigures figures() const override {
    return {.udp = peer_.counters(), .strangers = strangers_};
  }

 private:
  const udp::endpoint world_;
  worlds::Peer peer_;
  const config::GiveWorld give_;
  messages::EventQueue& events_;
  std::uint64_t strangers_ = 0;
};

}  // namespace

class CameraPort::Socket : public Receiver<CameraPort::Socket, link::kMaxImageDatagram> {
 public:
  Socket(boost::asio::io_context& context, const config::CameraSettings& settings, Give give,
         Show show)
      : Receiver(context),
        detections_(link::monotonic_clock_name(), from_s(settings.max_age_ms * 1e-3)),
        images_(link::monotonic_clock_name(), kMaxImageAgeNs),
        give_(std::move(give)),
        show_(std::move(show)),
        image_interval_ns_(settings.image_hz > 0.0 ? from_s(1.0 / settings.image_hz) : 0) {
    const link::UdpAddress address = link::parse_udp(settings.listen, "camera");
    if (const auto error = listen_at(endpoint_of(address))) {
      throw UserError("camera: cannot listen at udp:" + link::to_string(address) + " (" +
                      error.message() + "); choose another port or an address of this machine");
    }
    wait();
  }

  void receive(std::string_view datagram, const udp::endpoint& /*sender*/, HostNs now) {
    if (!link::is_image(datagram)) {
      const auto sample = detections_.receive(datagram, now);
      if (sample && !give_(*sample)) detections_.count_dropped();
    } else if (image_interval_ns_ > 0) {
      auto image = images_.receive_image(datagram, image_interval_ns_, now);
      if (image) show_(image->taken_ns, std::move(image->jpeg));
    }
  }

  CameraFigures figures() const {
    return {.detections = detections_.counters(), .images = images_.counters()};
  }

 private:
  link::CameraIntake detections_, images_;
  const Give give_;
  const Show show_;
  const HostNs image_interval_ns_;  // 0: images are not wanted
};

CameraPort::CameraPort(boost::asio::io_context& context, const config::CameraSettings& settings,
                       Give give, Show show)
    : socket_(std::make_unique<Socket>(context, settings, std::move(give), std::move(show))) {}
CameraPort::~CameraPort() = default;
void CameraPort::stop() { socket_->close(); }
CameraFigures CameraPort::figures() const { return socket_->figures(); }

std::unique_ptr<WorldLink> open_world(boost::asio::io_context& context, const config::WorldRun& run,
                                      const config::GiveWorld& give, messages::EventQueue& events) {
  switch (run.parameters.kind) {
    case bridge::WorldKind::kUdp:
      return std::make_unique<WorldPort>(context, run, give, events);
    case bridge::WorldKind::kFiles:
      return open_world_files(run, give, events);
    case bridge::WorldKind::kInternal:
      break;
  }
  return nullptr;
}

}  // namespace tp100::live
