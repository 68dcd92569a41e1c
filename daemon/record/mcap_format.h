#pragma once
// The MCAP file format, https://mcap.dev/spec, profile of our own: magic, header, then schemas,
// channels, attachments, metadata and chunks with their message indexes as they come, data end,
// summary, summary offsets, footer, magic. All numbers little-endian.

#include <array>
#include <boost/crc.hpp>
#include <cstdint>
#include <span>
#include <string>

#include "core/bytes.h"

namespace tp100::record {

inline constexpr std::array<std::uint8_t, 8> kMcapMagic = {0x89, 'M', 'C',  'A',
                                                           'P',  '0', '\r', '\n'};

/// Record types. Each record is its u8 type, u64 length and content.
enum class McapOp : std::uint8_t {
  kHeader = 0x01,
  kFooter = 0x02,
  kSchema = 0x03,
  kChannel = 0x04,
  kMessage = 0x05,
  kChunk = 0x06,
  kMessageIndex = 0x07,
  kChunkIndex = 0x08,
  kAttachment = 0x09,
  kAttachmentIndex = 0x0A,
  kStatistics = 0x0B,
  kMetadata = 0x0C,
  kMetadataIndex = 0x0D,
  kSummaryOffset = 0x0E,
  kDataEnd = 0x0F,
};

inline constexpr std::size_t kMcapRecordHead = 9;  ///< type and length
inline constexpr std::size_t kMcapFooterSize = 20;

/// As in zlib.
inline std::uint32_t crc32(std::span<const std::uint8_t> bytes) {
  boost::crc_32_type crc;
  crc.process_bytes(bytes.data(), bytes.size());
  return crc.checksum();
}

/// An error in a record; the catcher adds its position.
struct CorruptFile {
  std::string what;
};

/// The records of an unpacked chunk, or of a part of the file.
class RecordList {
 public:
  explicit RecordList(std::span<const std::uint8_t> bytes) : in_(bytes) {}
  /// Next record; false at the end. Throws CorruptFile.
  bool next() {
    if (in_.left() == 0) return false;
    op = static_cast<McapOp>(in_.number<std::uint8_t>());
    content = in_.bytes(in_.number<std::uint64_t>());
    if (!in_.ok()) throw CorruptFile{"a record is longer than the chunk or file that contains it"};
    return true;
  }
  McapOp op{};
  std::span<const std::uint8_t> content;

 private:
  ByteReader in_;
};

}  // namespace tp100::record
