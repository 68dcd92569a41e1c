#include "server/access.h"

#include <arpa/inet.h>

#include <algorithm>
#include <random>

#include "text/format.h"

namespace tp100::server {
namespace {

using text::lower;

bool is_port(std::string_view text) {
  return !text.empty() && text.size() <= 5 &&
         text.find_first_not_of("0123456789") == std::string_view::npos;
}

/// The host without its port; empty if it is not of that form.
std::string_view name_of(std::string_view host) {
  if (!host.empty() && host.front() == '[') {
    const std::size_t end = host.find(']');
    if (end == std::string_view::npos) return {};
    const std::string_view rest = host.substr(end + 1);
    if (!rest.empty() && (rest.front() != ':' || !is_port(rest.substr(1)))) return {};
    return host.substr(1, end - 1);
  }
  const std::size_t colon = host.find(':');
  if (colon == std::string_view::npos) return host;
  return is_port(host.substr(colon + 1)) ? host.substr(0, colon) : std::string_view();
}

bool contains(const std::vector<std::string>& list, const std::string& wanted) {
  return std::ranges::any_of(list, [&](const auto& each) { return lower(each) == wanted; });
}

}  // namespace

std::vector<std::string> words(std::string_view text) {
  std::vector<std::string> out(1);
  for (const char c : text) {
    if (c != ' ' && c != ',' && c != '\t') {
      out.back() += c;
    } else if (!out.back().empty()) {
      out.emplace_back();
    }
  }
  if (out.back().empty()) out.pop_back();
  return out;
}

bool is_address(const std::string& name) {
  unsigned char buffer[16];
  return ::inet_pton(AF_INET, name.c_str(), buffer) == 1 ||
         ::inet_pton(AF_INET6, name.c_str(), buffer) == 1;
}

std::string host_name(std::string_view host) { return lower(name_of(host)); }

bool host_allowed(std::string_view host, const AccessRules& rules) {
  const std::string name = host_name(host);
  if (name.empty()) return false;
  return name == "localhost" || is_address(name) || contains(rules.hosts, name);
}

bool fetch_site_allowed(std::string_view site) {
  const std::string value = lower(site);
  return value != "cross-site" && value != "same-site";
}

bool origin_allowed(std::string_view origin, std::string_view host, const AccessRules& rules) {
  if (origin.empty()) return true;
  const std::string wanted = lower(origin);
  return wanted == "http://" + lower(host) || wanted == "https://" + lower(host) ||
         contains(rules.origins, wanted);
}

std::string random_name() {
  std::random_device random;
  std::string out;
  for (int i = 0; i < 4; ++i) out += text::format("%08x", random());
  return out;
}

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
