#pragma once
// Decodes the robot's bytes into good frames and counts all others by cause. No allocation.

#include <cstddef>
#include <cstdint>

#include "core/link_state.h"
#include "wire/frame.h"

namespace tp100::link {

/// Receiver of one port. Before the first good frame of a port every byte is foreign (a bootloader,
/// a modem probe, the tail of a frame); after it, each corrupted frame counts once under its cause.
class FrameReader {
 public:
  /// `counters` must outlive the reader.
  explicit FrameReader(LinkCounters& counters) : counters_(counters) {}

  /// A port was opened or closed: discards a half-received frame.
  void reset();

  /// Takes one byte. True: type(), payload() and size() hold a good frame until the next push.
  bool push(std::uint8_t byte);

  std::uint8_t type() const { return decoder_.type(); }
  const std::uint8_t* payload() const { return decoder_.payload(); }
  std::size_t size() const { return decoder_.size(); }
  /// Bytes of the last good frame on the wire, delimiter included.
  std::size_t frame_bytes() const { return frame_bytes_; }

 private:
  void count(wire::DecodeResult cause);

  LinkCounters& counters_;
  wire::FrameDecoder decoder_;
  std::uint64_t pending_ = 0;  // bytes since the last delimiter, including it
  std::size_t frame_bytes_ = 0;
  bool in_step_ = false;
  bool skipping_ = false;
};

}  // namespace tp100::link
