#pragma once
// Passes viewers' requests to the real-time loop, and provides what only the loop and the ports
// know.

#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "config/configuration.h"
#include "core/command.h"
#include "live/live_cycle.h"
#include "live/live_recording.h"
#include "live/setup_changer.h"
#include "loop/fixed_rate_loop.h"
#include "messages/parameter_text.h"
#include "runs/run_archive.h"
#include "selftest/self_test.h"
#include "server/controls.h"

namespace tp100::live {

class LiveControls : public server::Controls {
 public:
  /// All must outlive the controls.
  LiveControls(LiveCycle& cycle, const loop::FixedRateLoop& loop, LiveRecording& recording,
               SetupChanger& setup, runs::RunArchive& runs, selftest::SelfTest& self_test,
               messages::EventQueue& events)
      : cycle_(cycle),
        loop_(loop),
        recording_(recording),
        setup_(setup),
        runs_(runs),
        self_test_(self_test),
        events_(events) {}

  /// Of everything that the controls were made of.
  std::vector<server::ServiceRow> services();

  // The server's thread, or another one whose clients drive:
  Result<> move(OperatorRequest request, const Consent& consent, HostNs now) override;
  Result<> hold() override;
  Result<> pause() override;
  std::uint64_t stop_count() override { return cycle_.consents().stops(); }
  void stop() override;
  Result<> set(const messages::ParameterText& parameter,
               const messages::ParameterValue& value) override;
  Result<std::string> drive_take(const std::string& driver, const Consent& consent,
                                 HostNs now) override;
  Result<> drive(const server::DriveRequest& request, HostNs now) override;
  Result<> drive_release(const std::string& token, HostNs now) override;
  void drive_lost(const std::string& driver, HostNs now) override;
  messages::DriverFigures driver(HostNs now) override;
  void choose(const server::SetupChoice& choice, server::Answer answer) override;
  void place(const std::optional<Pose>& at, server::Answer answer) override {
    setup_.place(at, std::move(answer));
  }
  HostNs motors_off_ns() override { return self_test_.wheels_up().motors_off_ns(); }
  messages::LoopFigures loop() override;
  messages::PortFigures port() override;
  messages::RecordingFigures recording() override;
  StartConsent start_consent() override;  // any thread
  StartPlaces start_places() override { return cycle_.start_places(); }

  // The main thread:
  /// Reports the session with the robot on the port in use, or the last one.
  void set_session(const SessionReport& report, const std::string& path, bool pseudo_terminal);
  /// A line about the search for the port.
  void note_port(const std::string& line);
  /// Sets the facts of the program; the session tells the kind of robot, and the cycle whether a
  /// run has begun.
  void set_start(const StartFacts& facts);
  /// Starts a run of the course if nobody has to consent, see start_consent(). False: somebody has
  /// to; if only because it is too late for the program's option, see option_consent(), an event
  /// says so.
  bool start_by_itself(bool came_later, HostNs program_start_ns, HostNs now);
  /// Takes those of the process, and returns them with those of the loop, which is started.
  std::vector<loop::Privilege> set_privileges(std::vector<loop::Privilege> privileges);
  /// The program is ending: refuses further starts.
  void end();

 private:
  Result<> may_move(const Consent& consent, HostNs now) const;
  Result<std::string> begin_wheels_up(const server::Request& request);
  Result<> mark(const server::Request& request, const server::Answer& answer);
  Result<> end_drive(HostNs now);
  bool driving(HostNs now);

  LiveCycle& cycle_;
  const loop::FixedRateLoop& loop_;
  LiveRecording& recording_;
  SetupChanger& setup_;
  runs::RunArchive& runs_;
  selftest::SelfTest& self_test_;
  messages::EventQueue& events_;
  std::mutex mutex_;
  messages::PortFigures port_{};
  StartFacts start_{};
  server::Lease lease_;
  std::vector<std::pair<std::string, bool>> privileges_;
  bool ending_ = false;
};

}  // namespace tp100::live
