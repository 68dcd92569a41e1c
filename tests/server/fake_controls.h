#pragma once
// Records the requests of viewers.

#include <atomic>
#include <mutex>
#include <string>
#include <vector>

#include "server/controls.h"

namespace tp100::server {

class FakeControls : public Controls {
 public:
  std::string start() override {
    ++starts;
    return {};
  }
  std::string go_on() override {
    ++go_ons;
    return {};
  }
  std::string hold() override {
    ++holds;
    return {};
  }
  void stop() override { ++stops; }
  std::string set(const messages::ParameterText& parameter,
                  const messages::ParameterValue& value) override {
    const std::lock_guard lock(mutex);
    sets.emplace_back(parameter.name, value);
    return set_refusal;
  }
  void record_start(const std::string& name, RecordAnswer answer) override {
    if (can_record) {
      record.active = true;
      record.run = name.empty() ? "20260102-030405-3" : name;
    }
    answer(can_record ? "" : "no directory", record);
  }
  /// Answers at once or, with `slow_disk`, when a test calls `unanswered`.
  void record_stop(RecordAnswer answer) override {
    record.active = false;
    if (!slow_disk) return answer("", record);
    const std::lock_guard lock(mutex);
    unanswered = std::move(answer);
  }
  messages::LoopFigures loop() override { return {}; }
  messages::PortFigures port() override { return {"/dev/ttyACM0", true, "0.1.0"}; }
  messages::RecordingFigures recording() override { return record; }
  StartConsent start_consent() override { return consent; }

  std::atomic<int> starts{0}, go_ons{0}, holds{0}, stops{0};
  std::mutex mutex;
  std::vector<std::pair<std::string, messages::ParameterValue>> sets;
  std::string set_refusal;
  bool can_record = false, slow_disk = false;
  RecordAnswer unanswered;
  StartConsent consent = StartConsent::kEnter;
  messages::RecordingFigures record{};
};

}  // namespace tp100::server
