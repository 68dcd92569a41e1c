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
#include "server/server.h"

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
  WorldPort(boost::asio::io_context& context, const config::WorldRun& run, LiveCycle& cycle,
            messages::EventQueue& events)
      : Receiver(context),
        world_(endpoint_of(link::parse_udp(run.settings.address, "world.address"))),
        peer_(config::peer_settings(run, std::random_device{}(), false)),
        cycle_(cycle),
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
    if (sample && !cycle_.world(*sample)) peer_.count_dropped();
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
  LiveCycle& cycle_;
  messages::EventQueue& events_;
  std::uint64_t strangers_ = 0;
};

}  // namespace

class ExternalInputs::CameraPort
    : public Receiver<ExternalInputs::CameraPort, link::kMaxImageDatagram> {
 public:
  /// Listens at settings.listen, "udp:[HOST:]PORT"; without a host, only datagrams of this machine
  /// are received.
  CameraPort(boost::asio::io_context& context, const config::CameraSettings& settings,
             LiveCycle& cycle, server::Server& server)
      : Receiver(context),
        detections_(link::monotonic_clock_name(), from_s(settings.max_age_ms * 1e-3)),
        images_(link::monotonic_clock_name(), kMaxImageAgeNs),
        cycle_(cycle),
        server_(server),
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
      if (sample && !cycle_.camera(*sample)) detections_.count_dropped();
    } else if (image_interval_ns_ > 0) {
      auto image = images_.receive_image(datagram, image_interval_ns_, now);
      if (image) server_.take_image(image->taken_ns, std::move(image->jpeg));
    }
  }

  CameraFigures figures() const {
    return {.detections = detections_.counters(), .images = images_.counters()};
  }

 private:
  link::CameraIntake detections_, images_;
  LiveCycle& cycle_;
  server::Server& server_;
  const HostNs image_interval_ns_;  // 0: images are not wanted
};

ExternalInputs::ExternalInputs(boost::asio::io_context& context, const config::RunSetup& run,
                               LiveCycle& cycle, server::Server& server,
                               messages::EventQueue& events) {
  const config::CameraSettings& camera = run.configuration.camera;
  if (!camera.listen.empty())
    camera_ = std::make_unique<CameraPort>(context, camera, cycle, server);
  const config::WorldRun world = config::world_run(run);
  if (world.parameters.kind == bridge::WorldKind::kUdp)
    world_ = std::make_unique<WorldPort>(context, world, cycle, events);
  if (world.parameters.kind == bridge::WorldKind::kFiles)
    world_ = open_world_files(
        world, [&cycle](const WorldSample& received) { return cycle.world(received); }, events);
}

ExternalInputs::~ExternalInputs() = default;

void ExternalInputs::stop() {
  if (camera_ != nullptr) camera_->close();
  if (world_ != nullptr) world_->stop();
}

InputFigures ExternalInputs::figures() const {
  InputFigures out;
  if (camera_ != nullptr) out.camera = camera_->figures();
  if (world_ != nullptr) out.world = world_->figures();
  return out;
}

}  // namespace tp100::live
