// viewer_load PORT SECONDS: 50 viewers at once, one of which never reads, one sends garbage and one
// sends frames of 100 MB. Prints one JSON object with what the server says of them.

#include <atomic>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <thread>
#include <vector>

#include "../publish/web_client.h"

namespace {

using tp100::publish::Channel;
using tp100::publish::WebClient;
using namespace std::chrono_literals;

constexpr int kGood = 47;

template <class Once>
std::thread hostile(const std::string& port, const std::atomic<bool>& over, Once once) {
  return std::thread([&over, port, once] {
    while (!over) {
      try {
        WebClient client(port);
        while (!over && !client.closed()) once(client);
      } catch (const std::runtime_error&) {
      }
      std::this_thread::sleep_for(10ms);
    }
  });
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 3) {
    std::fprintf(stderr, "usage: viewer_load PORT SECONDS\n");
    return 2;
  }
  const std::string port = argv[1];
  const auto end = std::chrono::steady_clock::now() +
                   std::chrono::milliseconds(static_cast<int>(std::atof(argv[2]) * 1e3));
  // What the page asks for.
  const std::vector<Channel> page = {Channel::kEstimate, Channel::kSlip,  Channel::kLink,
                                     Channel::kLoop,     Channel::kState, Channel::kTransforms};
  std::vector<WebClient> good;
  for (int i = 0; i < kGood; ++i) {
    good.emplace_back(port);
    for (const Channel channel : page) good.back().subscribe(channel);
  }
  WebClient deaf(port);
  for (std::uint32_t i = 1; i <= tp100::publish::kChannelCount; ++i)
    deaf.subscribe(static_cast<Channel>(i));
  WebClient watcher(port);
  watcher.subscribe(Channel::kClient);
  std::atomic<bool> over{false};
  std::thread garbage = hostile(port, over, [](WebClient& client) {
    client.write_text("[[[[{{{{");
    client.write_raw(std::string(500, '\xa5'));
  });
  std::thread large = hostile(port, over, [](WebClient& client) {
    client.write_raw_header(100'000'000);
    for (int i = 0; i < 1600 && !client.closed(); ++i) client.write_raw(std::string(65536, 'x'));
  });
  unsigned long long dropped = 0;
  while (std::chrono::steady_clock::now() < end) {
    for (WebClient& client : good) client.drain();
    dropped = std::max<unsigned long long>(dropped, watcher.number_after("\"dropped_total\":"));
    std::this_thread::sleep_for(5ms);
  }
  over = true;
  garbage.join();
  large.join();
  std::size_t received = 0, lost = 0;
  for (WebClient& client : good) {
    received += client.received();
    lost += client.closed() ? 1U : 0U;
  }
  std::printf("{\"received\":%zu,\"lost_viewers\":%zu,\"dropped\":%llu}\n", received, lost,
              dropped);
  return 0;
}
