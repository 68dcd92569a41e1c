// Frames to and from the host. Never blocks: a frame is written only if the UART takes all of it.
#ifndef TP100_FIRMWARE_HOST_LINK_H
#define TP100_FIRMWARE_HOST_LINK_H

#include "hal.h"
#include "wire/frame.h"

namespace tp100 {
namespace firmware {

/// Received frames lost, by cause, and frames not sent. The counters wrap.
struct LinkCounts {
  uint16_t good;
  uint16_t oversize;
  uint16_t cobs;
  uint16_t undersize;
  uint16_t crc;
  uint16_t unknown;  ///< good frame of an unknown type or of another size
  uint16_t unsent;   ///< own message dropped for lack of room

  uint16_t corrupted() const { return static_cast<uint16_t>(oversize + cobs + undersize + crc); }
};

class HostLink {
 public:
  explicit HostLink(Hal& hal) : hal_(hal) {}

  /// The most bytes of one pass of the loop, which a host that floods the wire must not hold up.
  static const uint8_t kMostReceived = 32;

  /// Takes bytes until a good frame is complete or `budget` <= kMostReceived bytes are used up.
  /// True: type(), payload() and size() hold a frame until the next call.
  bool receive(uint8_t& budget);
  uint8_t type() const { return decoder_.type(); }
  const uint8_t* payload() const { return decoder_.payload(); }
  size_t size() const { return decoder_.size(); }
  /// Device time at which the delimiter of that frame was taken. [us]
  uint32_t received_us() const { return received_us_; }
  /// Reads the current frame as a message. False, and counted, if the size does not match.
  template <class Message>
  bool read(Message& message) {
    if (wire::read_payload(payload(), size(), message)) return true;
    ++counts_.unknown;
    return false;
  }
  void count_unknown() { ++counts_.unknown; }

  /// Writes a message at once. False: no room now.
  template <class Message>
  bool send(const Message& message) {
    uint8_t payload[Message::kSize];
    wire::write_payload(message, payload);
    return send(static_cast<uint8_t>(Message::kType), payload, Message::kSize);
  }

  /// Sends now, or as soon as there is room. A newer sample replaces a waiting one.
  void post(const wire::Sample& sample);
  void post(const wire::Hello& hello);
  /// The reply's sent_us is filled in when it leaves.
  void post(const wire::SyncReply& reply);
  /// Sends now, or as soon as there is room; dropped and counted if too many wait.
  void post(const wire::Acknowledge& acknowledge);
  void post(const wire::FaultReport& report);
  void post(const wire::Log& log);
  /// Posts `text` and `more` as one line; what is too long is cut off.
  void log(uint8_t level, const char* text, const char* more, uint32_t at_us);
  /// Messages wait for room.
  bool waiting() const {
    return (sync_.size | acknowledges_.size | sample_.size | reports_.size | hello_.size |
            logs_.size) != 0;
  }
  /// Writes waiting messages while there is room.
  void flush();

  const LinkCounts& counts() const { return counts_; }

 private:
  template <class Message, uint8_t kCapacity>
  struct Queue {
    Message items[kCapacity];
    uint8_t first;
    uint8_t size;
    bool push(const Message& message) {
      if (size == kCapacity) return false;
      items[(first + size) % kCapacity] = message;
      ++size;
      return true;
    }
    void push_over(const Message& message) {
      size = 0;
      push(message);
    }
    void pop() {
      first = static_cast<uint8_t>((first + 1) % kCapacity);
      --size;
    }
  };

  bool send(uint8_t type, const uint8_t* payload, uint8_t size);
  bool flush_sync();
  /// A delimiter precedes a hello: earlier bytes on the line must not become its beginning.
  bool flush_hello();
  template <class Message, uint8_t kCapacity>
  bool flush(Queue<Message, kCapacity>& queue);

  Hal& hal_;
  wire::FrameDecoder decoder_;
  uint32_t received_us_ = 0;
  LinkCounts counts_ = {};
  Queue<wire::SyncReply, 1> sync_ = {};
  Queue<wire::Acknowledge, 6> acknowledges_ = {};
  Queue<wire::Sample, 1> sample_ = {};
  // One place per fault of the robot: a report is never lost.
  Queue<wire::FaultReport, 13> reports_ = {};
  Queue<wire::Hello, 1> hello_ = {};
  Queue<wire::Log, 4> logs_ = {};
};

}  // namespace firmware
}  // namespace tp100

#endif
