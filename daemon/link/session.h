#pragma once
// The session with one robot: bytes and time in, samples and bytes out. A state machine without
// clock or port; no allocation after construction; safe in the real-time thread.

#include <array>
#include <cstdint>
#include <optional>
#include <span>

#include "core/command.h"
#include "core/link_state.h"
#include "core/sample.h"
#include "link/clock_sync.h"
#include "link/frame_reader.h"
#include "link/one_shot_request.h"
#include "link/output_queue.h"
#include "link/sample_intake.h"
#include "wire/messages.h"

namespace tp100::link {

/// Settings of a session.
struct SessionSettings {
  wire::Parameters parameters{};       ///< nonce and token are filled in by the session
  std::uint32_t baud = wire::kBaud;    ///< for wire times; 0: bytes take no time
  HostNs timeout_ns = 500 * kNsPerMs;  ///< no good frame for this long: link lost
  /// Nothing heard, or not answered, for this long after the port was opened: warn, and go on.
  HostNs first_frame_timeout_ns = 5 * kNsPerS;
};

/// Something to tell the operator; the session never logs itself.
struct SessionEvent {
  enum class Kind : std::uint8_t {
    kState,            ///< a -> b: SessionState values
    kHello,            ///< hello received: see session.hello()
    kVersionMismatch,  ///< hello() shows the robot's versions
    kBadHello,         ///< a: its boot nonce, b: its state; no board of ours sends that
    kUnknownBoard,     ///< a: the board that hello named; the session goes on
    kReboot,           ///< new boot nonce during a session
    kRobotFault,       ///< a: Fault bit, b: detail
    kRobotLog,         ///< text
    kAcknowledged,     ///< a: request wire::Type, b: wire::Result, detail
    kNotAcknowledged,  ///< a: request wire::Type
    kTimeout,          ///< no good frame within the time-out; a: SessionState in which it passed
    kUnanswered,       ///< frames come, but not the answer that a, a SessionState, waits for
  };
  Kind kind = Kind::kState;
  HostNs at_ns = 0;
  std::int32_t a = 0;
  std::int32_t b = 0;
  std::uint32_t detail = 0;
  std::array<char, wire::Log::kTextSize + 1> text{};
};

class Session {
 public:
  static constexpr std::size_t kMaxSamples =
      SampleIntake::kCapacity;  ///< kept between two takes; older ones count as lost
  static constexpr std::size_t kMaxEvents = 32;
  static constexpr std::size_t kMaxOut = 1024;  ///< bytes waiting for the port

  explicit Session(const SessionSettings& settings);
  Session(const Session&) = delete;
  Session& operator=(const Session&) = delete;

  /// A port was opened: forget the peer, stay silent, listen.
  void open(HostNs now);
  /// The port is gone.
  void close(HostNs now);

  /// Bytes that arrived; `now` is the time at which the last of them was read.
  void receive(std::span<const std::uint8_t> bytes, HostNs now);
  /// Time passes: time-outs, retransmissions, sync requests. Call once a step.
  void poll(HostNs now);

  /// Queues one command frame. Ignored unless the state is kSyncing or kReady.
  void send(const Command& command, HostNs now);
  /// Starts a one-shot request, repeated until acknowledged or 200 ms have passed. STOP waits for
  /// the next session if there is none.
  void request(RobotRequest request, HostNs now);

  /// Samples since the last take, oldest first; valid until the next receive().
  std::span<const Sample> take_samples();
  std::span<const SessionEvent> take_events();
  /// Bytes to write. After writing `n` of them call written(n).
  std::span<const std::uint8_t> output() const;
  void written(std::size_t n);
  /// Drops bytes that the port did not take in time; counts them.
  void drop_output();

  SessionState state() const;
  const LinkCounters& counters() const;
  const ClockState& clock() const;
  const wire::Hello& hello() const;
  std::uint32_t session_number() const;  ///< +1 each time the state becomes kReady
  /// True once after a new boot nonce.
  bool take_rebooted();
  /// What became of the last arm or disarm; said once.
  RequestAnswer take_answer();
  /// True if there are samples to take.
  bool has_samples() const { return !intake_.empty(); }
  /// True while a clock-sync reply may come at any moment: bytes should be read as they arrive.
  bool expects_reply(HostNs now) const { return in_session() && sync_.expects_reply(now); }
  /// True while a request waits for its acknowledgement.
  bool request_pending() const { return motion_.pending() || stop_.pending(); }

 private:
  void enter(SessionState state, HostNs now);
  void on_frame(HostNs now);
  void on_hello(HostNs now);
  void on_other_hello(HostNs now);
  void on_bad_hello(const wire::Hello& hello, HostNs now);
  void on_sample(const wire::Sample& sample, HostNs now);
  void on_acknowledge(const wire::Acknowledge& acknowledge, HostNs now);
  void on_parameters_answer(const wire::Acknowledge& acknowledge, HostNs now);
  void on_sync_reply(const wire::SyncReply& reply, HostNs now);
  void count_robots_own(const wire::SyncReply& reply);
  void on_fault(const wire::FaultReport& report, HostNs now);
  void on_log(const wire::Log& log, HostNs now);
  template <class Message>
  bool read(Message& message);

  void ask_hello(HostNs now);
  void begin_session(HostNs now);
  void end_session(HostNs now);
  void back_off(HostNs now);
  void fail_arm(HostNs now);
  void poll_timeout(HostNs now);
  void poll_unanswered(HostNs now);
  void poll_requests(HostNs now);
  void poll_handshake(HostNs now);
  void poll_sync(HostNs now);
  bool connected() const;
  bool in_handshake() const;
  bool in_session() const;
  std::uint32_t next_token(HostNs now);
  HostNs wire_ns(std::size_t bytes) const;
  void note(SessionEvent::Kind kind, HostNs now, std::int32_t a = 0, std::int32_t b = 0,
            std::uint32_t detail = 0);
  SessionEvent* new_event(SessionEvent::Kind kind, HostNs now, std::size_t room);

  SessionSettings settings_;
  LinkCounters counters_{};
  FrameReader reader_{counters_};
  OutputQueue<kMaxOut> output_{counters_};
  SampleIntake intake_;
  ClockSync sync_;
  DeviceClock device_clock_;
  ClockState clock_{};
  OneShotRequest motion_;  // arm or disarm
  wire::Type motion_type_ = wire::Type::kDisarm;
  wire::Arm arm_{};
  std::uint32_t overdue_arm_token_ = 0;
  OneShotRequest stop_;

  SessionState state_ = SessionState::kClosed;
  wire::Hello hello_{};
  bool known_boot_ = false;
  bool new_boot_ = true;
  bool rebooted_ = false;
  RequestAnswer answer_ = RequestAnswer::kNone;
  std::uint32_t session_number_ = 0;
  std::uint32_t token_ = 0;
  std::uint16_t command_sequence_ = 0;
  std::optional<wire::SyncReply> last_reply_{};  // of this session; for the robot's own counts
  bool sequence_known_ = false;

  HostNs last_good_ns_ = 0;  // in a session: the last sample that was taken
  HostNs handshake_ns_ = 0;  // its beginning, or when it was last said that it hangs
  HostNs last_sent_ns_ = 0;
  HostNs next_hello_ns_ = 0;
  HostNs next_parameters_ns_ = 0;
  // A robot with which no session lasts is asked again later and later.
  HostNs retry_ns_ = 0;
  HostNs not_before_ns_ = 0;
  std::uint32_t taken_ = 0;  // samples of this session

  std::array<SessionEvent, kMaxEvents> events_{};
  std::size_t event_count_ = 0;
};

}  // namespace tp100::link
