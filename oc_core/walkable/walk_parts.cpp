#include "oc_core/walkable/walk_parts.h"

#include "oc_core/base/disjoint_sets.h"

namespace ocelli {

std::vector<uint32_t> connectedParts(const WalkMap& map) {
  const auto cells = static_cast<uint32_t>(map.cells.size());
  DisjointSets sets(cells);
  for (const WalkPortal& portal : map.portals) {
    sets.join(portal.from, portal.to);
  }
  std::vector<uint32_t> numbers(cells, cells);
  std::vector<uint32_t> parts;
  uint32_t count = 0;
  for (uint32_t cell = 0; cell < cells; ++cell) {
    uint32_t& number = numbers[sets.least(cell)];
    if (number == cells) {
      number = count++;
    }
    parts.push_back(number);
  }
  return parts;
}

}  // namespace ocelli
