#pragma once
// Reads MCAP files, whole or cut off, ours or others'. A file is hostile input: sizes are checked
// before anything is allocated, memory stays bounded, CRCs are validated.

#include <cstdint>
#include <functional>
#include <limits>
#include <map>
#include <memory>
#include <set>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/error.h"

namespace tp100::record {

/// A channel with its schema.
struct McapChannel {
  std::uint16_t id = 0;
  std::string topic;
  std::string encoding;  ///< of the messages
  std::string schema_name, schema_encoding, schema;
};

/// One message, valid during the call that hands it over.
struct McapMessage {
  const McapChannel* channel = nullptr;
  std::uint32_t sequence = 0;
  std::uint64_t log_ns = 0;
  std::span<const std::uint8_t> data;

  std::string_view text() const {
    return {reinterpret_cast<const char*>(data.data()), data.size()};
  }
};

/// Takes what a file holds, in its order. Each call says whether to go on.
class McapHandler {
 public:
  virtual ~McapHandler() = default;
  virtual bool channel(const McapChannel&) { return true; }
  virtual bool message(const McapMessage&) { return true; }
  virtual bool chunk_end() { return true; }
  virtual bool attachment(const std::string& name, const std::string& media_type,
                          std::uint64_t log_ns, std::string_view data) {
    (void)name, (void)media_type, (void)log_ns, (void)data;
    return true;
  }
  virtual bool metadata(const std::string& name, const std::map<std::string, std::string>&) {
    (void)name;
    return true;
  }
};

/// What stream() met.
struct McapEnd {
  bool whole = false;            ///< the file ends as it should
  std::uint64_t good_bytes = 0;  ///< up to here every record was whole
  std::uint64_t damaged = 0;     ///< chunks and attachments left out
  std::string problem;           ///< the first thing that was wrong, with its place
};

class McapReader {
 public:
  /// No record, and no unpacked chunk, may be larger: ours have one MiB.
  static constexpr std::uint64_t kMaxSize = std::uint64_t{64} << 20;

  /// Opens the file. Throws SetupError: not there, not readable, or no MCAP file.
  explicit McapReader(const std::string& path);
  ~McapReader();

  /// Everything, from beginning to end. A chunk or attachment with a wrong CRC or content that
  /// makes no sense is left out and counted; where not even the next record can be found, it ends.
  McapEnd stream(McapHandler& handler) const;

  /// The summary at the end is there and makes sense: read() works.
  bool indexed() const;
  /// Messages of these topics (all, if empty) with log time in [from, to], chunk by chunk, found
  /// through the index; within a chunk in file order. Throws SetupError: no index, or damage.
  void read(const std::set<std::string>& topics, std::uint64_t from_ns, std::uint64_t to_ns,
            McapHandler& handler) const;
  /// Messages in the file by its statistics; needs indexed().
  std::uint64_t message_count() const;

  const std::string& path() const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace tp100::record
