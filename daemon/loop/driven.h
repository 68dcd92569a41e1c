#pragma once
// What the real-time loop drives. Every call comes from the real-time thread: no allocation, lock,
// log or blocking call.

#include <cstddef>
#include <cstdint>
#include <span>

#include "core/time.h"

namespace tp100::loop {

class Driven {
 public:
  virtual ~Driven() = default;

  /// A port was opened, or is gone.
  virtual void opened(HostNs now) = 0;
  virtual void closed(HostNs now) = 0;
  /// Bytes were read; `now` is right after the read. True: a sample is among them, a turn paced by
  /// the robot may begin.
  virtual bool received(std::span<const std::uint8_t> bytes, HostNs now) = 0;
  /// One turn, up to the bytes to write.
  virtual void step(HostNs now) = 0;
  /// The rest of the turn, once they are written: what the robot does not wait for. If it paces the
  /// loop, up to half a period later, but before more is read or stepped. `now` as in step().
  virtual void settle(HostNs now) = 0;

  /// Bytes to write, in order.
  virtual std::span<const std::uint8_t> output() = 0;
  virtual void written(std::size_t n) = 0;
  /// The port did not take them in time.
  virtual void drop_output() = 0;

  /// True while bytes should be read the moment they come, because their time matters.
  virtual bool expects_reply(HostNs now) = 0;
  /// True once if the port should be closed and opened again: its peer is silent.
  virtual bool take_hang_up() = 0;
  /// The program ends: called every turn from then on; true when nothing is left to do.
  virtual bool wind_up(HostNs now) = 0;
};

}  // namespace tp100::loop
