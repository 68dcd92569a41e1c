#pragma once
// A request handler with one viewer, without a socket.

#include <gtest/gtest.h>

#include <algorithm>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>
#include <utility>
#include <vector>

#include "../messages/fixtures.h"
#include "fake_controls.h"
#include "server/request_handler.h"

namespace tp100::server {

using Json = nlohmann::json;

constexpr HostNs kNow = 100 * kNsPerS;

class RequestHandlerTest : public ::testing::Test {
 protected:
  RequestHandlerTest() { broker_.add(viewer_); }

  /// Everything in the viewer's outbox; data messages are separate from answers.
  struct Received {
    std::vector<Json> texts;
    std::vector<std::string> binaries;
    std::vector<std::pair<std::uint32_t, Json>> data;  // subscription, message
  };
  static Received take(Viewer& viewer) {
    Received received;
    while (const auto next = viewer.outbox().pop()) {
      const WebSocketFrame& frame = *next;
      if (!frame.binary) {
        received.texts.push_back(Json::parse(*frame.body));
      } else if (frame.head_size == 0) {
        received.binaries.push_back(*frame.body);
      } else {
        received.data.emplace_back(frame.head[1], Json::parse(*frame.body));
      }
    }
    return received;
  }
  Received take() { return take(*viewer_); }

  Received send(const std::string& text) {
    handler_.handle(viewer_, parse_text(text), Permission::kCommand, kNow);
    return take();
  }
  Received set(const std::string& name, const std::string& value) {
    return send(R"({"op":"setParameters","parameters":[{"name":")" + name + R"(","value":)" +
                value + R"(}],"id":"s"})");
  }
  /// A request that sets the robot in motion gets the consent of a person who looks at the page
  /// now, unless it has one.
  Received call(Service service, const std::string& payload = "{}", HostNs now = kNow) {
    Json request = Json::parse(payload, nullptr, false);
    const auto row = std::ranges::find(handler_.services(), service, &ServiceRow::service);
    const bool moves = row != handler_.services().end() && row->rules.consents;
    if (moves && request.is_object() && !request.contains("stops")) {
      request["stops"] = controls_.stop_count();
      request["t_s"] = publisher_.clock().t_s(now);
    }
    const std::string text = moves && request.is_object() ? request.dump() : payload;
    const auto number = static_cast<std::uint32_t>(service);
    handler_.handle(viewer_, ServiceCall{number, 9, "json", text}, Permission::kCommand, now);
    return take();
  }
  /// Why the request is refused; empty: it is not.
  std::string refused(Service service, const std::string& payload = "{}") {
    const Received received = call(service, payload);
    if (received.texts.empty()) return {};
    EXPECT_EQ(received.texts[0]["op"], "serviceCallFailure");
    return received.texts[0]["message"];
  }
  /// The answer to a request that is accepted.
  Json answered(Service service, const std::string& payload = "{}") {
    const Received received = call(service, payload);
    EXPECT_EQ(received.binaries.size(), 1U) << payload;
    return received.binaries.empty() ? Json() : answer_of(received.binaries[0]);
  }
  void step(const StepRecord& record) {
    publisher_.take(record);
    handler_.tick(record.now_ns);
  }
  /// A step of a robot that may be started.
  static StepRecord ready(RunState state = RunState::kIdle) {
    StepRecord record = messages::example_record();
    record.now_ns = kNow;
    record.snapshot.run_state = state;
    record.snapshot.start_refusal = StartRefusal::kNone;
    return record;
  }
  static Json answer_of(const std::string& response) {
    return Json::parse(response.substr(response.find('{')));
  }

  FakeControls controls_;
  Broker broker_{messages::channel_texts()};
  Publisher publisher_{broker_,
                       messages::Messages(messages::example_subject(), messages::example_clock()),
                       controls_};
  Answer unanswered_;  ///< of a service of others, record_stop, that waits for its disk
  RequestHandler handler_{broker_,
                          publisher_,
                          controls_,
                          parameters(),
                          {{Service::kRecordStop, "record_stop", "{}", "{}",
                            [this](const Request&, const Answer& answer) -> Result<> {
                              unanswered_ = answer;
                              return Done{};
                            }}},
                          "session"};
  std::shared_ptr<Viewer> viewer_ = std::make_shared<Viewer>(
      3, [] {}, [this] { failed_ = true; });
  bool failed_ = false;
};

}  // namespace tp100::server
