#pragma once
// Writes one MCAP file: messages are gathered in chunks, and what a reader of a whole file wants
// (statistics, indexes, CRCs) is written at the end. What was written is of use without that end.
// Memory does not grow with the file: what of the index is long waits in a file without a name.
// One thread at a time.

#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/bytes.h"
#include "record/mcap_format.h"
#include "record/nameless_file.h"
#include "record/recording_file.h"

namespace tp100::record {

struct McapSchema {
  std::string name;
  std::string encoding;  ///< "jsonschema", or one of our own
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
  /// Begins `file`, which must be empty and outlive the writer. Errors are the file's; after one,
  /// nothing more is written.
  McapWriter(RecordingFile& file, std::string_view library, McapCompression compression);
  ~McapWriter();

  std::uint16_t add_schema(const McapSchema& schema);
  std::uint16_t add_channel(std::uint16_t schema, std::string_view topic,
                            std::string_view message_encoding);
  void attach(const McapAttachment& attachment);
  void add_metadata(std::string_view name, const McapMap& entries);

  /// Into the open chunk. Times may go back a little.
  void message(std::uint16_t channel, std::uint64_t log_ns, std::span<const std::uint8_t> data);
  /// Messages that wait for the end of their chunk: bytes, and the time of the first.
  std::size_t open_bytes() const { return chunk_.size(); }
  std::uint64_t open_since_ns() const { return open_since_ns_; }
  /// Writes the open chunk, if there is anything in it.
  void end_chunk();
  /// Forgets the open chunk.
  void drop_chunk();

  /// The end of the file. The file is whole if it has no error then.
  void finish();
  /// No more than this is needed for the open chunk and the end.
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
  Crc32 data_crc_;
  struct Zstd;
  std::unique_ptr<Zstd> zstd_;

  std::vector<Channel> channels_;
  Bytes chunk_;   // records of the open chunk
  Bytes packed_;  // the same, compressed
  Bytes record_;  // what is written next
  std::uint64_t open_since_ns_ = 0;
  std::uint64_t first_ns_ = 0, last_ns_ = 0;  // earliest and latest of the open chunk

  Group schema_group_, channel_group_, attachment_group_, metadata_group_;
  Group chunk_group_;  // the newest; those before are in index_
  std::unique_ptr<NamelessFile> index_;
  std::uint64_t begin_ns_ = 0, end_ns_ = 0;
  std::uint64_t message_count_ = 0;
};

}  // namespace tp100::record
