#include "link/frame_reader.h"

namespace tp100::link {

using wire::DecodeResult;

void FrameReader::reset() {
  if (!in_step_) {
    counters_.foreign_bytes += pending_;
  } else if (pending_ > 0 && !skipping_) {
    ++counters_.undersize;
  }
  decoder_.reset();
  pending_ = 0;
  in_step_ = false;
  skipping_ = false;
}

bool FrameReader::push(std::uint8_t byte) {
  ++pending_;
  const DecodeResult received = decoder_.push(byte);
  if (received == DecodeResult::kOversize) skipping_ = true;
  const bool ends = byte == wire::kDelimiter;
  if (received == DecodeResult::kFrame) {
    in_step_ = true;
    frame_bytes_ = static_cast<std::size_t>(pending_);
    ++counters_.frames_in;
  } else if (!in_step_) {
    if (ends || skipping_) {
      counters_.foreign_bytes += pending_;
      pending_ = 0;
    }
  } else {
    count(received);
  }
  if (ends) {
    pending_ = 0;
    skipping_ = false;
  }
  return received == DecodeResult::kFrame;
}

void FrameReader::count(DecodeResult cause) {
  switch (cause) {
    case DecodeResult::kOversize:
      ++counters_.oversize;
      break;
    case DecodeResult::kCobs:
      ++counters_.cobs_errors;
      break;
    case DecodeResult::kShort:
      ++counters_.undersize;
      break;
    case DecodeResult::kCrc:
      ++counters_.crc_errors;
      break;
    case DecodeResult::kNothing:
    case DecodeResult::kFrame:
      break;
  }
}

}  // namespace tp100::link
