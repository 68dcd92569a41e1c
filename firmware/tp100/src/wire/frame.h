// Framing: a body is `type (1) | payload | CRC-16 of both, little-endian (2)`. The body is
// COBS-encoded, so that it holds no zero byte, and a single 0x00 ends the frame. A receiver that
// joins in the middle or meets a corrupted byte is synchronised again at the next 0x00; no length
// is ever read from the wire.
#ifndef TP100_WIRE_FRAME_H
#define TP100_WIRE_FRAME_H

#include <stddef.h>
#include <stdint.h>
#include <string.h>

namespace tp100 {
namespace wire {

/// CRC-16/IBM-3740 (also called CCITT-FALSE): polynomial 0x1021, initial value 0xFFFF, not
/// reflected, no final xor; check value of "123456789" is 0x29B1. Without a table: the polynomial
/// has so few terms that a whole byte is a handful of exclusive ors.
const uint16_t kCrcInitial = 0xFFFF;

/// CRC extended by one byte. Pure. Computed bytewise: about 20 cycles on an ATmega2560.
inline uint16_t crc16_update(uint16_t crc, uint8_t byte) {
  uint8_t term = static_cast<uint8_t>(static_cast<uint8_t>(crc >> 8) ^ byte);
  term = static_cast<uint8_t>(term ^ (term >> 4));
  const uint8_t high = static_cast<uint8_t>(static_cast<uint8_t>(crc) ^
                                            static_cast<uint8_t>(term << 4) ^ (term >> 3));
  const uint8_t low = static_cast<uint8_t>(term ^ static_cast<uint8_t>(term << 5));
  return static_cast<uint16_t>(static_cast<uint16_t>(high) << 8 | low);
}

/// CRC of a whole buffer, starting from `crc`.
inline uint16_t crc16(const uint8_t* data, size_t size, uint16_t crc = kCrcInitial) {
  for (size_t i = 0; i < size; ++i) crc = crc16_update(crc, data[i]);
  return crc;
}

const uint8_t kDelimiter = 0x00;
/// Largest payload of any message in either direction, bytes.
const size_t kMaxPayload = 96;
/// Largest body: type, payload, CRC.
const size_t kMaxBody = 1 + kMaxPayload + 2;
/// Largest frame on the wire: COBS adds one byte to a body this short, and the delimiter follows.
const size_t kMaxFrame = kMaxBody + 2;
// CobsWriter writes one code byte per block and never needs 0xFF, which codes a block without a
// zero.
static_assert(kMaxBody < 254, "a longer body needs COBS blocks of code 0xFF");

/// Writes a body as COBS: each code byte is the distance to the next zero, which it replaces.
class CobsWriter {
 public:
  explicit CobsWriter(uint8_t* out) : code_at_(out), at_(out + 1) {}
  void put(uint8_t byte) {
    if (byte != 0) {
      *at_++ = byte;
      return;
    }
    *code_at_ = static_cast<uint8_t>(at_ - code_at_);
    code_at_ = at_++;
  }
  /// Returns the end of the frame.
  uint8_t* finish() {
    *code_at_ = static_cast<uint8_t>(at_ - code_at_);
    *at_++ = kDelimiter;
    return at_;
  }

 private:
  uint8_t* code_at_;
  uint8_t* at_;
};

/// Encodes one frame into `out` (room for kMaxFrame bytes). Returns its length with the delimiter,
/// or 0 if `size` exceeds kMaxPayload. No allocation; safe in the real-time thread.
inline size_t encode_frame(uint8_t type, const uint8_t* payload, size_t size, uint8_t* out) {
  if (size > kMaxPayload) return 0;
  CobsWriter writer(out);
  uint16_t crc = crc16_update(kCrcInitial, type);
  writer.put(type);
  for (const uint8_t* end = payload + size; payload != end; ++payload) {
    crc = crc16_update(crc, *payload);
    writer.put(*payload);
  }
  writer.put(static_cast<uint8_t>(crc & 0xFF));
  writer.put(static_cast<uint8_t>(crc >> 8));
  return static_cast<size_t>(writer.finish() - out);
}

/// Result of one received byte.
enum class DecodeResult : uint8_t {
  kNothing,   ///< in the middle of a frame, or a spare delimiter
  kFrame,     ///< a good frame is in type(), payload(), size() until the next push
  kOversize,  ///< more bytes than any frame has; counted once, skipped to the next delimiter
  kCobs,      ///< a code byte that points past the end
  kShort,     ///< decodes, but is smaller than type and CRC
  kCrc,       ///< decodes, but the CRC differs
};

/// Byte-wise receiver with one fixed buffer. Never allocates, never reads past its buffer, accepts
/// any bytes. A corrupted byte costs its own frame and, if it is a delimiter, also the next one.
class FrameDecoder {
 public:
  DecodeResult push(uint8_t byte) { return push(&byte, 1); }
  /// The same for `size` > 0 bytes, of which only the last may be a delimiter.
  DecodeResult push(const uint8_t* bytes, uint8_t size) {
    const bool ends = bytes[size - 1] == kDelimiter;
    const bool fits = keep(bytes, ends ? static_cast<uint8_t>(size - 1) : size);
    if (!ends) return fits ? DecodeResult::kNothing : DecodeResult::kOversize;
    const uint8_t coded = used_;
    const bool skipped = skipping_;
    reset();
    if (!fits) return DecodeResult::kOversize;
    return skipped || coded == 0 ? DecodeResult::kNothing : finish(coded);
  }

  /// Forgets a half-received frame (a new connection).
  void reset() {
    used_ = 0;
    skipping_ = false;
  }

  uint8_t type() const { return type_; }
  const uint8_t* payload() const { return buffer_ + 1; }
  size_t size() const { return size_; }

 private:
  // False: these are the first bytes that no frame has room for.
  bool keep(const uint8_t* bytes, uint8_t size) {
    if (skipping_) return true;
    if (size > kMaxFrame - 1 - used_) {
      skipping_ = true;
      return false;
    }
    memcpy(buffer_ + used_, bytes, size);
    used_ = static_cast<uint8_t>(used_ + size);
    return true;
  }

  // Decodes in place: the write index never passes the read index.
  DecodeResult finish(uint8_t coded) {
    const uint8_t* read = buffer_;
    const uint8_t* const end = buffer_ + coded;
    uint8_t* write = buffer_;
    while (read != end) {
      uint8_t code = *read++;
      if (static_cast<uint8_t>(code - 1) > end - read) return DecodeResult::kCobs;
      while (--code != 0) *write++ = *read++;
      // No frame needs the code 0xFF, see above.
      if (read != end) *write++ = 0;
    }
    const uint8_t size = static_cast<uint8_t>(write - buffer_);
    if (size < 3) return DecodeResult::kShort;
    const uint16_t sent =
        static_cast<uint16_t>(write[-2] | (static_cast<uint16_t>(write[-1]) << 8));
    if (crc16(buffer_, size - 2U) != sent) return DecodeResult::kCrc;
    type_ = buffer_[0];
    size_ = size - 3U;
    return DecodeResult::kFrame;
  }

  uint8_t buffer_[kMaxFrame] = {};
  uint8_t used_ = 0;
  bool skipping_ = false;
  uint8_t type_ = 0;
  size_t size_ = 0;
};

}  // namespace wire
}  // namespace tp100

#endif
