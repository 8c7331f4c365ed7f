#include "oc_core/walkable/walk_links.h"

#include <cmath>
#include <glm/geometric.hpp>
#include <utility>
#include <vector>

namespace ocelli {
namespace {

/// Of two portals through a tunnel, the one that leads from the first one's cell to the second one's.
WalkPortal through(const WalkPortal& in, const WalkPortal& out) {
  const Portal& narrower =
      glm::length(in.opening.halfRight) <= glm::length(out.opening.halfRight) ? in.opening : out.opening;
  const Portal& lower = glm::length(in.opening.halfUp) <= glm::length(out.opening.halfUp) ? in.opening : out.opening;
  WalkPortal portal{in.from, out.to, in.opening};
  portal.opening.halfRight = narrower.halfRight;
  portal.opening.normal = narrower.normal;
  portal.opening.halfUp = lower.halfUp;
  const glm::vec3 inFloor = in.opening.center - in.opening.halfUp;
  const glm::vec3 outFloor = out.opening.center - out.opening.halfUp;
  portal.opening.center = (inFloor + outFloor) * 0.5f + lower.halfUp;
  return portal;
}

}  // namespace

void dissolveShortTunnels(WalkMap& map, float shortest) {
  constexpr uint32_t kGone = 0xffffffffU;
  std::vector<std::vector<size_t>> portalsOfCell(map.cells.size());
  for (size_t p = 0; p < map.portals.size(); ++p) {
    portalsOfCell[map.portals[p].from].push_back(p);
    portalsOfCell[map.portals[p].to].push_back(p);
  }
  std::vector<uint32_t> numbers(map.cells.size(), 0);
  std::vector<uint8_t> isPortalGone(map.portals.size(), 0);
  for (uint32_t c = 0; c < map.cells.size(); ++c) {
    const WalkCell& cell = map.cells[c];
    if (cell.kind != WalkCellKind::kTunnel || 2 * cell.halfLength >= shortest || portalsOfCell[c].size() != 2) {
      continue;
    }
    const size_t first = portalsOfCell[c][0];
    const size_t second = portalsOfCell[c][1];
    const WalkPortal in = map.portals[first].to == c ? map.portals[first] : map.portals[first].reversed();
    const WalkPortal out = map.portals[second].from == c ? map.portals[second] : map.portals[second].reversed();
    const auto isAtEnd = [&](const WalkPortal& portal) {
      return std::abs(glm::dot(portal.opening.normal, cell.axis)) > 0.9f;
    };
    if (in.from == out.to || !isAtEnd(in) || !isAtEnd(out)) {
      continue;
    }
    map.portals[first] = through(in, out);
    isPortalGone[second] = 1;
    for (size_t& p : portalsOfCell[out.to]) {
      p = p == second ? first : p;
    }
    numbers[c] = kGone;
  }
  std::vector<WalkCell> cells;
  for (uint32_t c = 0; c < map.cells.size(); ++c) {
    if (numbers[c] != kGone) {
      numbers[c] = static_cast<uint32_t>(cells.size());
      cells.push_back(std::move(map.cells[c]));
    }
  }
  std::vector<WalkPortal> portals;
  for (size_t p = 0; p < map.portals.size(); ++p) {
    if (isPortalGone[p] == 0) {
      portals.push_back(
          {numbers[map.portals[p].from], numbers[map.portals[p].to], map.portals[p].opening, map.portals[p].isJoint});
    }
  }
  map.cells = std::move(cells);
  map.portals = std::move(portals);
}

}  // namespace ocelli
