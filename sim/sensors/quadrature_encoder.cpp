#include "sim/sensors/quadrature_encoder.h"

#include "core/time.h"

namespace tp100::sim {

namespace {

// Levels of A (bit 1) and B (bit 0) by count modulo 4.
constexpr std::array<unsigned, 4> kLevels = {0b00, 0b10, 0b11, 0b01};

std::size_t phase(std::int64_t count) { return static_cast<std::size_t>(count & 3); }

}  // namespace

QuadratureEncoder::QuadratureEncoder(const course::EmulatedEncoder& values,
                                     std::uint8_t first_channel, std::uint64_t seed)
    : counts_per_metre_(values.counts_per_metre), first_channel_(first_channel) {
  std::mt19937_64 random(seed);
  std::uniform_real_distribution<double> error(-values.phase_error, values.phase_error);
  for (double& offset : offsets_) offset = error(random);
}

double QuadratureEncoder::boundary(std::int64_t count) const {
  return static_cast<double>(count) + offsets_[phase(count)];
}

void QuadratureEncoder::emit(std::int64_t count, HostNs at_ns, std::vector<EncoderEdge>& edges) {
  const unsigned changed = kLevels[phase(count)] ^ kLevels[phase(counts_)];
  const bool is_b = changed == 0b01;
  const bool level = (kLevels[phase(count)] & changed) != 0;
  counts_ = count;
  edges.push_back({at_ns, static_cast<std::uint8_t>(first_channel_ + (is_b ? 1 : 0)), level});
}

void QuadratureEncoder::move(double travel_m, HostNs from_ns, HostNs to_ns,
                             std::vector<EncoderEdge>& edges) {
  const double from = position_;
  position_ += travel_m * counts_per_metre_;
  const double span = position_ - from;
  if (span == 0.0) return;
  const auto time_of = [&](double at) {
    return from_ns +
           static_cast<std::int64_t>((at - from) / span * static_cast<double>(to_ns - from_ns));
  };
  while (position_ >= boundary(counts_ + 1)) {
    emit(counts_ + 1, time_of(boundary(counts_ + 1)), edges);
  }
  while (position_ < boundary(counts_)) {
    emit(counts_ - 1, time_of(boundary(counts_)), edges);
  }
}

}  // namespace tp100::sim
