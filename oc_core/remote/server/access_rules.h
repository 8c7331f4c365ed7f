// Who may talk to the server of remote visualisation: names of hosts, origins of pages, and the token.
//
// A page of another site can make a browser connect to this server. Two checks keep it away: the name by which the
// browser knows this server (`Host`) must be one of this computer, as a name of the attacker's that leads here (DNS
// rebinding) is not; and the page that opens a WebSocket (`Origin`) must be the one that this server served. Addresses
// are no names of an attacker's. The port is not compared: `ssh -L` may forward another one.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace ocelli {

struct AccessRules {
  std::string token;               ///< what the page's address must hold; empty: nothing
  std::vector<std::string> names;  ///< of this computer, besides "localhost" and addresses
};

/// Of a header `Host`: "NAME" or "NAME:PORT", where NAME is localhost, an IPv4 address, an IPv6 address in brackets, or
/// one of `names` in any case of letters.
bool isHostAllowed(std::string_view host, const std::vector<std::string>& names);

/// Of a header `Origin`: the page of `http://HOST`. Programs other than browsers send none: empty is allowed.
bool isOriginAllowed(std::string_view origin, std::string_view host);

/// Takes the same time for all that is given of the same length. An empty `wanted` is no token: everything is right.
bool isTokenRight(std::string_view given, std::string_view wanted);

/// The value of "token=..." in what stands behind the "?" of an address; empty where there is none, or more than one.
std::string tokenOfQuery(std::string_view query);

/// 32 hexadecimal digits: 128 bits of the system's generator. Throws WorkError where that fails.
std::string newToken();

/// As its administrator calls it; empty where it has no name.
std::string nameOfThisComputer();

/// The first line of a file: 16 to 128 letters, digits, "-" and "_". Throws InputError.
std::string readTokenFile(const std::filesystem::path& path);

}  // namespace ocelli
