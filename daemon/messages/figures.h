#pragma once
// Content of the slow channels as plain data.

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "core/board.h"
#include "core/enum_names.h"
#include "core/estimates.h"
#include "core/faults.h"
#include "core/fields.h"
#include "core/histogram.h"
#include "core/link_state.h"
#include "core/run_state.h"
#include "core/sample.h"
#include "core/time.h"

namespace tp100::messages {

/// A distribution of durations [us].
struct Durations {
  std::uint64_t count = 0;
  double mean_us = 0.0, p50_us = 0.0, p99_us = 0.0, p999_us = 0.0, max_us = 0.0;

  /// Calls visit(name, value) for each field, by its JSON name.
  template <class Visit>
  void each(Visit&& visit) const {
    visit("count", count);
    visit("mean", mean_us);
    visit("p50", p50_us);
    visit("p99", p99_us);
    visit("p999", p999_us);
    visit("max", max_us);
  }
};

/// Serializes it as JSON (nlohmann).
template <class Json>
void to_json(Json& json, const Durations& durations) {
  durations.each([&](const char* name, auto value) { json[name] = value; });
}

/// Adds a duration, unless it is negative, not a number or longer than 30 years.
void add_us(Histogram& histogram, double us);
/// The durations of a histogram of nanoseconds.
Durations durations_of(const Histogram& histogram);

/// Upper edges of the lateness histogram [us]; an additional last bin counts everything above.
inline constexpr std::array<int, 13> kLatenessEdgesUs{1,   2,   5,    10,   20,   50,   100,
                                                      200, 500, 1000, 2000, 5000, 10000};
using LatenessCounts = std::array<std::uint64_t, kLatenessEdgesUs.size() + 1>;
/// A histogram of nanoseconds in these bins; each edge is exact to within the width of a bucket.
LatenessCounts lateness_counts_of(const Histogram& histogram);

/// The real-time loop since its start.
struct LoopFigures {
  std::uint64_t cycles = 0, overruns = 0, missed = 0, frame_timeouts = 0;
  Durations lateness{}, work{}, compute{}, write{};      ///< of cycles, see loop::LoopStatistics
  Durations sample_wire{}, sample_wait{}, sample_age{};  ///< see live::SampleLatency
  LatenessCounts lateness_counts{};
  std::vector<std::pair<std::string, bool>> privileges;
  /// Steps and events dropped because a ring from the loop to other threads was full.
  std::uint64_t lost_records = 0, lost_events = 0;

  /// Calls visit(name, durations) for each of them.
  template <class Visit>
  void each_time(Visit&& visit) const {
    visit("lateness_us", lateness);
    visit("work_us", work);
    visit("compute_us", compute);
    visit("write_us", write);
    visit("sample_wire_us", sample_wire);
    visit("sample_wait_us", sample_wait);
    visit("sample_age_us", sample_age);
  }
};

/// The port in use.
struct PortFigures {
  std::string path;
  RobotKind kind = RobotKind::kPhysical;  ///< known once a board has answered
  std::string firmware = {};              ///< empty: no board has answered yet
  std::string note = {};  ///< last line about the search for the port, as in the log
};

/// The link over the last second.
struct LinkFigures {
  SessionState session = SessionState::kClosed;
  LinkCounters counters{};
  ClockState clock{};
  double samples_hz = 0.0, lost_hz = 0.0, bad_hz = 0.0, in_bytes_ps = 0.0, out_bytes_ps = 0.0;
  PortFigures port{};
  Durations sample_age{};
};

/// The last STOP.
struct StopFigures {
  enum class Status : std::uint8_t { kNone, kPending, kAcknowledged, kNotAcknowledged };
  std::uint64_t count = 0;  ///< of all doors, also STOPs that nobody pressed
  bool latched = false;
  std::string by;           ///< who pressed the last one
  HostNs requested_ns = 0;  ///< of the oldest unacknowledged press, else of the last one
  Status status = Status::kNone;
  double acknowledged_ms = 0.0;
};

/// Names as in /state.stop.status.
inline constexpr std::array<EnumName<StopFigures::Status>, 4> kStopStatusNames = {{
    {StopFigures::Status::kNone, "none"},
    {StopFigures::Status::kPending, "pending"},
    {StopFigures::Status::kAcknowledged, "acknowledged"},
    {StopFigures::Status::kNotAcknowledged, "not_acknowledged"},
}};

/// The client that drives by hand.
struct DriverFigures {
  std::string by;        ///< empty: nobody
  bool fresh = false;    ///< the driver's input is fresh
  std::string asked_by;  ///< who else asked for the lease in the last seconds; empty: nobody
};

/// Run, session and the operations possible now.
struct StateFigures {
  RunState run = RunState::kIdle;
  PoseSource steering = PoseSource::kOdometry;
  SessionState session = SessionState::kClosed;
  std::optional<RobotState> robot;
  bool motors_on = false;  ///< armed or driven with a duty, requested or not
  std::optional<double> run_s;
  double largest_m = 0.0;     ///< largest distance from the path in this run, or the last
  double pause_left_s = 0.0;  ///< 0: the run does not pause
  double progress_m = 0.0;
  std::optional<double> length_m;
  std::optional<double> battery_v;
  std::optional<Pose> pose;  ///< the steering pose in the world; nothing before the first step
  StartPlaces start_places{};
  double onward_m = 0.0;  ///< as in the snapshot
  bool can_start = false, can_record = false;
  std::string why_not_start;
  std::string why_not_drive;
  DriverFigures driver{};
  bool confirm_start = true;   ///< a start needs the viewer's confirmation
  FaultMask faults = 0;        ///< latched by robot or daemon
  FaultMask robot_faults = 0;  ///< those that the robot's newest sample has
  StopFigures stop{};
};

/// The recorder.
struct RecordingFigures {
  bool available = false;
  bool active = false;
  std::string run, file;
  double elapsed_s = 0.0;
  std::uint64_t bytes = 0, dropped = 0;
  std::string warning;
};
TP100_FIELDS(RecordingFigures, available, active, run, file, elapsed_s, bytes, dropped, warning)

/// One viewer.
struct ClientFigures {
  std::uint32_t id = 0;
  std::string address, agent;
  std::size_t subscriptions = 0;
  std::uint64_t sent = 0, dropped = 0;
  std::size_t queued = 0;
  double connected_s = 0.0;
};
TP100_FIELDS(ClientFigures, id, address, agent, subscriptions, sent, dropped, queued, connected_s)
struct ClientsFigures {
  std::vector<ClientFigures> clients;
  std::uint64_t dropped_total = 0, refused_total = 0, closed_total = 0;
  std::size_t queue_limit = 0;
};

}  // namespace tp100::messages
