#include "oc_core/walkable/walk_rectangles.h"

#include <algorithm>
#include <cmath>

#include "oc_core/walkable/walk_box.h"
#include "oc_core/walkable/walk_extent.h"

namespace ocelli {
namespace {

// Area shared by box and piece, of the area of either: of rooms, of tunnels, whose rings follow what is left, and of
// all whose box is turned.
constexpr double kRoomFits = 0.75;
constexpr double kTunnelFits = 0.6;
constexpr double kTurnedFits = 0.8;
constexpr double kThinLeftOver = 0.3;  // of the shorter side of the rectangle beside it
constexpr int kMaxRectangles = 12;     // of one piece

struct SquareRectangle {
  SquareRange x;
  SquareRange z;

  int area() const { return x.length() * z.length(); }
  int shorter() const { return std::min(x.length(), z.length()); }
};

/// The largest rectangle of squares that are in the list, by histograms of each row. Squares over each other count
/// once.
SquareRectangle largestRectangle(const WalkField& field, const std::vector<uint32_t>& squares) {
  SquareRectangle whole{{1 << 30, -(1 << 30)}, {1 << 30, -(1 << 30)}};
  for (const uint32_t i : squares) {
    const WalkSquare& square = field.squares[i];
    whole.x = {std::min(whole.x.first, square.x), std::max(whole.x.last, square.x)};
    whole.z = {std::min(whole.z.first, square.z), std::max(whole.z.last, square.z)};
  }
  const int width = whole.x.length();
  std::vector<uint8_t> isIn(static_cast<size_t>(whole.area()), 0);
  for (const uint32_t i : squares) {
    const WalkSquare& square = field.squares[i];
    isIn[static_cast<size_t>(square.z - whole.z.first) * width + (square.x - whole.x.first)] = 1;
  }
  SquareRectangle best;
  std::vector<int> above(width + 1, 0);  // free squares up from this row; the last stays 0
  std::vector<int> stack;
  for (int z = 0; z < whole.z.length(); ++z) {
    for (int x = 0; x < width; ++x) {
      above[x] = isIn[static_cast<size_t>(z) * width + x] != 0 ? above[x] + 1 : 0;
    }
    stack.clear();
    for (int x = 0; x <= width; ++x) {
      while (!stack.empty() && above[stack.back()] >= above[x]) {
        const int height = above[stack.back()];
        stack.pop_back();
        const int first = stack.empty() ? 0 : stack.back() + 1;
        if (height * (x - first) > best.area()) {
          best = {{first + whole.x.first, x - 1 + whole.x.first}, {z - height + 1 + whole.z.first, z + whole.z.first}};
        }
      }
      stack.push_back(x);
    }
  }
  return best;
}

}  // namespace

bool fitsBox(const WalkField& field, const std::vector<uint32_t>& squares, const WalkShape& shape) {
  // Tunnels shorter than wide are what is between two crossings.
  if (shape.isTunnel && static_cast<double>(squares.size()) < widthOf(shape.halfWidth) * widthOf(shape.halfWidth)) {
    return true;
  }
  const BoxFit fit = boxAround(field, squares, givenAxis(shape));
  const bool isTurned = std::min(std::abs(fit.box.axis.x), std::abs(fit.box.axis.y)) > 1e-6;
  return fit.shared >= (isTurned ? kTurnedFits : shape.isTunnel ? kTunnelFits : kRoomFits);
}

namespace {

/// Labels for the squares of one piece, from `next` on.
void divide(const WalkField& field, const std::vector<uint32_t>& piece, int radius, std::vector<uint32_t>& labels,
            uint32_t& next) {
  std::vector<uint32_t> left = piece;
  for (int n = 0; n < kMaxRectangles && !left.empty(); ++n) {
    const SquareRectangle rectangle = largestRectangle(field, left);
    const uint32_t label = next++;
    std::vector<uint32_t> rest;
    for (const uint32_t i : left) {
      const WalkSquare& square = field.squares[i];
      const bool isInside = square.x >= rectangle.x.first && square.x <= rectangle.x.last &&
                            square.z >= rectangle.z.first && square.z <= rectangle.z.last;
      labels[i] = label;
      if (!isInside) {
        rest.push_back(i);
      }
    }
    if (rectangle.shorter() <= 2 * radius + 1) {
      return;  // what is left stays together
    }
    if (!rest.empty()) {
      const uint32_t restLabel = next++;
      for (const uint32_t i : rest) {
        labels[i] = restLabel;
      }
    }
    left = std::move(rest);
  }
}

}  // namespace

WalkLayout rectangularLayout(const WalkField& field, const WalkLayout& layout, int radius) {
  const std::vector<std::vector<uint32_t>> squares = squaresOf(layout.pieces);
  std::vector<uint32_t> labels = layout.pieces.of;
  std::vector<WalkShape> shapeOf = layout.shapes;  // by label
  std::vector<uint8_t> isDivided(layout.pieces.count, 0);
  uint32_t next = layout.pieces.count;
  for (uint32_t piece = 0; piece < layout.pieces.count; ++piece) {
    if (!fitsBox(field, squares[piece], layout.shapes[piece])) {
      isDivided[piece] = 1;
      divide(field, squares[piece], radius, labels, next);
      WalkShape room = layout.shapes[piece];
      room.isTunnel = false;
      room.isOfWays = false;
      shapeOf.resize(next, room);
    }
  }
  const WalkPieces raw = connectedPieces(field, labels);
  std::vector<uint32_t> labelOf(raw.count);
  std::vector<uint32_t> oldPiece(raw.count);
  for (size_t i = 0; i < labels.size(); ++i) {
    labelOf[raw.of[i]] = labels[i];
    oldPiece[raw.of[i]] = layout.pieces.of[i];
  }
  // What is thin beside its widest neighbour in the same piece.
  const std::vector<uint16_t> thickness = thicknesses(field, raw);
  std::vector<uint16_t> widestBeside(raw.count, 0);
  for (const PieceBorder& border : bordersOf(field, raw.of)) {
    if (oldPiece[border.a] == oldPiece[border.b]) {
      widestBeside[border.a] = std::max(widestBeside[border.a], thickness[border.b]);
      widestBeside[border.b] = std::max(widestBeside[border.b], thickness[border.a]);
    }
  }
  const std::vector<size_t> standing = standingSizes(field, raw);
  std::vector<uint8_t> isThin(raw.count, 0);
  for (uint32_t piece = 0; piece < raw.count; ++piece) {
    const bool hasNoPlace =
        standing[piece] < static_cast<size_t>(2 * radius + 1) * (2 * radius + 1) && !shapeOf[labelOf[piece]].isTunnel;
    const bool isLeftOver = isDivided[oldPiece[piece]] != 0 && widestBeside[piece] > 0 &&
                            thickness[piece] <= std::max<double>(radius, kThinLeftOver * widestBeside[piece]);
    isThin[piece] = hasNoPlace || isLeftOver;
  }
  WalkLayout result;
  result.pieces = absorbed(field, raw, isThin);
  result.shapes.resize(result.pieces.count);
  for (const bool thinOnes : {true, false}) {
    for (size_t i = 0; i < labels.size(); ++i) {
      if ((isThin[raw.of[i]] != 0) == thinOnes) {
        result.shapes[result.pieces.of[i]] = shapeOf[labelOf[raw.of[i]]];
      }
    }
  }
  return result;
}

}  // namespace ocelli
