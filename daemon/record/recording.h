#pragma once
// A recorded run: its facts, every step bit for bit, the truth where it was known, and the viewers'
// messages.

#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <set>
#include <string>
#include <string_view>

#include "core/step_record.h"
#include "record/mcap_reader.h"

namespace tp100::record {

/// Receives the content of a recording in file order; unset functions are skipped. Arguments are
/// valid during the call only. Times are within 2^60 ns of zero, inputs and truth finite; results
/// of steps may be any numbers.
struct RecordingVisitor {
  /// A step before the recording: only its inputs.
  std::function<void(const StepRecord&)> before{};
  std::function<void(const StepRecord&)> step{};
  std::function<void(HostNs at, const Pose& truth)> truth{};
  /// JSON of the other topics: of those in `topics`, or of all if that is empty.
  std::function<void(const std::string& topic, std::uint64_t unix_ns, std::string_view json)>
      message{};
  std::set<std::string> topics{};
};

/// Whether `path` is the folder of a recorded run or looks like a recording.
bool is_recording(const std::string& path);
/// The recording's file: `path`, or run.mcap in it if it is a folder.
std::string recording_file(const std::string& path);
/// Name of the run whose file or folder is `path`: of its folder, or of the file if that is not
/// called run.mcap.
std::string run_name(const std::string& path);

class Recording {
 public:
  /// `path`: a file, or the folder of a run. Throws UserError: missing, not a recording of a run,
  /// or corrupted.
  explicit Recording(const std::string& path);
  ~Recording();

  const std::string& path() const;
  /// False: truncated by a kill or a full disk; everything before is still read.
  bool whole() const;
  /// Value of `name` ("course", "robot", "setup", "seed", "version", ...); empty: not known.
  std::string fact(const std::string& name) const;
  const std::map<std::string, std::string>& facts() const;
  /// Host time of t_s = 0; 0 if the file does not contain it.
  HostNs start_ns() const;
  /// Unix time of t_s = 0, unchecked: any number; 0 if the file does not contain it.
  std::int64_t start_unix_ns() const;
  /// Text of a file as it was loaded ("course.toml", "robot.toml", "tp100.toml"); empty: none.
  std::string file(const std::string& name) const;

  /// All of it. Throws UserError where the file is corrupted, or if its steps were recorded by a
  /// version with another layout.
  void visit(const RecordingVisitor& visitor) const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace tp100::record
