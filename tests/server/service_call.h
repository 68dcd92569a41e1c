#pragma once
// A viewer's call of a service with a request, and the daemon's answer to it.

#include <chrono>
#include <stdexcept>
#include <string>
#include <thread>

#include "web_client.h"

namespace tp100::server {

/// The response to the request, which follows kResponseHead bytes, or the text of its failure.
inline constexpr std::size_t kResponseHead = 17;
inline std::string ask(WebClient& viewer, Service service, const std::string& request = "{}") {
  static char call = 0;
  const char number = ++call, code = static_cast<char>(service);
  viewer.call(service, request, number);
  // Both repeat service and call; other calls of this viewer may be answered later than this one.
  const std::string response = {'\x03', code, 0, 0, 0, number, 0, 0, 0};
  const std::string failure = "\"serviceId\":" + std::to_string(int{code}) +
                              ",\"callId\":" + std::to_string(static_cast<unsigned char>(number)) +
                              ",";
  for (;;) {
    viewer.drain();
    for (const std::string& message : viewer.take())
      if (message.starts_with(response) || message.find(failure) != std::string::npos)
        return message;
    if (viewer.closed()) throw std::runtime_error("the viewer was disconnected");
    std::this_thread::sleep_for(std::chrono::milliseconds(2));
  }
}

}  // namespace tp100::server
