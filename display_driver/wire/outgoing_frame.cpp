#include "display_driver/wire/outgoing_frame.h"

#include <algorithm>
#include <iterator>

namespace ocelli {

std::optional<std::vector<int>> unite(const std::optional<std::vector<int>>& a,
                                      const std::optional<std::vector<int>>& b) {
  if (!a || !b) {
    return std::nullopt;
  }
  std::vector<int> both = *a;
  both.insert(both.end(), b->begin(), b->end());
  std::ranges::sort(both);
  both.erase(std::unique(both.begin(), both.end()), both.end());
  return both;
}

wire::Present toWire(const Presentation& presentation) {
  const RotationPhase at = presentation.at.value_or(RotationPhase{});
  return {.refresh = at.refresh,
          .slice = static_cast<uint16_t>(at.slice),
          .atNextRefresh = !presentation.at,
          .tearWhenLate = presentation.tearWhenLate,
          .coarseWhenLate = presentation.coarseWhenLate};
}

}  // namespace ocelli
