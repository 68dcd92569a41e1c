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
  const ParameterText choice{{.name = "estimation.steering",
                              .type = ParameterText::Type::kChoice,
                              .value = std::string("odometry"),
                              .standard = std::string("odometry"),
                              .choices = {"model", "odometry"}}};
  std::vector<ParameterText> all = {number("control.gain", 16.0, 0.0, 200.0),
                                    number("loop.rate_hz", 200.0, 50.0, 1000.0), choice};
  all[0].live = all[2].live = all[2].only_at_standstill = true;
  return all;
}

class FakeControls : public Controls {
 public:
  Result<> move(OperatorRequest request, const Consent& given, HostNs) override {
    if (request == OperatorRequest::kStart) ++starts;
    if (request == OperatorRequest::kStartPlaced) ++placed_starts;
    if (request == OperatorRequest::kContinue) ++continues;
    consents.push_back(given);
    return unless(move_refusal);
  }
  Result<> pause() override { return Done{}; }
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
    const std::optional<std::string> taken = lease.take(driver, now);
    if (!taken) return Refusal{lease.figures(now).by + " drives"};
    return *taken;
  }
  Result<> drive(const DriveRequest& request, HostNs now) override {
    std::string why = "this token does not hold the lease; take it";
    const std::optional<VelocityInput> input = lease.drive(request, now, why);
    if (!input) return Refusal{why};
    inputs.push_back(*input);
    return Done{};
  }
  Result<> drive_release(const std::string& token, HostNs) override {
    return unless(lease.release(token) ? "" : "this token does not hold the lease");
  }
  void drive_lost(const std::string& driver, HostNs) override {
    if (lease.lose(driver)) ++drivers_lost;
  }
  messages::DriverFigures driver(HostNs now) override { return lease.figures(now); }
  void choose(const SetupChoice& choice, Answer answer) override {
    choices.push_back(choice);
    answer("", "{}");
  }
  void place(const std::optional<Pose>&, Answer answer) override { answer("", "{}"); }
  messages::LoopFigures loop() override { return {}; }
  messages::PortFigures port() override { return {"/dev/ttyACM0", RobotKind::kPhysical, "0.1.0"}; }
  messages::RecordingFigures recording() override { return record; }
  StartConsent start_consent() override { return StartConsent::kEnter; }
  StartPlaces start_places() override { return places; }

  std::atomic<int> starts{0}, placed_starts{0}, continues{0}, holds{0}, stops{0};
  std::vector<Consent> consents;
  std::string move_refusal;
  StartPlaces places{};
  std::shared_future<void> held{};     ///< blocks hold() until it is ready
  std::atomic<bool> no_memory{false};  ///< hold() throws
  HostNs motors_off = 0;
  Lease lease;
  std::vector<VelocityInput> inputs;
  std::atomic<int> drivers_lost{0};
  std::mutex mutex;
  std::vector<std::pair<std::string, messages::ParameterValue>> sets;
  std::vector<SetupChoice> choices;
  messages::RecordingFigures record{};

 private:
  static Result<> unless(const std::string& refusal) {
    if (!refusal.empty()) return Refusal{refusal};
    return Done{};
  }
};

}  // namespace tp100::server
