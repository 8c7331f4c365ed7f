#include "oc_core/base/host_port.h"

#include <charconv>

namespace ocelli {

std::optional<HostPort> hostPortFromText(const std::string& text) {
  constexpr int kMaxPort = 65535;
  const size_t colon = text.rfind(':');
  if (colon == std::string::npos || colon == 0) {
    return std::nullopt;
  }
  HostPort place{text.substr(0, colon)};
  const char* const end = text.data() + text.size();
  const auto read = std::from_chars(text.data() + colon + 1, end, place.port);
  const bool isPort = read.ec == std::errc() && read.ptr == end && place.port >= 1 && place.port <= kMaxPort;
  return isPort ? std::optional(place) : std::nullopt;
}

}  // namespace ocelli
