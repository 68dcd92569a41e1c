#pragma once
// Who may view and who may command: checks Host and Origin of a request against the settings. Pure,
// except random_name().

#include <string>
#include <string_view>
#include <vector>

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

}  // namespace tp100::server
