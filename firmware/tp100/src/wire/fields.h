// Little-endian fields. A message lists its fields once, with TP100_WIRE_FIELDS; writing, reading
// and the schema hash all walk that list.
#ifndef TP100_WIRE_FIELDS_H
#define TP100_WIRE_FIELDS_H

#include <stddef.h>
#include <stdint.h>
#include <string.h>

/// Gives a message its visit(visitor), which calls visitor.field(name, field) for each of its
/// fields in this order. A name ends at a comma or at its end. It is empty on the Mega, where it
/// would take RAM.
#define TP100_WIRE_FIELDS(...)                                                 \
  template <class V>                                                           \
  void visit(V& v) {                                                           \
    ::tp100::wire::visit_each(v, TP100_WIRE_NAMES(#__VA_ARGS__), __VA_ARGS__); \
  }
#ifdef __AVR__
#define TP100_WIRE_NAMES(names) ""
#else
#define TP100_WIRE_NAMES(names) names
#endif

namespace tp100 {
namespace wire {

template <class V>
void visit_each(V&, const char*) {}
template <class V, class Field, class... More>
inline __attribute__((always_inline)) void visit_each(V& v, const char* names, Field& field,
                                                      More&... more) {
  v.field(names, field);
  const char* const comma = strchr(names, ',');
  visit_each(v, comma != nullptr ? comma + 2 : names, more...);
}

/// Writes fields to a buffer of at least Message::kSize bytes.
class Writer {
 public:
  explicit Writer(uint8_t* out) : begin_(out), at_(out) {}
  void field(const char*, const uint8_t& value) { put(value, 1); }
  void field(const char*, const uint16_t& value) { put(value, 2); }
  void field(const char*, const uint32_t& value) { put(value, 4); }
  void field(const char*, const int16_t& value) { put(static_cast<uint16_t>(value), 2); }
  void field(const char*, const int32_t& value) { put(static_cast<uint32_t>(value), 4); }
  void field(const char*, const float& value) {
    uint32_t bits;
    memcpy(&bits, &value, 4);
    put(bits, 4);
  }
  template <class T, size_t N>
  void field(const char* name, const T (&values)[N]) {
    for (size_t i = 0; i < N; ++i) field(name, values[i]);
  }
  size_t size() const { return static_cast<size_t>(at_ - begin_); }

 private:
  void put(uint32_t value, uint8_t bytes) {
    for (uint8_t i = 0; i < bytes; ++i) {
      *at_++ = static_cast<uint8_t>(value);
      value >>= 8;
    }
  }
  uint8_t* begin_;
  uint8_t* at_;
};

/// Reads fields from a payload whose size was checked against Message::kSize.
class Reader {
 public:
  explicit Reader(const uint8_t* in) : at_(in) {}
  void field(const char*, uint8_t& value) { value = *at_++; }
  void field(const char*, uint16_t& value) { value = take2(); }
  void field(const char*, uint32_t& value) { value = take4(); }
  void field(const char*, int16_t& value) { value = static_cast<int16_t>(take2()); }
  void field(const char*, int32_t& value) { value = static_cast<int32_t>(take4()); }
  void field(const char*, float& value) {
    const uint32_t bits = take4();
    memcpy(&value, &bits, 4);
  }
  template <class T, size_t N>
  void field(const char* name, T (&values)[N]) {
    for (size_t i = 0; i < N; ++i) field(name, values[i]);
  }

 private:
  // Avoids a shift by a variable, which is a loop on an AVR.
  uint16_t take2() {
    const uint16_t value = static_cast<uint16_t>(at_[0] | static_cast<uint16_t>(at_[1]) << 8);
    at_ += 2;
    return value;
  }
  uint32_t take4() {
    const uint16_t low = take2();
    return low | static_cast<uint32_t>(take2()) << 16;
  }
  const uint8_t* at_;
};

/// Writes `message` to `out` (room for Message::kSize). Returns Message::kSize.
template <class Message>
size_t write_payload(const Message& message, uint8_t* out) {
  Writer writer(out);
  const_cast<Message&>(message).visit(writer);
  return writer.size();
}

/// Reads `message` from a payload. False if the size is not exactly Message::kSize.
template <class Message>
bool read_payload(const uint8_t* payload, size_t size, Message& message) {
  if (size != Message::kSize) return false;
  Reader reader(payload);
  message.visit(reader);
  return true;
}

}  // namespace wire
}  // namespace tp100

#endif
