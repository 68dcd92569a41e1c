#include "live/world_port.h"

// Asio 1.74 uses std::exchange without including it.
#include <array>
#include <boost/asio/io_context.hpp>
#include <random>
#include <utility>

#include "core/clock.h"
#include "core/error.h"
#include "live/udp_socket.h"

namespace tp100::live {
namespace {

using boost::asio::ip::udp;

// A world answers once a pose. More at once is a flood: the operator and the log come first.
constexpr int kMostAtOnce = 32;

/// Where to listen: as configured, else at any port of the interface that the world is behind.
udp::endpoint local_endpoint(const std::string& listen, const udp::endpoint& peer) {
  if (!listen.empty()) return endpoint_of(link::parse_udp(listen, "world.listen"));
  if (peer.address().is_loopback()) return {boost::asio::ip::address_v4::loopback(), 0};
  return {boost::asio::ip::address_v4::any(), 0};
}

}  // namespace

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
    for (int i = 0; i < kMostAtOnce; ++i) {
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
  // One more than a datagram may have: a longer one is seen to be too long.
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
