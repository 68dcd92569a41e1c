#include "server/budget.h"

#include <algorithm>

namespace tp100::server {

bool Budget::charge(double units, HostNs now) {
  left_ = std::min(units_per_s_, left_ + to_s(now - at_ns_) * units_per_s_);
  at_ns_ = now;
  left_ = std::max(-units_per_s_, left_ - units);
  return left_ >= 0.0;
}

bool Budget::full(HostNs now) const {
  return left_ + to_s(now - at_ns_) * units_per_s_ >= units_per_s_;
}

std::shared_ptr<Budget> Budgets::of(const std::string& address) {
  std::shared_ptr<Budget>& found = budgets_[address];
  if (found == nullptr) found = std::make_shared<Budget>(units_per_s_);
  return found;
}

void Budgets::tick(HostNs now) {
  std::erase_if(budgets_, [&](const auto& each) {
    return each.second.use_count() == 1 && each.second->full(now);
  });
}

}  // namespace tp100::server
