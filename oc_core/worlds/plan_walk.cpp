#include "oc_core/worlds/plan_walk.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <limits>
#include <queue>

#include "oc_core/base/check.h"

namespace ocelli {
namespace {

constexpr size_t kNowhere = std::numeric_limits<size_t>::max();
constexpr float kTouch = 1e-3f;  // metres; coordinates are floats of up to some hundred metres

/// Of each cell the portal by which a breadth first search from `start` came to it, and its distance in portals.
struct CellSearch {
  std::vector<size_t> portal;
  std::vector<size_t> distance;
};

CellSearch searchCells(const WalkMap& map, size_t start) {
  CellSearch search{std::vector<size_t>(map.cells.size(), kNowhere), std::vector<size_t>(map.cells.size(), kNowhere)};
  search.distance[start] = 0;
  std::queue<size_t> open;
  open.push(start);
  while (!open.empty()) {
    const size_t cell = open.front();
    open.pop();
    for (size_t p = 0; p < map.portals.size(); ++p) {
      const WalkPortal& portal = map.portals[p];
      if (portal.from != cell && portal.to != cell) {
        continue;
      }
      const size_t other = portal.from == cell ? portal.to : portal.from;
      if (search.distance[other] == kNowhere) {
        search.distance[other] = search.distance[cell] + 1;
        search.portal[other] = p;
        open.push(other);
      }
    }
  }
  return search;
}

}  // namespace

WalkCell levelCell(WalkCellKind kind, const glm::vec2& lower, const glm::vec2& upper, float floor, float height) {
  const glm::vec2 half = (upper - lower) * 0.5f;
  const glm::vec2 center = (lower + upper) * 0.5f;
  WalkCell cell;
  cell.kind = kind;
  cell.center = {center.x, floor, center.y};
  cell.axis = half.x > half.y ? glm::vec3(1, 0, 0) : glm::vec3(0, 0, -1);
  cell.halfLength = std::max(half.x, half.y);
  cell.halfWidth = std::min(half.x, half.y);
  cell.height = height;
  return cell;
}

CellFootprint footprintOf(const WalkCell& cell) {
  const glm::vec2 center(cell.center.x, cell.center.z);
  const glm::vec2 half(std::abs(cell.axis.x) * cell.halfLength + std::abs(cell.axis.z) * cell.halfWidth,
                       std::abs(cell.axis.z) * cell.halfLength + std::abs(cell.axis.x) * cell.halfWidth);
  return {center - half, center + half};
}

Portal uprightOpening(const glm::vec3& place, const glm::vec3& normal, float halfWidth, float height) {
  Portal portal;
  portal.center = place + glm::vec3(0, height / 2, 0);
  portal.normal = normal;
  portal.halfRight = glm::cross(glm::vec3(0, 1, 0), normal) * halfWidth;
  portal.halfUp = {0, height / 2, 0};
  return portal;
}

void openTouchingCells(WalkMap& map, float minWidth) {
  for (uint32_t i = 0; i < map.cells.size(); ++i) {
    for (uint32_t j = i + 1; j < map.cells.size(); ++j) {
      const CellFootprint a = footprintOf(map.cells[i]);
      const CellFootprint b = footprintOf(map.cells[j]);
      for (glm::length_t across = 0; across < 2; ++across) {
        const bool isBeyond = std::abs(a.upper[across] - b.lower[across]) < kTouch;
        const bool isBefore = std::abs(b.upper[across] - a.lower[across]) < kTouch;
        const glm::length_t along = 1 - across;
        const float from = std::max(a.lower[along], b.lower[along]);
        const float to = std::min(a.upper[along], b.upper[along]);
        if (!(isBeyond || isBefore) || to - from < minWidth) {
          continue;
        }
        const WalkCell& first = map.cells[i];
        const WalkCell& second = map.cells[j];
        const bool fromFirst = first.halfLength * first.halfWidth >= second.halfLength * second.halfWidth;
        // Into the first cell, then into the one that it is seen from.
        float sign = isBeyond ? -1.0f : 1.0f;
        sign = fromFirst ? sign : -sign;
        glm::vec3 place(0);
        glm::vec3 normal(0);
        place[across == 0 ? 0 : 2] = isBeyond ? a.upper[across] : a.lower[across];
        place[across == 0 ? 2 : 0] = (from + to) / 2;
        place.y = std::max(first.center.y, second.center.y);
        normal[across == 0 ? 0 : 2] = sign;
        map.portals.push_back({fromFirst ? i : j, fromFirst ? j : i,
                               uprightOpening(place, normal, (to - from) / 2, std::min(first.height, second.height))});
      }
    }
  }
}

CellWay wayThroughCells(const WalkMap& map, size_t from, size_t to) {
  const CellSearch search = searchCells(map, from);
  CellWay way;
  if (search.distance[to] == kNowhere) {
    return way;
  }
  way.cells.push_back(to);
  while (way.cells.back() != from) {
    const size_t cell = way.cells.back();
    const WalkPortal& portal = map.portals[search.portal[cell]];
    way.portals.push_back(search.portal[cell]);
    way.cells.push_back(portal.from == cell ? portal.to : portal.from);
  }
  std::reverse(way.cells.begin(), way.cells.end());
  std::reverse(way.portals.begin(), way.portals.end());
  return way;
}

size_t farthestCell(const WalkMap& map, size_t from) {
  const CellSearch search = searchCells(map, from);
  size_t best = from;
  for (size_t cell = 0; cell < map.cells.size(); ++cell) {
    if (search.distance[cell] != kNowhere && search.distance[cell] > search.distance[best]) {
      best = cell;
    }
  }
  return best;
}

std::vector<glm::vec3> lineOfWay(const WalkMap& map, const CellWay& way, float eyeHeight) {
  std::vector<glm::vec3> line;
  const glm::vec3 up(0, eyeHeight, 0);
  for (size_t i = 0; i < way.cells.size(); ++i) {
    const WalkCell& cell = map.cells[way.cells[i]];
    line.push_back(cell.center + up);
    if (i < way.portals.size()) {
      const Portal& opening = map.portals[way.portals[i]].opening;
      line.push_back(opening.center - opening.halfUp + up);
    }
  }
  return line;
}

}  // namespace ocelli
