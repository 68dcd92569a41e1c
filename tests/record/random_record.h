#pragma once
// Step records with every field filled at random, within what decode_step takes.

#include <memory>
#include <random>

#include "record/step_fields.h"

namespace tp100::record {

class RandomFiller {
 public:
  explicit RandomFiller(std::uint64_t seed) : random_(seed) {}

  template <class T>
  void operator()(const char*, T& value) {
    if constexpr (std::same_as<T, bool>) {
      value = random_() % 2 == 1;
    } else if constexpr (std::same_as<T, double>) {
      value = std::uniform_real_distribution<>(-0.4, 0.4)(random_);
    } else if constexpr (std::is_arithmetic_v<T>) {
      value = static_cast<T>(random_() >> 5);
    } else {
      visit_fields(*this, value);
    }
  }
  void operator()(const char* name, std::array<double, 3>& values) {
    for (double& value : values) (*this)(name, value);
  }
  template <class T>
  void operator()(const char*, T& value, T last) {
    value = static_cast<T>(random_() % (static_cast<unsigned>(last) + 1));
  }
  template <class T, std::size_t N, class... Last>
  void list(const char* name, std::array<T, N>& entries, std::uint32_t& count, Last... last) {
    count = static_cast<std::uint32_t>(random_() % 4);
    for (std::uint32_t i = 0; i < count; ++i) (*this)(name, entries[i], last...);
  }

 private:
  std::mt19937_64 random_;
};

/// Times and step numbers ascend by `number`, 200 a second.
inline std::unique_ptr<StepRecord> random_record(std::uint64_t number) {
  auto record = std::make_unique<StepRecord>();
  RandomFiller filler(number);
  visit_fields(filler, *record);
  record->step = number;
  record->now_ns = static_cast<HostNs>(number) * 5 * kNsPerMs;
  return record;
}

}  // namespace tp100::record
