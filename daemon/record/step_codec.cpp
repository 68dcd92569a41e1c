#include "record/step_codec.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <concepts>
#include <memory>
#include <string_view>
#include <type_traits>

#include "core/bytes.h"
#include "record/step_fields.h"

namespace tp100::record {
namespace {

template <class T>
concept Scalar = std::is_arithmetic_v<T>;

class Encoder {
 public:
  explicit Encoder(Bytes& out) : out_(out) {}

  template <class T>
  void operator()(std::string_view, const T& value) {
    if constexpr (std::same_as<T, bool> || std::is_enum_v<T>) {
      out_.number(static_cast<std::uint8_t>(value));
    } else if constexpr (Scalar<T>) {
      out_.number(value);
    } else {
      visit_fields(*this, value);
    }
  }
  template <class T>
  void operator()(std::string_view name, T value, T) {
    (*this)(name, value);
  }
  template <std::size_t N>
  void operator()(std::string_view name, const std::array<double, N>& values) {
    for (const double value : values) (*this)(name, value);
  }
  template <class T, std::size_t N>
  void operator()(std::string_view name, const BoundedList<T, N>& entries) {
    out_.number(static_cast<std::uint32_t>(entries.size()));
    for (const T& entry : entries) (*this)(name, entry);
  }

 private:
  ByteWriter out_;
};

class Decoder {
 public:
  explicit Decoder(std::span<const std::uint8_t> in) : in_(in) {}

  template <class T>
  void operator()(std::string_view name, T& value) {
    if constexpr (std::same_as<T, bool>) {
      const auto byte = in_.number<std::uint8_t>();
      if (byte > 1) refuse(name);
      value = byte == 1;
    } else if constexpr (Scalar<T>) {
      value = in_.number<T>();
      if (!plausible(value)) refuse(name);
    } else if constexpr (std::is_enum_v<T>) {
      (*this)(name, value, last_of(value));
    } else {
      if constexpr (std::same_as<T, LinkCounters>) inputs_ = false;
      visit_fields(*this, value);
    }
  }
  template <class T>
  void operator()(std::string_view name, T& value, T last) {
    const auto byte = in_.number<std::uint8_t>();
    if (byte > static_cast<std::uint8_t>(last)) return refuse(name);
    value = static_cast<T>(byte);
  }
  template <std::size_t N>
  void operator()(std::string_view name, std::array<double, N>& values) {
    for (double& value : values) (*this)(name, value);
  }
  template <class T, std::size_t N>
  void operator()(std::string_view name, BoundedList<T, N>& entries) {
    const auto count = in_.number<std::uint32_t>();
    entries.resize(count > N ? 0 : count);
    if (count > N) return refuse(name);
    for (T& entry : entries) (*this)(name, entry);
  }

  std::optional<std::string> problem() const {
    if (!refused_.empty()) return refused_ + " is out of range";
    if (!in_.ok()) return "too few bytes";
    if (in_.left() > 0) return std::to_string(in_.left()) + " bytes too many";
    return std::nullopt;
  }

 private:
  void refuse(std::string_view name) {
    if (refused_.empty()) refused_ = name;
  }
  template <class T>
  bool plausible(T value) const {
    if constexpr (std::same_as<T, double>) {
      return !inputs_ || std::abs(value) <= kMaxInput;
    } else if constexpr (std::same_as<T, std::int64_t>) {
      return value >= -kLongestTime && value <= kLongestTime;
    }
    return true;
  }

