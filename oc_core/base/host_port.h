// "HOST:PORT", as options of the network have it.
#pragma once

#include <optional>
#include <string>

namespace ocelli {

struct HostPort {
  std::string host;  ///< a name or an address
  int port = 0;      ///< 1 to 65535
};
/// The last colon stands before the port. Nothing where it is not of that form.
std::optional<HostPort> hostPortFromText(const std::string& text);

}  // namespace ocelli
