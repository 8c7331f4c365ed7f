#include "oc_core/scene/walk_map.h"

#include <algorithm>

#include "oc_core/base/disjoint_sets.h"

namespace ocelli {
namespace {

/// Numbers the sets of cells in the order of their first cells.
std::vector<uint32_t> numbersOf(DisjointSets& sets, uint32_t cells) {
  std::vector<uint32_t> numberOfSet(cells, cells);
  std::vector<uint32_t> numbers;
  uint32_t count = 0;
  for (uint32_t cell = 0; cell < cells; ++cell) {
    uint32_t& number = numberOfSet[sets.least(cell)];
    number = number == cells ? count++ : number;
    numbers.push_back(number);
  }
  return numbers;
}

size_t countOf(const std::vector<uint32_t>& numbers) {
  return numbers.empty() ? 0 : size_t{*std::max_element(numbers.begin(), numbers.end())} + 1;
}

}  // namespace

size_t WalkMap::partCount() const {
  return countOf(partOfCell);
}

size_t WalkMap::roomCount() const {
  return countOf(roomOfCell);
}

size_t WalkMap::openingCount() const {
  return static_cast<size_t>(
      std::count_if(portals.begin(), portals.end(), [](const WalkPortal& portal) { return !portal.isJoint; }));
}

void numberCells(WalkMap& map) {
  const auto cells = static_cast<uint32_t>(map.cells.size());
  DisjointSets parts(cells);
  DisjointSets rooms(cells);
  for (const WalkPortal& portal : map.portals) {
    parts.join(portal.from, portal.to);
    if (portal.isJoint) {
      rooms.join(portal.from, portal.to);
    }
  }
  map.partOfCell = numbersOf(parts, cells);
  map.roomOfCell = numbersOf(rooms, cells);
}

std::string nameOfCell(size_t cell) {
  return "cell " + std::to_string(cell);
}

std::string nameOfOpening(size_t portal) {
  return "opening " + std::to_string(portal);
}

WalkMap moved(const WalkMap& map, const glm::mat4& newFromOld) {
  const float scale = newFromOld[0][0];
  WalkMap result = map;
  result.toWalls *= scale;
  for (WalkCell& cell : result.cells) {
    cell.center = glm::vec3(newFromOld * glm::vec4(cell.center, 1));
    cell.halfLength *= scale;
    cell.halfWidth *= scale;
    cell.height *= scale;
    cell.floorRise *= scale;
    for (WalkRing& ring : cell.rings) {
      ring = {ring.along * scale, ring.left * scale, ring.right * scale, ring.ceiling * scale};
    }
  }
  for (WalkPortal& portal : result.portals) {
    portal.opening = moved(portal.opening, newFromOld);
  }
  return result;
}

}  // namespace ocelli
