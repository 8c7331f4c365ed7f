#include "oc_core/walkable/walk_portals.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <map>
#include <tuple>

#include "oc_core/base/disjoint_sets.h"
#include "oc_core/walkable/walk_box.h"

namespace ocelli {
namespace {

/// A side between two squares of two pieces, seen from the one with the lower number.
struct PortalEdge {
  uint32_t from = 0;  ///< pieces
  uint32_t to = 0;
  uint32_t square = 0;  ///< of `from`
  int side = 0;
  bool isWalkable = true;  ///< else an obstacle stands there
};

std::vector<PortalEdge> edgesBetween(const WalkField& field, const WalkPieces& pieces) {
  std::vector<PortalEdge> edges;
  for (uint32_t i = 0; i < field.squares.size(); ++i) {
    for (int side = 0; side < 4; ++side) {
      const uint32_t k = field.squares[i].next[side];
      if (k != kNoSquare && pieces.of[i] < pieces.of[k]) {
        edges.push_back(
            {pieces.of[i], pieces.of[k], i, side, !field.squares[i].isObstacle && !field.squares[k].isObstacle});
      }
    }
  }
  std::stable_sort(edges.begin(), edges.end(), [](const PortalEdge& a, const PortalEdge& b) {
    return std::tie(a.from, a.to) < std::tie(b.from, b.to);
  });
  return edges;
}

/// The two corners of the grid that an edge runs between.
std::array<std::array<int, 2>, 2> endsOf(const WalkSquare& square, int side) {
  const int x = square.x + (side == 2 ? 1 : 0);
  const int z = square.z + (side == 1 ? 1 : 0);
  const bool alongX = side % 2 == 1;
  return {{{x, z}, {alongX ? x + 1 : x, alongX ? z : z + 1}}};
}

/// Keeps the edges that one can walk through, and those between two of them on one line where an obstacle is hardly
/// wider than the agent, of `agent` squares: what is wider, as the wall below a window, parts an opening.
std::vector<PortalEdge> passable(const WalkField& field, const std::vector<PortalEdge>& edges, int agent) {
  std::map<std::array<int, 3>, PortalEdge> at;  // by side, by where it is across, and along
  for (const PortalEdge& edge : edges) {
    const std::array<int, 2> begin = endsOf(field.squares[edge.square], edge.side)[0];
    const bool alongX = edge.side % 2 == 1;
    at.insert({{edge.side, alongX ? begin[1] : begin[0], alongX ? begin[0] : begin[1]}, edge});
  }
  const int widest = agent + 2;  // walls are out by a square on each side
  const auto reaches = [&](std::array<int, 3> place, int step) {
    for (int n = 0; n <= widest; ++n) {
      const auto found = at.find(place);
      if (found == at.end()) {
        return widest + 1;
      }
      if (found->second.isWalkable) {
        return n;
      }
      place[2] += step;
    }
    return widest + 1;
  };
  std::vector<PortalEdge> kept;
  for (const auto& [place, edge] : at) {
    if (edge.isWalkable || reaches(place, -1) + reaches(place, 1) - 1 <= widest) {
      kept.push_back(edge);
    }
  }
  return kept;
}

/// Groups of edges of one pair of pieces that hang together, in order of their first edges.
std::vector<std::vector<PortalEdge>> openingsIn(const WalkField& field, const std::vector<PortalEdge>& edges) {
  DisjointSets sets(edges.size());
  std::map<std::array<int, 2>, uint32_t> lastAt;
  for (uint32_t e = 0; e < edges.size(); ++e) {
    for (const std::array<int, 2>& end : endsOf(field.squares[edges[e].square], edges[e].side)) {
      const auto [at, isNew] = lastAt.insert({end, e});
      if (!isNew) {
        sets.join(at->second, e);
        at->second = e;
      }
    }
  }
  std::map<uint32_t, std::vector<PortalEdge>> groups;
  for (uint32_t e = 0; e < edges.size(); ++e) {
    groups[sets.least(e)].push_back(edges[e]);
  }
  std::vector<std::vector<PortalEdge>> openings;
  for (auto& [first, group] : groups) {
    openings.push_back(std::move(group));
  }
  return openings;
}

/// From its first edge that one can walk through to its last one.
std::vector<PortalEdge> trimmed(const std::vector<PortalEdge>& run) {
  const auto isWalkable = [](const PortalEdge& edge) { return edge.isWalkable; };
  const auto first = std::find_if(run.begin(), run.end(), isWalkable);
  const auto last = std::find_if(run.rbegin(), run.rend(), isWalkable).base();
  return first < last ? std::vector<PortalEdge>(first, last) : std::vector<PortalEdge>();
}

/// A group that lies on several sides of a piece, as around a corner, has an opening on each: its straight runs of at
/// least that many edges, and of a quarter of all. One that is mostly straight is its longest run; one that is a
/// staircase is one opening.
std::vector<std::vector<PortalEdge>> straightOpenings(const WalkField& field, const std::vector<PortalEdge>& group,
                                                      int least) {
  std::map<std::array<int, 2>, std::vector<std::pair<int, PortalEdge>>> lines;  // by side and by where it is across it
  for (const PortalEdge& edge : group) {
    const std::array<int, 2> at = endsOf(field.squares[edge.square], edge.side)[0];
    const bool alongX = edge.side % 2 == 1;
    lines[{edge.side, alongX ? at[1] : at[0]}].push_back({alongX ? at[0] : at[1], edge});
  }
  const size_t shortest = std::max(static_cast<size_t>(least), group.size() / 4);
  std::vector<std::vector<PortalEdge>> runs;
  std::array<bool, 4> hasSide{};
  for (auto& [line, edges] : lines) {
    std::stable_sort(edges.begin(), edges.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
    for (size_t begin = 0; begin < edges.size();) {
      size_t end = begin + 1;
      while (end < edges.size() && edges[end].first == edges[end - 1].first + 1) {
        ++end;
      }
      std::vector<PortalEdge> run;
      for (size_t e = begin; e < end; ++e) {
        run.push_back(edges[e].second);
      }
      run = trimmed(run);
      if (run.size() >= shortest) {
        hasSide[line[0]] = true;
        runs.push_back(std::move(run));
      }
      begin = end;
    }
  }
  const bool hasCorner = std::count(hasSide.begin(), hasSide.end(), true) > 1;
  if (hasCorner) {
    return runs;
  }
  for (const std::vector<PortalEdge>& run : runs) {
    if (2 * run.size() > group.size()) {
      return {run};
    }
  }
  std::vector<PortalEdge> walkable = group;
  std::erase_if(walkable, [](const PortalEdge& edge) { return !edge.isWalkable; });
  if (walkable.empty()) {
    return {};
  }
  return {walkable};
}

float median(std::vector<float> values) {
  std::nth_element(values.begin(), values.begin() + static_cast<long>(values.size() / 2), values.end());
  return values[values.size() / 2];
}

WalkPortal portalOf(const WalkField& field, const std::vector<PortalEdge>& edges, const std::vector<WalkCell>& cells) {
  glm::dvec2 outward(0);
  std::array<int, 4> bySide{};
  for (const PortalEdge& edge : edges) {
    outward += glm::dvec2(kStepX[edge.side], kStepZ[edge.side]);
    ++bySide[edge.side];
  }
  if (glm::length(outward) < 0.5 * static_cast<double>(edges.size())) {  // it winds: its longest side counts
    const auto side = std::max_element(bySide.begin(), bySide.end()) - bySide.begin();
    outward = {kStepX[side], kStepZ[side]};
  }
  outward = glm::normalize(outward);
  const glm::dvec2 along(-outward.y, outward.x);
  double low = 1e300;
  double high = -1e300;
  double depth = 0;
  std::vector<float> floors;
  std::vector<float> heights;
  const float height = std::min(cells[edges.front().from].height, cells[edges.front().to].height);
  for (const PortalEdge& edge : edges) {
    const WalkSquare& a = field.squares[edge.square];
    const WalkSquare& b = field.squares[a.next[edge.side]];
    for (const std::array<int, 2>& end : endsOf(a, edge.side)) {
      const glm::dvec2 p(field.origin.x + end[0] * static_cast<double>(field.cellSize),
                         field.origin.y + end[1] * static_cast<double>(field.cellSize));
      low = std::min(low, glm::dot(p, along));
      high = std::max(high, glm::dot(p, along));
      depth += glm::dot(p, outward) / 2;
    }
    floors.push_back(std::max(a.floor, b.floor));
    const float ceiling = std::min(a.ceiling, b.ceiling);
    heights.push_back(ceiling == kNoCeiling ? height : std::min(height, ceiling - floors.back()));
  }
  depth /= static_cast<double>(edges.size());
  const glm::dvec2 middle = (low + high) / 2 * along + depth * outward;
  const float halfUp = median(std::move(heights)) / 2;
  WalkPortal portal;
  portal.from = edges.front().from;
  portal.to = edges.front().to;
  portal.opening.center = {static_cast<float>(middle.x), median(std::move(floors)) + halfUp,
                           static_cast<float>(middle.y)};
  portal.opening.normal = {static_cast<float>(-outward.x), 0, static_cast<float>(-outward.y)};
  portal.opening.halfUp = {0, halfUp, 0};
  portal.opening.halfRight =
      glm::cross(glm::vec3(0, 1, 0), portal.opening.normal) * static_cast<float>((high - low) / 2);
  return portal;
}

}  // namespace

std::vector<WalkPortal> portalsOf(const WalkField& field, const WalkLayout& layout, const std::vector<uint32_t>& rooms,
                                  const std::vector<WalkCell>& cells, int radius) {
  const std::vector<PortalEdge> edges = edgesBetween(field, layout.pieces);
  std::vector<WalkPortal> portals;
  std::vector<WalkPortal> narrow;
  const float least = static_cast<float>(2 * radius + 1) * field.cellSize / 2;
  for (size_t begin = 0; begin < edges.size();) {
    size_t end = begin + 1;
    while (end < edges.size() && edges[end].from == edges[begin].from && edges[end].to == edges[begin].to) {
      ++end;
    }
    const std::vector<PortalEdge> pair = passable(
        field, {edges.begin() + static_cast<long>(begin), edges.begin() + static_cast<long>(end)}, 2 * radius + 1);
    for (const std::vector<PortalEdge>& opening : openingsIn(field, pair)) {
      for (const std::vector<PortalEdge>& straight : straightOpenings(field, opening, 2 * radius + 1)) {
        WalkPortal portal = portalOf(field, straight, cells);
        portal.isJoint = rooms[portal.from] == rooms[portal.to];
        (glm::length(portal.opening.halfRight) < 0.99f * least ? narrow : portals).push_back(portal);
      }
    }
    begin = end;
  }
  // The narrow ones that are the only way, the widest first.
  DisjointSets joined(cells.size());
  for (const WalkPortal& portal : portals) {
    joined.join(portal.from, portal.to);
  }
  std::stable_sort(narrow.begin(), narrow.end(), [](const WalkPortal& a, const WalkPortal& b) {
    return glm::length(a.opening.halfRight) > glm::length(b.opening.halfRight);
  });
  for (const WalkPortal& portal : narrow) {
    if (joined.least(portal.from) != joined.least(portal.to)) {
      joined.join(portal.from, portal.to);
      portals.push_back(portal);
    }
  }
  return portals;
}

}  // namespace ocelli
