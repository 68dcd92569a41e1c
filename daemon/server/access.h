#pragma once
// Who may view and who may command, by Host and Origin of a request and the settings; and how much
// the clients of one address may ask for. Pure, except random_name(); time is passed in.

#include <map>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "core/time.h"

namespace tp100::server {

struct AccessRules {
  std::vector<std::string> hosts;    ///< names besides addresses and localhost
  std::vector<std::string> origins;  ///< besides the page's own, e.g. "https://app.example.org"
};

/// Words of `text` between spaces and commas.
std::vector<std::string> words(std::string_view text);

/// An IPv4 or IPv6 address, without brackets.
bool is_address(const std::string& name);

/// The name or address in `host`, in lower case, without port and brackets; empty: it is not of
/// that form.
std::string host_name(std::string_view host);

/// `host` is an address (which no name server can forge), localhost or a name of the rules, with or
/// without a port.
bool host_allowed(std::string_view host, const AccessRules& rules);

/// For a request without Origin: whether Sec-Fetch-Site shows that it does not come from another
/// site's page. A request without that header does not come from a browser.
bool fetch_site_allowed(std::string_view site);

/// `origin` is the page's own ("http://" + host) or one of the rules. An absent origin is allowed:
/// browsers always send one with WebSockets, so this is not a browser.
bool origin_allowed(std::string_view origin, std::string_view host, const AccessRules& rules);

/// A name that nobody can guess: of a session, or the token of a driver.
std::string random_name();

/// Units that are spent and come back: every request but STOP is charged by its size, its answer
/// and its work. A unit is a small request, or a KiB of one or of its answer: some 10 us of a
/// processor.
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
