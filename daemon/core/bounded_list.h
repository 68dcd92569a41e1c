#pragma once
// A list of at most N entries, in place.

#include <algorithm>
#include <array>
#include <concepts>
#include <cstddef>
#include <span>

namespace tp100 {

/// Entries in order. Copies only those that are there. Never allocates; safe in the real-time
/// thread.
template <class T, std::size_t N>
class BoundedList {
 public:
  static constexpr std::size_t kCapacity = N;

  BoundedList() = default;
  /// The first N of `entries`.
  template <std::convertible_to<std::span<const T>> Entries>
  BoundedList(const Entries& entries) {
    assign(entries);
  }
  BoundedList(const BoundedList& other) { assign(other); }
  BoundedList& operator=(const BoundedList& other) {
    if (this != &other) assign(other);
    return *this;
  }

  /// The first N of `entries`.
  void assign(std::span<const T> entries) {
    size_ = std::min(entries.size(), N);
    std::copy_n(entries.begin(), size_, entries_.begin());
  }
  /// False: the list is full and stays as it is.
  bool push(const T& entry) {
    if (full()) return false;
    entries_[size_++] = entry;
    return true;
  }
  /// `size` entries, at most N; new ones hold whatever was there before.
  void resize(std::size_t size) { size_ = std::min(size, N); }
  void clear() { size_ = 0; }

  std::size_t size() const { return size_; }
  bool empty() const { return size_ == 0; }
  bool full() const { return size_ == N; }
  T& operator[](std::size_t i) { return entries_[i]; }
  const T& operator[](std::size_t i) const { return entries_[i]; }
  T& back() { return entries_[size_ - 1]; }
  const T& back() const { return entries_[size_ - 1]; }
  T* begin() { return entries_.data(); }
  T* end() { return entries_.data() + size_; }
  const T* begin() const { return entries_.data(); }
  const T* end() const { return entries_.data() + size_; }

 private:
  // Before the entries, so that a short list occupies few cache lines.
  std::size_t size_ = 0;
  std::array<T, N> entries_{};
};

}  // namespace tp100
