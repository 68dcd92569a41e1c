#pragma once
// What the clients of one address may ask for: every request is charged by its size, its answer and
// its work. STOP is never charged. Pure; one thread; time is passed in.

#include <map>
#include <memory>
#include <string>

#include "core/time.h"

namespace tp100::server {

/// Units that are spent and come back. A unit is a small request, or a KiB of one or of its answer:
/// some 10 us of a processor.
class Budget {
 public:
  static constexpr double kBytesPerUnit = 1024.0;

  explicit Budget(double units_per_s) : units_per_s_(units_per_s), left_(units_per_s) {}

  /// Spends `units`, at most a second's worth in advance. False: none are left.
  bool charge(double units, HostNs now);
  /// Whether everything has come back.
  bool full(HostNs now) const;

 private:
  double units_per_s_;
  double left_;
  HostNs at_ns_ = 0;
};

/// One budget for each address, whatever the number of its connections.
class Budgets {
 public:
  static constexpr double kUnitsPerS = 4000.0;  ///< of an address, usually
  static constexpr double kOwnPerS = 200.0;  ///< of each viewer, whatever others of its address do

  explicit Budgets(double units_per_s = kUnitsPerS) : units_per_s_(units_per_s) {}
  /// `address`: an IPv4 address, or the first 64 bits of an IPv6 address.
  std::shared_ptr<Budget> of(const std::string& address);
  /// Call it from time to time: forgets what nobody uses and is full.
  void tick(HostNs now);

 private:
  double units_per_s_;
  std::map<std::string, std::shared_ptr<Budget>> budgets_;
};

}  // namespace tp100::server
