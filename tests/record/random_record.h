#pragma once
// Step records whose fields are all filled at random, with values that decode_step accepts.

#include <memory>
#include <random>

#include "record/step_fields.h"

namespace tp100::record {

class RandomFiller {
 public:
  explicit RandomFiller(std::uint64_t seed) : random_(seed) {}

  template <class T>
  void operator()(std::string_view, T& value) {
    if constexpr (std::same_as<T, bool>) {
      value = random_() % 2 == 1;
    } else if constexpr (std::same_as<T, double>) {
      value = std::uniform_real_distribution<>(-0.4, 0.4)(random_);
    } else if constexpr (std::is_arithmetic_v<T>) {
      value = static_cast<T>(random_() >> 5);
    } else if constexpr (std::is_enum_v<T>) {
      (*this)("", value, last_of(value));
    } else {
      visit_fields(*this, value);
    }
  }
  template <std::size_t N>
  void operator()(std::string_view name, std::array<double, N>& values) {
    for (double& value : values) (*this)(name, value);
  }
  template <class T>
  void operator()(std::string_view, T& value, T last) {
    value = static_cast<T>(random_() % (static_cast<unsigned>(last) + 1));
  }
  template <class T, std::size_t N>
  void operator()(std::string_view name, BoundedList<T, N>& entries) {
    entries.resize(random_() % 4);
    for (T& entry : entries) (*this)(name, entry);
  }

 private:
  std::mt19937_64 random_;
};

/// Times and step numbers increase with `number`, at 200 steps per second. `restart`: the step
/// restarts.
inline std::unique_ptr<StepRecord> random_record(std::uint64_t number, bool restart = false) {
  auto record = std::make_unique<StepRecord>();
  RandomFiller filler(number);
  visit_fields(filler, *record);
  record->inputs.restart.resize(restart ? 1 : 0);
  for (CarriedState& carried : record->inputs.restart) carried.run_state = RunState::kFinished;
  record->step = number;
  record->now_ns = static_cast<HostNs>(number) * 5 * kNsPerMs;
  return record;
}

}  // namespace tp100::record
