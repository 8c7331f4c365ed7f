#include "oc_core/base/host_port.h"

#include "oc_core/base/number_text.h"

namespace ocelli {

std::optional<HostPort> hostPortFromText(const std::string& text) {
  constexpr int kMaxPort = 65535;
  const size_t colon = text.rfind(':');
  if (colon == std::string::npos || colon == 0) {
    return std::nullopt;
  }
  HostPort place{text.substr(0, colon)};
  place.port = numberFromText<int>(std::string_view(text).substr(colon + 1)).value_or(0);
  return place.port >= 1 && place.port <= kMaxPort ? std::optional(place) : std::nullopt;
}

}  // namespace ocelli
