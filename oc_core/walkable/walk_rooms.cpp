#include "oc_core/walkable/walk_rooms.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <utility>

#include "oc_core/base/disjoint_sets.h"
#include "oc_core/walkable/walk_box.h"
#include "oc_core/walkable/walk_extent.h"
#include "oc_core/walkable/walk_rectangles.h"

namespace ocelli {
namespace {

constexpr double kMostlyInside = 0.75;  // of a piece, that the box of both must cover; as of rooms in their boxes

double shareInside(const WalkField& field, const std::vector<uint32_t>& squares, const WalkBox& box) {
  const auto isInside = [&](uint32_t i) {
    const glm::dvec2 off = middleOf(field, field.squares[i]) - box.center;
    return std::abs(glm::dot(off, box.axis)) < box.halfLength && std::abs(glm::dot(off, box.right())) < box.halfWidth;
  };
  return static_cast<double>(std::count_if(squares.begin(), squares.end(), isInside)) /
         static_cast<double>(squares.size());
}

/// How much larger in squares the box of both is than that of the larger alone: what the smaller brings, where it is as
/// wide as the tunnel that it goes on in.
double growthOfBox(const WalkField& field, const std::vector<uint32_t>& larger, const WalkBox& both,
                   const glm::dvec2& axis) {
  const WalkBox alone = boxAround(field, larger, axis).box;
  return 4 * (both.halfLength * both.halfWidth - alone.halfLength * alone.halfWidth) /
         (static_cast<double>(field.cellSize) * field.cellSize);
}

/// Joins pairs, each piece once at most, the longest joints first. Whether there was one.
bool mergeOnce(const JointSearch& search, std::vector<PieceBorder> joints, WalkLayout& layout) {
  std::stable_sort(joints.begin(), joints.end(),
                   [](const PieceBorder& p, const PieceBorder& q) { return p.length > q.length; });
  const WalkField& field = search.field;
  const std::vector<uint8_t> isCrossing = crossingsOfWays(search, layout);
  const std::vector<std::vector<uint32_t>> squares = squaresOf(layout.pieces);
  std::vector<uint32_t> owner(layout.pieces.count);
  std::vector<uint8_t> isJoined(layout.pieces.count, 0);
  for (uint32_t piece = 0; piece < layout.pieces.count; ++piece) {
    owner[piece] = piece;
  }
  bool changed = false;
  for (const PieceBorder& joint : joints) {
    const bool isALarger = squares[joint.a].size() >= squares[joint.b].size();
    const uint32_t larger = isALarger ? joint.a : joint.b;
    const uint32_t smaller = isALarger ? joint.b : joint.a;
    if (isJoined[larger] != 0 || isJoined[smaller] != 0 || layout.shapes[smaller].isTunnel ||
        isCrossing[smaller] != 0 || (layout.shapes[larger].isOfWays && layout.shapes[smaller].isOfWays)) {
      continue;
    }
    std::vector<uint32_t> both = squares[larger];
    both.insert(both.end(), squares[smaller].begin(), squares[smaller].end());
    const glm::dvec2 axis = givenAxis(layout.shapes[larger]);
    const WalkBox box = boxAround(field, both, axis).box;
    // A street is as wide as the square that it leads to, or no part of it.
    if (layout.shapes[larger].isTunnel &&
        kMostlyInside * growthOfBox(field, squares[larger], box, axis) > static_cast<double>(squares[smaller].size())) {
      continue;
    }
    if (fitsBox(field, both, layout.shapes[larger]) && shareInside(field, squares[smaller], box) >= kMostlyInside) {
      isJoined[larger] = isJoined[smaller] = 1;
      owner[smaller] = larger;
      changed = true;
    }
  }
  if (!changed) {
    return false;
  }
  std::vector<uint32_t> labels = layout.pieces.of;
  for (uint32_t& label : labels) {
    label = owner[label];
  }
  WalkLayout merged;
  merged.pieces = connectedPieces(field, labels);
  merged.shapes.resize(merged.pieces.count);
  for (size_t i = 0; i < labels.size(); ++i) {
    merged.shapes[merged.pieces.of[i]] = layout.shapes[labels[i]];
  }
  layout = std::move(merged);
  return true;
}

}  // namespace

WalkLayout mergedLayout(const JointSearch& search, const WalkLayout& layout) {
  WalkLayout merged = layout;
  while (mergeOnce(search, straightJoints(search, merged), merged)) {
  }
  while (mergeOnce(search, jointBorders(search, merged), merged)) {
  }
  return merged;
}

std::vector<uint32_t> roomsOf(const JointSearch& search, const WalkLayout& layout) {
  DisjointSets rooms(layout.pieces.count);
  for (const PieceBorder& joint : jointBorders(search, layout)) {
    rooms.join(joint.a, joint.b);
  }
  std::vector<uint32_t> numbers(layout.pieces.count);
  for (uint32_t piece = 0; piece < layout.pieces.count; ++piece) {
    numbers[piece] = rooms.least(piece);
  }
  return numbers;
}

}  // namespace ocelli
