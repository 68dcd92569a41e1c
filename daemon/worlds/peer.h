#pragma once
// The bridge's side of the world/1 protocol: sends hello until welcomed, then poses, and receives
// replies. Bytes and time are passed in; it opens no socket. Input is hostile. Allocates: not for
// the real-time thread.

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/fields.h"
#include "core/sample.h"
#include "core/step_record.h"
#include "worlds/message.h"

namespace tp100::worlds {

struct PeerSettings {
  Hello hello{};  ///< its session is the first session number
  /// Names of the course's surfaces, and the slip that each adds to both slip ratios.
  std::vector<std::pair<std::string, double>> surfaces;
};

/// Counts of datagrams by outcome, since the start.
struct PeerCounters {
  std::uint64_t hellos = 0;     ///< sent
  std::uint64_t poses = 0;      ///< sent
  std::uint64_t answered = 0;   ///< poses acknowledged for the first time by an accepted message
  std::uint64_t received = 0;   ///< from the world's machine; counted in one of the next rows, too
  std::uint64_t accepted = 0;   ///< welcomes and world messages that were used
  std::uint64_t malformed = 0;  ///< too long, invalid JSON, a value out of range
  std::uint64_t wrong_version = 0;
  std::uint64_t foreign = 0;          ///< another session, another port, or not welcomed yet
  std::uint64_t reordered = 0;        ///< `seq` or `ack` not above the last one
  std::uint64_t back_in_time = 0;     ///< `timestamp` below the last one
  std::uint64_t unknown_ack = 0;      ///< acknowledges a pose that was not sent, or long ago
  std::uint64_t missing = 0;          ///< messages of the world that never arrived, by `seq`
  std::uint64_t unknown_surface = 0;  ///< in accepted messages; the floor's slip is used
  std::uint64_t dropped = 0;          ///< accepted, but the step's queue was full
  std::uint64_t sessions = 0;         ///< welcomes
  std::uint64_t losses = 0;           ///< sessions that ended by timeout
  double round_trip_ms = 0.0;         ///< of the last reply
  double mean_round_trip_ms = 0.0;    ///< smoothed over about a hundred replies
  double max_round_trip_ms = 0.0;
};
TP100_FIELDS(PeerCounters, hellos, poses, answered, received, accepted, malformed, wrong_version,
             foreign, reordered, back_in_time, unknown_ack, missing, unknown_surface, dropped,
             sessions, losses, round_trip_ms, mean_round_trip_ms, max_round_trip_ms)

class Peer {
 public:
  explicit Peer(PeerSettings settings);

  /// Takes a step; `now` is the time of sending. Returns the datagram to send, if one is due: hello
  /// every quarter second until welcomed, then poses at their rate. After a timeout, a world is
  /// sent hello again.
  std::optional<std::string> step(const StepRecord& record, HostNs now);

  /// Takes a datagram from the world's machine, sent from its `port`.
  std::optional<WorldSample> receive(std::string_view datagram, std::uint16_t port, HostNs now);

  /// Reply to the sender of the last datagram: an error, sent once.
  std::optional<std::string> take_reply() { return std::exchange(reply_, std::nullopt); }
  /// Something to log since the last take, or empty.
  std::string take_note() { return std::exchange(note_, {}); }

  bool welcomed() const { return welcomed_; }
  const std::string& name() const { return name_; }
  /// Sequence of the last pose that was sent; 0: none.
  std::uint64_t sent() const { return sequence_; }
  /// Highest pose acknowledged in this session.
  std::uint64_t answered() const { return answers_; }
  void count_dropped() { ++counters_.dropped; }
  const PeerCounters& counters() const { return counters_; }

 private:
  struct Sent {
    std::uint64_t sequence = 0;
    HostNs step_ns = 0;
    HostNs sent_ns = 0;
  };
  /// Sums over the steps since the last pose.
  struct Passed {
    double left_mps = 0.0, right_mps = 0.0;
    int steps = 0;
  };

  std::string pose(const StepRecord& record, HostNs now);
  void welcome(const WorldMessage& message, std::uint16_t port, HostNs now);
  std::optional<WorldSample> world(const WorldMessage& message, HostNs now);
  WorldSample sample_of(const WorldMessage& message, HostNs answered_ns);
  const Sent* find(std::uint64_t sequence) const;
  void take_round_trip(HostNs round_trip_ns);
  void refuse(const std::string& text);

  PeerSettings settings_;
  PeerCounters counters_;
  std::array<Sent, 512> poses_{};
  Passed passed_;
  std::uint64_t sequence_ = 0;
  std::uint32_t session_;
  std::uint32_t run_ = 0;
  RunState run_state_ = RunState::kIdle;
  HostNs next_ns_ = 0;
  bool began_ = false;

  bool welcomed_ = false;
  std::uint16_t port_ = 0;
  std::string name_;
  HostNs received_ns_ = 0;
  std::uint64_t world_sequence_ = 0;
  std::uint64_t answers_ = 0;
  std::optional<double> stamp_s_;
  std::optional<std::string> reply_;
  std::string note_;
  bool refused_ = false;
};

}  // namespace tp100::worlds
