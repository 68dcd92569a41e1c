#pragma once
// The session with one robot: bytes and time in, samples and bytes out. A state machine without
// clock or port; no allocation after construction; safe in the real-time thread.

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <utility>

#include "core/command.h"
#include "core/link_state.h"
#include "core/sample.h"
#include "link/clock_sync.h"
#include "link/frame_reader.h"
#include "link/output_queue.h"
#include "link/request_sender.h"
#include "link/sample_intake.h"
#include "link/session_event.h"
#include "wire/messages.h"

namespace tp100::link {

/// Settings of a session.
struct SessionSettings {
  wire::Parameters parameters{};       ///< nonce and token are filled in by the session
  std::uint32_t baud = wire::kBaud;    ///< for wire times; 0: bytes take no time
  HostNs timeout_ns = 500 * kNsPerMs;  ///< no good frame for this long: link lost
  /// No frame, or no answer, for this long after the port was opened: warn, and continue.
  HostNs first_frame_timeout_ns = 5 * kNsPerS;
  HostNs clock_answer_ns = ClockSync::kAnswerNs;  ///< later answers to clock requests are not used
};

/// Reads a hello of any version: of another one only protocol, firmware and schema, with which
/// every hello begins. Nothing: its size is wrong.
std::optional<wire::Hello> read_hello(const std::uint8_t* payload, std::size_t size);
/// Whether protocol and schema are this program's.
bool is_ours(const wire::Hello& hello);

class Session {
 public:
  static constexpr std::size_t kMaxSamples =
      SampleIntake::kCapacity;  ///< kept between two takes; older ones count as lost

  explicit Session(const SessionSettings& settings);
  Session(const Session&) = delete;
  Session& operator=(const Session&) = delete;

  /// A port was opened. Ends the session and listens only; the last boot stays known.
  void open(HostNs now);
  /// The port is gone.
  void close(HostNs now);
  /// Sets other parameters for the robot; their nonce and token are ignored. They are sent in a new
  /// session, which begins now if there is a robot. Never call it while its motors may run.
  void use(const wire::Parameters& parameters, HostNs now);

  /// Takes received bytes; `now` is the time at which the last of them was read.
  void receive(std::span<const std::uint8_t> bytes, HostNs now);
  /// Handles time-outs, retransmissions and sync requests. Call once per step.
  void poll(HostNs now);

  /// Queues one command frame. Ignored unless the state is kSyncing or kReady.
  void send(const Command& command, HostNs now);
  /// Starts a one-shot request, repeated until acknowledged or 200 ms have passed. STOP waits for
  /// the next session if there is none.
  void request(RobotRequest request, HostNs now);

  /// Samples since the last take, oldest first; valid until the next receive().
  std::span<const Sample> take_samples() { return intake_.take(); }
  /// Events since the last take, oldest first; valid until the next call that takes time or bytes.
  std::span<const SessionEvent> take_events() { return events_.take(); }
  /// Bytes to write. After writing `n` of them call written(n).
  std::span<const std::uint8_t> output() const { return output_.bytes(); }
  void written(std::size_t n) { output_.written(n); }
  /// Drops bytes that the port did not take in time; counts them.
  void drop_output() { output_.drop(); }

  SessionState state() const { return state_; }
  const LinkCounters& counters() const { return counters_; }
  const ClockState& clock() const { return clock_.state(); }
  const wire::Hello& hello() const { return hello_; }
  /// +1 each time the state becomes kReady.
  std::uint32_t session_number() const { return session_number_; }
  /// True once after a new boot nonce.
  bool take_rebooted() { return std::exchange(rebooted_, false); }
  /// Outcome of the last arm or disarm; reported once.
  RequestAnswer take_answer() { return requests_.take_answer(); }
  /// True if there are samples to take.
  bool has_samples() const { return !intake_.empty(); }
  /// True while a clock-sync reply may arrive at any moment: bytes should be read as they arrive.
  bool expects_reply(HostNs now) const { return in_session() && clock_.expects_reply(now); }
  /// True while a request waits for its acknowledgement.
  bool request_pending() const { return requests_.pending(); }

 private:
  void enter(SessionState state, HostNs now);
  void on_frame(HostNs now);
  void on_hello(HostNs now);
  void on_other_hello(const wire::Hello& hello, HostNs now);
  void on_bad_hello(const wire::Hello& hello, HostNs now);
  void refuse(const wire::Hello& hello, HostNs now);
  void on_sample(const wire::Sample& sample, HostNs now);
  void on_acknowledge(const wire::Acknowledge& acknowledge, HostNs now);
  void on_parameters_answer(const wire::Acknowledge& acknowledge, HostNs now);
  void on_sync_reply(const wire::SyncReply& reply, HostNs now);
  void on_fault(const wire::FaultReport& report, HostNs now);
  void on_log(const wire::Log& log, HostNs now);
  template <class Message>
  void read(void (Session::*take)(const Message&, HostNs), HostNs now);

  void ask_hello(HostNs now);
  void begin_session(HostNs now);
  void end_session(HostNs now);
  void back_off(HostNs now);
  void poll_timeout(HostNs now);
  void poll_unanswered(HostNs now);
  void poll_handshake(HostNs now);
  bool connected() const;
  bool in_handshake() const;
  bool in_session() const;

  SessionSettings settings_;
  LinkCounters counters_{};
  FrameReader reader_{counters_};
  OutputQueue<kMaxOut> output_{counters_};
  SampleIntake intake_;
  RobotClock clock_;
  SessionEvents events_;
  Tokens tokens_;
  RequestSender requests_{tokens_, output_, events_};

  SessionState state_ = SessionState::kClosed;
  wire::Hello hello_{};
  bool known_boot_ = false;
  bool new_boot_ = true;
  bool rebooted_ = false;
  std::uint32_t session_number_ = 0;
  std::uint16_t command_sequence_ = 0;
  bool sequence_known_ = false;

  HostNs last_good_ns_ = 0;  // in a session: the last accepted sample
  HostNs handshake_ns_ = 0;  // when the handshake began, or when it was last reported to hang
  HostNs last_sent_ns_ = 0;
  HostNs next_hello_ns_ = 0;
  HostNs next_parameters_ns_ = 0;
  // If no session with a robot lasts, hellos are requested at growing intervals.
  HostNs retry_ns_ = 0;
  HostNs not_before_ns_ = 0;
  std::uint32_t taken_ = 0;  // samples of this session
};

}  // namespace tp100::link
