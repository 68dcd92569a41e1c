#pragma once
// An ATmega2560 in simavr with nothing around it but a UART, two encoders and a battery.

#include <cstdint>
#include <string>
#include <vector>

#include "wire/frame.h"
#include "wire/messages.h"

struct avr_t;
struct avr_irq_t;

namespace tp100::image {

/// One good frame with the time at which its delimiter was sent.
struct SentFrame {
  double at_ms;
  std::uint8_t type;
  std::vector<std::uint8_t> payload;
};

class Mega {
 public:
  /// Loads an ELF. Throws std::runtime_error if it cannot.
  explicit Mega(const std::string& elf);
  ~Mega();
  Mega(const Mega&) = delete;
  Mega& operator=(const Mega&) = delete;

  /// Runs for so long, or until the program ends itself.
  void run_ms(double ms);
  double now_ms() const;

  /// Bytes for the UART, one every 22 us from now on.
  void send(const std::vector<std::uint8_t>& bytes);
  template <class Message>
  void send(const Message& message) {
    std::uint8_t payload[wire::kMaxPayload];
    std::vector<std::uint8_t> frame(wire::kMaxFrame);
    const std::size_t size = wire::write_payload(message, payload);
    frame.resize(
        wire::encode_frame(static_cast<std::uint8_t>(message.kType), payload, size, frame.data()));
    send(frame);
  }
  /// Steps of both belts, one every `period_us`; 0: standing.
  void turn(int direction, double period_us);

  const std::vector<std::uint8_t>& bytes() const { return bytes_; }
  const std::vector<SentFrame>& frames() const { return frames_; }
  /// The last frame of a type. Throws if there is none.
  template <class Message>
  Message last() const {
    Message message{};
    const SentFrame& frame = last_frame(static_cast<std::uint8_t>(message.kType));
    wire::read_payload(frame.payload.data(), frame.payload.size(), message);
    return message;
  }
  /// Frames of a type so far.
  std::size_t count(wire::Type type) const;
  /// Frames with a wrong CRC and the like.
  std::size_t bad_frames() const { return bad_; }

  /// True if neither enable is driven or pulsed.
  bool motors_off() const;
  /// Duties at the driver, -1..1.
  double left_duty() const;
  double right_duty() const;

 private:
  static void on_sent(avr_irq_t*, std::uint32_t value, void* self);
  static std::uint64_t on_byte_time(avr_t*, std::uint64_t when, void* self);
  static std::uint64_t on_step_time(avr_t*, std::uint64_t when, void* self);
  const SentFrame& last_frame(std::uint8_t type) const;
  double duty(unsigned compare_bit, unsigned compare_register, unsigned forward_pin,
              unsigned enable_pin) const;

  avr_t* avr_;
  wire::FrameDecoder decoder_;
  std::vector<std::uint8_t> bytes_;
  std::vector<SentFrame> frames_;
  std::size_t bad_ = 0;
  std::vector<std::uint8_t> to_send_;
  std::size_t sent_ = 0;
  int direction_ = 0;
  std::uint64_t step_cycles_ = 1600;
  int quarter_ = 0;
};

}  // namespace tp100::image
