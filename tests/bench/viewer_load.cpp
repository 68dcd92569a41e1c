// viewer_load PORT SECONDS: connects 50 viewers at once, of which one never reads, one sends
// garbage and one sends frames of 100 MB. viewer_load PORT SECONDS VIEWERS: connects that many
// viewers, all of which behave; a further client starts the robot again whenever its run is over,
// and records everything. Prints one JSON object with what the viewers received and lost.

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <numeric>
#include <string>
#include <thread>
#include <vector>

#include "../server/web_client.h"

namespace {

using tp100::messages::Channel;
using tp100::server::WebClient;
using namespace std::chrono_literals;

constexpr int kGood = 47;
// Ids of services that the server offers.
constexpr std::uint32_t kStart = 1, kRecord = 4, kEndRecording = 5;
constexpr auto kLookEvery = 500ms;

using Clock = std::chrono::steady_clock;

std::vector<WebClient> polite(const std::string& port, int count) {
  // The channels to which the page subscribes.
  const Channel page[] = {Channel::kEstimate, Channel::kSlip,  Channel::kLink,
                          Channel::kLoop,     Channel::kState, Channel::kTransforms};
  std::vector<WebClient> viewers;
  for (int i = 0; i < count; ++i) {
    viewers.emplace_back(port);
    for (const Channel channel : page) viewers.back().subscribe(channel);
  }
  return viewers;
}

std::size_t closed(std::vector<WebClient>& viewers) {
  return static_cast<std::size_t>(
      std::count_if(viewers.begin(), viewers.end(), [](WebClient& v) { return v.closed(); }));
}

std::size_t received(const std::vector<WebClient>& viewers) {
  return std::accumulate(viewers.begin(), viewers.end(), std::size_t{0},
                         [](std::size_t sum, const WebClient& v) { return sum + v.received(); });
}

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

/// Connects 47 viewers that behave and 3 that do not.
void load(const std::string& port, Clock::time_point end) {
  std::vector<WebClient> good = polite(port, kGood);
  WebClient deaf(port);
  for (std::uint32_t i = 1; i <= tp100::messages::kChannelCount; ++i)
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
  while (Clock::now() < end) {
    for (WebClient& client : good) client.drain();
    dropped = std::max<unsigned long long>(dropped, watcher.number_after("\"dropped_total\":"));
    std::this_thread::sleep_for(5ms);
  }
  over = true;
  garbage.join();
  large.join();
  std::printf("{\"received\":%zu,\"lost_viewers\":%zu,\"dropped\":%llu}\n", received(good),
              closed(good), dropped);
}

/// Watches, and keeps the robot driving; everything is one recording if there is a recording
/// folder.
void look_on(const std::string& port, Clock::time_point end, int count) {
  std::vector<WebClient> viewers = polite(port, count);
  WebClient watcher(port);
  watcher.subscribe(Channel::kClient);
  watcher.call(kEndRecording);
  watcher.call(kRecord);
  unsigned long long dropped = 0;
  Clock::time_point next = Clock::now();
  while (Clock::now() < end) {
    for (WebClient& viewer : viewers) viewer.drain();
    if (Clock::now() >= next) {
      next = Clock::now() + kLookEvery;
      dropped = std::max<unsigned long long>(dropped, watcher.number_after("\"dropped_total\":"));
      // The server refuses this while the robot drives.
      watcher.call(kStart);
    }
    std::this_thread::sleep_for(5ms);
  }
  std::printf("{\"received\":%zu,\"lost_viewers\":%zu,\"dropped\":%llu}\n", received(viewers),
              closed(viewers), dropped);
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 3 && argc != 4) {
    std::fprintf(stderr, "usage: viewer_load PORT SECONDS [VIEWERS]\n");
    return 2;
  }
  const auto end =
      Clock::now() + std::chrono::milliseconds(static_cast<std::int64_t>(std::atof(argv[2]) * 1e3));
  if (argc == 3)
    load(argv[1], end);
  else
    look_on(argv[1], end, std::atoi(argv[3]));
  return 0;
}
