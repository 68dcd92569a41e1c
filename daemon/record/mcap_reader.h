#pragma once
// Reads MCAP files, complete or truncated, ours or other programs'. A file is hostile input: sizes
// are checked before anything is allocated, memory stays bounded, CRCs are validated.

#include <cstdint>
#include <map>
#include <memory>
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

/// One message, valid during the call that passes it.
struct McapMessage {
  const McapChannel* channel = nullptr;
  std::uint32_t sequence = 0;
  std::uint64_t log_ns = 0;
  std::span<const std::uint8_t> data;

  std::string_view text() const {
    return {reinterpret_cast<const char*>(data.data()), data.size()};
  }
};

/// Receives the content of a file in order. Each call returns whether to continue.
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

/// Result of stream().
struct McapEnd {
  bool whole = false;           ///< the file has a proper end
  std::uint64_t corrupted = 0;  ///< chunks and attachments left out
  std::string problem;          ///< the first error, with its position
};

/// What stream() verifies: the content that it passes on, or also the indexes and the sum of the
/// whole file, on which other readers rely.
enum class McapCheck : bool { kContent, kIndexes };

class McapReader {
 public:
  /// Limit of a record and of an unpacked chunk; our own have one MiB.
  static constexpr std::uint64_t kMaxSize = std::uint64_t{64} << 20;

  /// Opens the file, or the one in an archive of a run as viewers load it (RUN/run.mcap, stored in
  /// a ZIP). Throws UserError: missing, not readable, or not an MCAP file.
  explicit McapReader(const std::string& path);
  ~McapReader();

  /// Reads everything from beginning to end. Skips and counts chunks and attachments with a wrong
  /// CRC or invalid content; stops where the next record cannot be found.
  McapEnd stream(McapHandler& handler, McapCheck check = McapCheck::kContent) const;

  /// Whether the file has a valid summary.
  bool indexed() const;

  const std::string& path() const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace tp100::record
