// Fuzzes the input from viewers: requests for files, and messages of the Foxglove protocol after a
// handshake.

#include <cmath>
#include <memory>

#include "../messages/fixtures.h"
#include "../server/fake_controls.h"
#include "byte_source.h"
#include "server/access.h"
#include "server/http_content.h"
#include "server/request_handler.h"

namespace tp100 {
namespace {

using fuzz::require;
using namespace messages;
using namespace server;

void require_set(const std::string& name, const ParameterValue& value) {
  if (name == "control.gain") {
    const double* number = std::get_if<double>(&value);
    require(number != nullptr && *number >= 0.0 && *number <= 200.0, "a number in its range");
  } else {
    const std::string* choice = std::get_if<std::string>(&value);
    require(name == "estimation.steering" && choice != nullptr &&
                (*choice == "model" || *choice == "odometry"),
            "one of the choices, of what may change");
  }
}

// One input is one conversation. Each message begins with a length of two bytes, whose highest bit
// marks a binary message.
void converse(fuzz::ByteSource source, Permission permission) {
  // These objects are expensive and the same for every conversation.
  static const std::vector<ChannelText> texts = channel_texts();
  static const Messages messages(example_subject(), example_clock());
  FakeControls controls;
  Broker broker(texts);
  Publisher publisher(broker, messages, controls);
  RequestHandler handler(broker, publisher, controls, parameters(), {}, "session");
  const auto viewer = std::make_shared<Viewer>(
      3, [] {}, [] {});
  broker.add(viewer);
  StepRecord record = example_record();
  record.snapshot.run_state = RunState::kIdle;
  publisher.take(record);
  while (!source.empty()) {
    const unsigned head = source.u8();
    const auto bytes = source.bytes((head & 0x7FU) << 8U | source.u8());
    const std::string_view text(reinterpret_cast<const char*>(bytes.data()), bytes.size());
    handler.handle(viewer, head & 0x80U ? parse_binary(bytes) : parse_text(text), permission,
                   record.now_ns);
    record.now_ns += 10 * kNsPerMs;
    publisher.take(record);
    handler.tick(record.now_ns);
    while (viewer->outbox().pop()) {
    }
  }
  for (const auto& [name, value] : controls.sets) require_set(name, value);
  if (permission == Permission::kStopOnly)
    require(controls.starts == 0 && controls.holds == 0 && controls.sets.empty(),
            "who may only stop does nothing else");
  broker.remove(viewer);
}

void request(std::string_view text) {
  HttpSources sources;
  sources.page = [](std::string_view) { return nullptr; };
  sources.runs_folder = "/nowhere";
  sources.runs = [] { return std::string("{}"); };
  sources.health = [] { return std::string("{}"); };
  const std::size_t end = text.find('\n');
  const std::string target(text.substr(0, end));
  const std::string more(end == text.npos ? std::string_view() : text.substr(end + 1));
  const HttpAnswer answer = http_answer({"GET", target, more, {}}, sources);
  require(answer.status >= 200 && answer.status < 600, "an answer of HTTP");
  choose_sub_protocol(text);
  parse_request(text);
}

}  // namespace
}  // namespace tp100

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  for (const auto permission :
       {tp100::server::Permission::kCommand, tp100::server::Permission::kStopOnly})
    tp100::converse({data, size}, permission);
  tp100::request({reinterpret_cast<const char*>(data), size});
  return 0;
}
