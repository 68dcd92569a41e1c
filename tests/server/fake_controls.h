#pragma once
// Records the requests of viewers.

#include <atomic>
#include <future>
#include <mutex>
#include <new>
#include <string>
#include <vector>

#include "server/controls.h"

namespace tp100::server {

/// Parameters of each kind.
inline std::vector<messages::ParameterText> parameters() {
  using messages::ParameterText;
  const auto number = [](const char* name, double value, double low, double high) {
    return ParameterText{{.name = name, .value = value, .standard = value, .range = {low, high}}};
  };
  const auto words = [](const char* name, const char* value,
                        std::vector<std::string> choices = {}) {
    const auto type = choices.empty() ? ParameterText::Type::kText : ParameterText::Type::kChoice;
    return ParameterText{{.name = name,
                          .type = type,
                          .value = std::string(value),
                          .standard = std::string(value),
                          .choices = std::move(choices)}};
  };
  std::vector<ParameterText> all = {
      number("control.gain", 16.0, 0.0, 200.0),
      number("loop.rate_hz", 200.0, 50.0, 1000.0),
      words("server.listen", ""),
      words("course", ""),
      number("robot.model.wheelbase_m", 0.2, 0.1, 1.0),
      words("estimation.steering", "odometry", {"model", "odometry"})};
  all[0].live = all[5].live = all[5].only_at_standstill = true;
  all[0].may_save = all[1].may_save = all[3].may_save = true;
  return all;
}

class FakeControls : public Controls {
 public:
  Result<> move(OperatorRequest request, const Consent& given, HostNs) override {
    if (request == OperatorRequest::kStart) ++starts;
    if (request == OperatorRequest::kGoOn) ++go_ons;
    if (request == OperatorRequest::kResume) ++resumes;
    consents.push_back(given);
    return unless(move_refusal);
  }
  Result<> pause() override {
    ++pauses;
    return Done{};
  }
  std::uint64_t stop_count() override { return static_cast<std::uint64_t>(stops.load()); }
  Result<> hold() override {
    ++holds;
    if (held.valid()) held.wait();
    if (no_memory) throw std::bad_alloc();
    return Done{};
  }
  void stop() override { ++stops; }
  HostNs motors_off_ns() override { return motors_off; }
  Result<> set(const messages::ParameterText& parameter,
               const messages::ParameterValue& value) override {
    const std::lock_guard lock(mutex);
    sets.emplace_back(parameter.name, value);
    return Done{};
  }
  Result<std::string> drive_take(const std::string& driver, const Consent& given,
                                 HostNs now) override {
    consents.push_back(given);
    const std::optional<std::string> taken = wheel.take(driver, now);
    if (!taken) return Refusal{wheel.figures(now).by + " drives"};
    return *taken;
  }
  Result<> drive(const DriveRequest& request, HostNs now) override {
    std::string why = "this token does not hold the wheel; take it";
    const std::optional<VelocityInput> input = wheel.drive(request, now, why);
    if (!input) return Refusal{why};
    inputs.push_back(*input);
    return Done{};
  }
  Result<> drive_release(const std::string& token, HostNs) override {
    return unless(wheel.release(token) ? "" : "this token does not hold the wheel");
  }
  void drive_lost(const std::string& driver, HostNs) override {
    if (wheel.lose(driver)) ++drivers_lost;
  }
  messages::DriverFigures driver(HostNs now) override { return wheel.figures(now); }
  void choose(const SetupChoice& choice, Answer answer) override {
    choices.push_back(choice);
    answer(change_refusal, R"({"course":"3","robot":"worn","setup":"flat"})");
  }
  void place(const std::optional<Pose>& at, Answer answer) override {
    places.push_back(at);
    answer(change_refusal, R"({"x_m":0.0,"y_m":0.0,"yaw_rad":0.0})");
  }
  messages::LoopFigures loop() override { return {}; }
  messages::PortFigures port() override { return {"/dev/ttyACM0", RobotKind::kPhysical, "0.1.0"}; }
  messages::RecordingFigures recording() override { return record; }
  StartConsent start_consent() override { return consent; }
  /// Number of requests that were passed on.
  std::size_t requests() const {
    return static_cast<std::size_t>(starts + go_ons + holds + stops + pauses + resumes) +
           consents.size() + inputs.size() + sets.size() + choices.size() + places.size();
  }

  std::atomic<int> starts{0}, go_ons{0}, holds{0}, stops{0}, pauses{0}, resumes{0};
  std::vector<Consent> consents;
  std::string move_refusal, change_refusal;
  std::shared_future<void> held{};     ///< blocks hold() until it is ready
  std::atomic<bool> no_memory{false};  ///< hold() throws
  HostNs motors_off = 0;
  Wheel wheel;
  std::vector<VelocityInput> inputs;
  std::atomic<int> drivers_lost{0};
  std::mutex mutex;
  std::vector<std::pair<std::string, messages::ParameterValue>> sets;
  std::vector<SetupChoice> choices;
  std::vector<std::optional<Pose>> places;
  StartConsent consent = StartConsent::kEnter;
  messages::RecordingFigures record{};

 private:
  static Result<> unless(const std::string& refusal) {
    if (!refusal.empty()) return Refusal{refusal};
    return Done{};
  }
};

}  // namespace tp100::server