  ByteReader in_;
  bool inputs_ = true;  // the fields before the link's counters
  std::string refused_;
};

template <class T>
const char* type_name() {
  if constexpr (std::same_as<T, double>) return "f64";
  if constexpr (std::same_as<T, std::uint64_t>) return "u64";
  if constexpr (std::same_as<T, std::int64_t>) return "i64";
  if constexpr (std::same_as<T, std::uint32_t>) return "u32";
  if constexpr (std::same_as<T, std::uint16_t>) return "u16";
  static_assert(!std::same_as<T, float> && !std::same_as<T, std::int32_t>);
  return "u8";
}

class SchemaWriter {
 public:
  template <class T>
  void operator()(std::string_view name, const T& value) {
    if constexpr (Scalar<T>) {
      entry(name, std::is_same_v<T, bool> ? "bool" : type_name<T>());
    } else if constexpr (std::is_enum_v<T>) {
      (*this)(name, value, last_of(value));
    } else {
      group(name, [&] { visit_fields(*this, value); });
    }
  }
  template <class T>
  void operator()(std::string_view name, T, T last) {
    entry(name, "enum 0.." + std::to_string(static_cast<unsigned>(last)));
  }
  template <std::size_t N>
  void operator()(std::string_view name, const std::array<double, N>&) {
    entry(name, "f64[" + std::to_string(N) + "]");
  }
  template <class T, std::size_t N>
  void operator()(std::string_view name, const BoundedList<T, N>&) {
    group(name, [&] {
      entry("count", "u32");
      (*this)("entry", T{});
    });
  }

  std::string text;

 private:
  void entry(std::string_view name, const std::string& type) {
    if (text.ends_with(']')) text += ",";
    text += "[\"" + std::string(name) + "\",\"" + type + "\"]";
  }
  template <class Fields>
  void group(std::string_view name, Fields fields) {
    if (text.ends_with(']')) text += ",";
    text += "[\"" + std::string(name) + "\",[";
    fields();
    text += "]]";
  }
};

/// The first exchanges on a busy machine may yield any drift, even one near -1; but device time is
/// host time divided by 1 + drift.
bool has_device_time(const ClockState& clock, HostNs at) {
  const auto since_ns = static_cast<double>(at - clock.reference_host_ns);
  return std::abs(since_ns * 1e-3 / (1.0 + clock.drift)) <= static_cast<double>(kLongestTime);
}

std::optional<std::string> problem_of(const Decoder& decoder, const StepRecord& record) {
  if (auto problem = decoder.problem()) return problem;
  for (const CarriedState& carried : record.inputs.restart) {
    if (under_way(carried.run_state)) return "run_state is out of range";
  }
  if (!record.inputs.clock.valid) return std::nullopt;
  const auto& camera = record.inputs.camera;
  if (!has_device_time(record.inputs.clock, record.now_ns) ||
      !std::ranges::all_of(camera, [&](const CameraSample& seen) {
        return has_device_time(record.inputs.clock, seen.measured_ns);
      }))
    return "drift is out of range";
  return std::nullopt;
}

}  // namespace

void encode_step(const StepRecord& record, std::vector<std::uint8_t>& out) {
  Encoder encoder(out);
  visit_fields(encoder, record);
}

std::optional<std::string> decode_step(std::span<const std::uint8_t> bytes, StepRecord& record) {
  Decoder decoder(bytes);
  visit_fields(decoder, record);
  return problem_of(decoder, record);
}

void encode_inputs(const StepRecord& record, std::vector<std::uint8_t>& block) {
  ByteWriter out(block);
  const std::size_t size_at = out.size();
  out.number<std::uint32_t>(0);
  Encoder encoder(block);
  visit_inputs(encoder, record);
  out.patch(size_at, static_cast<std::uint32_t>(out.size() - size_at - sizeof(std::uint32_t)));
}

std::optional<std::string> decode_inputs(std::span<const std::uint8_t>& block, StepRecord& record) {
  ByteReader in(block);
  const auto bytes = in.bytes(in.number<std::uint32_t>());
  block = block.last(in.left());
  if (!in.ok()) return "too few bytes";
  Decoder decoder(bytes);
  visit_inputs(decoder, record);
  return problem_of(decoder, record);
}

const std::string& step_schema() {
  static const std::string kText = [] {
    SchemaWriter writer;
    writer.text = R"({"encoding":"little-endian, packed","fields":[)";
    visit_fields(writer, *std::make_unique<const StepRecord>());
    return writer.text + "]}";
  }();
  return kText;
}

const std::string& inputs_schema() {
  static const std::string kText = [] {
    SchemaWriter writer;
    writer.text =
        R"({"encoding":"little-endian, packed; each with its size in front, u32","fields":[)";
    visit_inputs(writer, *std::make_unique<const StepRecord>());
    return writer.text + "]}";
  }();
  return kText;
}

}  // namespace tp100::record
