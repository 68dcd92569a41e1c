// viewer_load PORT SECONDS VIEWERS: connects viewers that subscribe as the page does; a further
// client starts the robot again whenever its run is over, and records everything if there is a
// folder for recordings. Prints one JSON object with what the viewers received and lost.

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <thread>
#include <vector>

#include "../server/web_client.h"
#include "server/service.h"

int main(int argc, char** argv) {
  using tp100::messages::Channel;
  using tp100::server::Service;
  using tp100::server::WebClient;
  using Clock = std::chrono::steady_clock;
  using namespace std::chrono_literals;
  if (argc != 4) {
    std::fprintf(stderr, "usage: viewer_load PORT SECONDS VIEWERS\n");
    return 2;
  }
  const auto end =
      Clock::now() + std::chrono::milliseconds(static_cast<std::int64_t>(std::atof(argv[2]) * 1e3));
  std::vector<WebClient> viewers;
  for (int i = 0; i < std::atoi(argv[3]); ++i) {
    viewers.emplace_back(argv[1]);
    for (const Channel channel : {Channel::kEstimate, Channel::kSlip, Channel::kLink,
                                  Channel::kLoop, Channel::kState, Channel::kTransforms})
      viewers.back().subscribe(channel);
  }
  WebClient watcher(argv[1]);
  watcher.subscribe(Channel::kClient);
  watcher.call(Service::kRecordStop);
  watcher.call(Service::kRecordStart);
  unsigned long long dropped = 0;
  for (Clock::time_point next = Clock::now(); Clock::now() < end;
       std::this_thread::sleep_for(5ms)) {
    for (WebClient& viewer : viewers) viewer.drain();
    if (Clock::now() < next) continue;
    next += 500ms;
    dropped = std::max<unsigned long long>(dropped, watcher.number_after("\"dropped_total\":"));
    // The server refuses this while the robot drives.
    watcher.call(Service::kStart);
  }
  std::size_t received = 0, lost = 0;
  for (WebClient& viewer : viewers) {
    received += viewer.received();
    lost += viewer.closed() ? 1U : 0U;
  }
  std::printf("{\"received\":%zu,\"lost_viewers\":%zu,\"dropped\":%llu}\n", received, lost,
              dropped);
  return 0;
}
