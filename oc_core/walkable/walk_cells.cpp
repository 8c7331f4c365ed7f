#include "oc_core/walkable/walk_cells.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <utility>

#include "oc_core/walkable/walk_box.h"
#include "oc_core/walkable/walk_extent.h"
#include "oc_core/walkable/walk_rings.h"

namespace ocelli {
namespace {

float quantile(std::vector<float> values, double share) {
  const auto at = static_cast<long>(share * static_cast<double>(values.size() - 1));
  std::nth_element(values.begin(), values.begin() + at, values.end());
  return values[at];
}

/// 0 where there is neither a ceiling nor anything beside it.
float heightOf(const WalkField& field, const std::vector<uint32_t>& squares, float agentHeight) {
  std::vector<float> ceilings;
  std::vector<float> tops;
  for (const uint32_t i : squares) {
    const WalkSquare& square = field.squares[i];
    if (square.isObstacle) {
      continue;
    }
    if (square.ceiling != kNoCeiling) {
      ceilings.push_back(square.ceiling - square.floor);
    }
    if (square.wallTop - square.floor > agentHeight / 2) {
      tops.push_back(square.wallTop - square.floor);
    }
  }
  if (2 * ceilings.size() > squares.size()) {
    return quantile(std::move(ceilings), 0.25);
  }
  return tops.empty() ? 0 : std::max(agentHeight, quantile(std::move(tops), 0.5));
}

/// Gives each cell without a height that of the neighbour with the longest border that has one, and so on; twice the
/// agent's where there is none.
void fillHeights(const WalkField& field, const WalkLayout& layout, float agentHeight, std::vector<float>& heights) {
  const std::vector<PieceBorder> borders = bordersOf(field, layout.pieces.of);
  for (bool changed = true; changed;) {
    changed = false;
    std::vector<float> filled = heights;
    std::vector<size_t> longest(heights.size(), 0);
    for (const PieceBorder& border : borders) {
      for (const auto& [to, from] : {std::pair(border.a, border.b), std::pair(border.b, border.a)}) {
        if (heights[to] == 0 && heights[from] != 0 && border.length > longest[to]) {
          longest[to] = border.length;
          filled[to] = heights[from];
          changed = true;
        }
      }
    }
    heights = std::move(filled);
  }
  for (float& height : heights) {
    height = height == 0 ? 2 * agentHeight : height;
  }
}

/// How much the floor rises along the box, by least squares; what rounding makes is none.
float riseOf(const WalkField& field, const std::vector<uint32_t>& squares, const WalkBox& box) {
  double count = 0;
  double sumU = 0;
  double sumY = 0;
  for (const uint32_t i : squares) {
    if (!field.squares[i].isObstacle) {
      count += 1;
      sumU += glm::dot(middleOf(field, field.squares[i]) - box.center, box.axis);
      sumY += field.squares[i].floor;
    }
  }
  double uu = 0;
  double uy = 0;
  for (const uint32_t i : squares) {
    if (!field.squares[i].isObstacle) {
      const double u = glm::dot(middleOf(field, field.squares[i]) - box.center, box.axis) - sumU / count;
      uu += u * u;
      uy += u * (field.squares[i].floor - sumY / count);
    }
  }
  const double rise = uu > 0 ? uy / uu * 2 * box.halfLength : 0;
  return std::abs(rise) < field.cellSize / 2 ? 0 : static_cast<float>(rise);
}

/// Turns the box of a room so that its axis, not its side, runs up a slope.
void followSlope(const WalkField& field, const std::vector<uint32_t>& squares, WalkBox& box) {
  WalkBox turned = box;
  turned.axis = box.right();
  std::swap(turned.halfLength, turned.halfWidth);
  if (std::abs(riseOf(field, squares, turned)) > std::abs(riseOf(field, squares, box)) + field.cellSize) {
    box = turned;
  }
}

/// The place to stand that is nearest to the middle of a box; any where there is none.
const WalkSquare& nearestPlace(const WalkField& field, const std::vector<uint32_t>& squares, const WalkBox& box) {
  const WalkSquare* best = &field.squares[squares.front()];
  double least = 1e300;
  for (const uint32_t i : squares) {
    const glm::dvec2 off = middleOf(field, field.squares[i]) - box.center;
    const double away = glm::dot(off, off);
    if (!field.squares[i].isObstacle && away < least) {
      least = away;
      best = &field.squares[i];
    }
  }
  return *best;
}

/// Makes a box smaller, around a place to stand, where its middle is none.
void moveOffObstacle(const WalkField& field, const WalkSquare& place, WalkBox& box) {
  const glm::dvec2 off = middleOf(field, place) - box.center;
  const double u = std::abs(glm::dot(off, box.axis));
  const double v = std::abs(glm::dot(off, box.right()));
  if (std::max(u, v) > field.cellSize && u < box.halfLength / 2 && v < box.halfWidth / 2) {
    box.center = box.center + off;
    box.halfLength -= u;
    box.halfWidth -= v;
  }
}

WalkCell cellOf(const WalkField& field, const std::vector<uint32_t>& squares, const WalkShape& shape, float height) {
  WalkBox box = boxAround(field, squares, givenAxis(shape)).box;
  const WalkSquare& place = nearestPlace(field, squares, box);
  if (!shape.isTunnel) {
    moveOffObstacle(field, place, box);
    followSlope(field, squares, box);
  }
  WalkCell cell;
  cell.kind = shape.isTunnel ? WalkCellKind::kTunnel : WalkCellKind::kRoom;
  cell.center = {static_cast<float>(box.center.x), place.floor, static_cast<float>(box.center.y)};
  cell.axis = {static_cast<float>(box.axis.x), 0, static_cast<float>(box.axis.y)};
  cell.halfLength = static_cast<float>(box.halfLength);
  cell.halfWidth = static_cast<float>(box.halfWidth);
  cell.height = height;
  cell.floorRise = riseOf(field, squares, box);
  if (shape.isTunnel) {
    cell.rings = ringsOf(field, squares, box, cell.height);
  }
  return cell;
}

}  // namespace

std::vector<WalkCell> cellsOf(const WalkField& field, const WalkLayout& layout, float agentHeight) {
  const std::vector<std::vector<uint32_t>> squares = squaresOf(layout.pieces);
  std::vector<float> heights;
  for (uint32_t piece = 0; piece < layout.pieces.count; ++piece) {
    heights.push_back(heightOf(field, squares[piece], agentHeight));
  }
  fillHeights(field, layout, agentHeight, heights);
  std::vector<WalkCell> cells;
  for (uint32_t piece = 0; piece < layout.pieces.count; ++piece) {
    cells.push_back(cellOf(field, squares[piece], layout.shapes[piece], heights[piece]));
  }
  return cells;
}

}  // namespace ocelli
