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
  std::string move(OperatorRequest request, const Consent& given, HostNs) override {
    if (request == OperatorRequest::kStart) ++starts;
    if (request == OperatorRequest::kGoOn) ++go_ons;
    if (request == OperatorRequest::kResume) ++resumes;
    consents.push_back(given);
    return move_refusal;
  }
  std::string pause() override {
    ++pauses;
    return {};
  }
  std::uint64_t stop_count() override { return static_cast<std::uint64_t>(stops.load()); }
  std::string hold() override {
    ++holds;
    if (held.valid()) held.wait();
    if (no_memory) throw std::bad_alloc();
    return {};
  }
  void stop() override { ++stops; }
  HostNs motors_off_ns() override { return motors_off; }
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
  std::string drive_take(const Driver& driver, const Consent& given, HostNs now,
                         std::string& token) override {
    consents.push_back(given);
    const std::optional<std::string> taken = wheel.take(driver, now);
    if (!taken) return wheel.figures(now).by + " drives";
    token = *taken;
    return {};
  }
  std::string drive(const DriveRequest& request, HostNs now) override {
    std::string why = "this token does not hold the wheel; take it";
    const std::optional<VelocityInput> input = wheel.drive(request, now, why);
    if (!input) return why;
    inputs.push_back(*input);
    return {};
  }
  std::string drive_release(const std::string& token, HostNs) override {
    return wheel.release(token) ? "" : "this token does not hold the wheel";
  }
  void drive_lost(const std::string& id, HostNs) override {
    if (wheel.lose(id)) ++drivers_lost;
  }
  messages::DriverFigures driver(HostNs now) override { return wheel.figures(now); }
  /// Answers at once; with `slow_disk`, when a test calls `unanswered`.
  void record_stop(RecordAnswer answer) override {
    record.active = false;
    if (!slow_disk) return answer("", record);
    const std::lock_guard lock(mutex);
    unanswered = std::move(answer);
  }
  void choose(const SetupChoice& choice, Answer answer) override {
    choices.push_back(choice);
    answer(change_refusal, R"({"course":"3","robot":"worn","setup":"flat"})");
  }
  void place(const std::optional<Pose>& at, Answer answer) override {
    places.push_back(at);
    answer(change_refusal, R"({"x_m":0.0,"y_m":0.0,"yaw_rad":0.0})");
  }
  void save_file(const SetupFile& file, Answer answer) override {
    saved.push_back(file);
    answer(change_refusal, R"({"name":"mine"})");
  }
  void check_file(const SetupFile& file, Answer answer) override {
    checked.push_back(file);
    answer(change_refusal, R"({"error":"","why_not":""})");
  }
  void save_parameters(const ParameterSave& asked, Answer answer) override {
    parameters_saved.push_back(asked);
    answer(change_refusal, R"({"file":"tp100.toml","written":true,"differences":[]})");
  }
  void restore_parameters(bool check, Answer answer) override {
    restored.push_back(check);
    answer(change_refusal, R"({"file":"tp100.toml","written":true,"differences":[]})");
  }
  void delete_file(const SetupFile& file, Answer answer) override {
    deleted.push_back(file);
    answer(change_refusal, R"({"name":"mine"})");
  }
  void manage_run(const RunRequest& request, Answer answer) override {
    managed.push_back(request);
    answer(change_refusal, R"({"run":"a"})");
  }
  void examine(DoctorPart part, Answer answer) override {
    examined.push_back(part);
    answer(change_refusal, R"({"port":"/dev/ttyACM0","findings":[]})");
  }
  std::string wheels_up_begin(const Driver& viewer, const Consent& given, HostNs,
                              std::string& token) override {
    consents.push_back(given);
    checkers.push_back(viewer.id);
    token = "free";
    return change_refusal;
  }
  std::string wheels_up_watch(const WheelsUpWatch& watch, HostNs, std::string& json) override {
    watched.push_back(watch);
    json = R"({"step":"the left track runs"})";
    return change_refusal;
  }
  messages::LoopFigures loop() override { return {}; }
  messages::PortFigures port() override { return {"/dev/ttyACM0", RobotKind::kPhysical, "0.1.0"}; }
  messages::RecordingFigures recording() override { return record; }
  StartConsent start_consent() override { return consent; }
  /// Number of requests that were passed on, but for those of recordings and of the wheel.
  std::size_t requests() const {
    return static_cast<std::size_t>(starts + go_ons + holds + stops + pauses + resumes) +
           consents.size() + inputs.size() + sets.size() + choices.size() + places.size() +
           saved.size() + deleted.size() + checked.size() + parameters_saved.size() +
           restored.size() + managed.size() + examined.size() + watched.size();
  }

  std::atomic<int> starts{0}, go_ons{0}, holds{0}, stops{0}, pauses{0}, resumes{0};
  std::vector<Consent> consents;
  std::string move_refusal;
  std::shared_future<void> held{};     ///< blocks hold() until it is ready
  std::atomic<bool> no_memory{false};  ///< hold() throws
  HostNs motors_off = 0;
  Wheel wheel;
  std::vector<VelocityInput> inputs;
  std::atomic<int> drivers_lost{0};
  std::mutex mutex;
  std::vector<std::pair<std::string, messages::ParameterValue>> sets;
  std::string set_refusal;
  std::vector<SetupChoice> choices;
  std::vector<std::optional<Pose>> places;
  std::vector<SetupFile> saved, deleted, checked;
  std::vector<ParameterSave> parameters_saved;
  std::vector<bool> restored;
  std::vector<RunRequest> managed;
  std::vector<DoctorPart> examined;
  std::vector<std::string> checkers;
  std::vector<WheelsUpWatch> watched;
  std::string change_refusal;
  bool can_record = false, slow_disk = false;
  RecordAnswer unanswered;
  StartConsent consent = StartConsent::kEnter;
  messages::RecordingFigures record{};
};

}  // namespace tp100::server
