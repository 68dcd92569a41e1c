#pragma once
// Writes one MCAP file: collects messages in chunks, and writes statistics, indexes and CRCs at the
// end; a file without that end is still readable. Memory does not grow with the file: the long part
// of the index is kept in a nameless file. One thread at a time.

#include <boost/crc.hpp>
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/bytes.h"
#include "record/mcap_format.h"
#include "record/recording_file.h"

namespace tp100::record {

struct McapSchema {
  std::string name;
  std::string encoding;  ///< "jsonschema", "ros2msg", or one of our own
  std::string text;
};

struct McapAttachment {
  std::string name;
  std::string media_type;
  std::uint64_t log_ns = 0;
  std::string data;
};

using McapMap = std::vector<std::pair<std::string, std::string>>;

enum class McapCompression { kNone, kZstd };

class McapWriter {
 public:
  /// Begins `file`, which must be empty and outlive the writer. Errors are reported by the file;
  /// after one, nothing more is written. `profile`: of MCAP's registry, or empty.
  McapWriter(RecordingFile& file, std::string_view library, McapCompression compression,
             std::string_view profile = "");
  ~McapWriter();

  std::uint16_t add_schema(const McapSchema& schema);
  std::uint16_t add_channel(std::uint16_t schema, std::string_view topic,
                            std::string_view message_encoding, const McapMap& metadata = {});
  void attach(const McapAttachment& attachment);
  void add_metadata(std::string_view name, const McapMap& entries);

  /// Adds to the open chunk. Times may be slightly out of order.
  void message(std::uint16_t channel, std::uint64_t log_ns, std::span<const std::uint8_t> data);
  /// Size of the open chunk in bytes.
  std::size_t open_bytes() const { return chunk_.size(); }
  std::uint64_t open_since_ns() const { return open_since_ns_; }
  /// Writes the open chunk, unless it is empty.
  void end_chunk();
  /// Discards the open chunk without writing it.
  void drop_chunk();

  /// Writes the end of the file. The file is complete if it has no error afterwards.
  void finish();
  /// Upper bound of the bytes needed for the open chunk and the end.
  std::uint64_t needed() const;

 private:
  struct Entry {
    std::uint64_t log_ns, offset;
  };
  struct Channel {
    std::uint32_t sequence = 0;  // of its next message
    std::uint64_t written = 0;   // messages in the file
    std::vector<Entry> open;     // in the open chunk
  };
  /// A group of records of the summary.
  struct Group {
    Bytes records;
    std::uint32_t count = 0;
  };

  void write(const Bytes& bytes);
  void write_chunk();
  std::string_view pack();
  void index_messages(std::uint64_t chunk_offset, std::uint64_t chunk_length,
                      std::string_view compression);
  bool open_index();
  void set_index_aside();
  Bytes chunk_index() const;
  void write_statistics(ByteWriter& out) const;

  RecordingFile& file_;
  boost::crc_32_type data_crc_;
  struct Zstd;
  std::unique_ptr<Zstd> zstd_;

  std::vector<Channel> channels_;
  Bytes chunk_;   // records of the open chunk
  Bytes packed_;  // the same, compressed
  Bytes record_;  // the record to be written next
  std::uint64_t open_since_ns_ = 0;
  std::uint64_t first_ns_ = 0, last_ns_ = 0;  // earliest and latest of the open chunk

  Group schema_group_, channel_group_, attachment_group_, metadata_group_;
  Group chunk_group_;  // the newest; earlier ones are in index_
  std::unique_ptr<AnonymousFile> index_;
  std::uint64_t begin_ns_ = 0, end_ns_ = 0;
  std::uint64_t message_count_ = 0;
};

}  // namespace tp100::record
