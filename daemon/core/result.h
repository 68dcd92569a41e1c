#pragma once
// The outcome of what may be refused.

#include <string>
#include <utility>
#include <variant>

namespace tp100 {

/// Why something is refused, in one line: what, where, what to do.
struct Refusal {
  std::string why;
};

/// The result of what returns nothing else.
struct Done {};

/// A value, or a refusal.
template <class T = Done>
class [[nodiscard]] Result {
 public:
  Result(T value) : content_(std::in_place_index<0>, std::move(value)) {}
  Result(Refusal refusal) : content_(std::in_place_index<1>, std::move(refusal)) {}

  explicit operator bool() const { return content_.index() == 0; }
  // Only if it is a value:
  T& operator*() { return std::get<0>(content_); }
  const T& operator*() const { return std::get<0>(content_); }
  T* operator->() { return &**this; }
  const T* operator->() const { return &**this; }
  /// Only if it is one.
  const Refusal& refusal() const { return std::get<1>(content_); }
  /// Why it is refused; empty: it is not.
  std::string why() const { return *this ? std::string() : refusal().why; }

 private:
  std::variant<T, Refusal> content_;
};

}  // namespace tp100
