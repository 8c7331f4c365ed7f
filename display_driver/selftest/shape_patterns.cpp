// Patterns of known shape: axis, orientation, box, sphere.
#include <glm/geometric.hpp>

#include "display_driver/selftest/pattern_canvas.h"
#include "display_driver/selftest/pattern_letters.h"
#include "display_driver/selftest/pattern_volumes.h"
#include "oc_core/base/conventions.h"

namespace ocelli {
namespace {

constexpr double kSmallRingRadius = 0.125;
constexpr double kSmallRingHeight = 0.75;  // of half the height

constexpr double kLetterRadius = 0.95;
constexpr double kLetterCellHeight = 0.1;  // of half the height
constexpr double kLetterCellWidth = 0.14;  // of half the height, around the cylinder
constexpr double kWidestLetterDegrees = 80;
constexpr double kTopHeight = 0.85;  // of half the height
constexpr double kTopWidth = 1.6;    // radii
constexpr int kTopColumns = 3 * kLetterColumns + 2;

constexpr double kBoxSide = 0.6;
constexpr double kMaxOfHeight = 0.9;
constexpr int kSphereStepDegrees = 30;

/// A letter that is read from outside at an angle about the axis.
struct SideLetter {
  char letter;
  double radians;
  bool above;
};
constexpr SideLetter kSideLetters[] = {
    {'R', 0, true}, {'F', kPi / 2, true}, {'L', kPi, false}, {'B', 3 * kPi / 2, false}};

double letterCellWidth(const PatternGrid& grid) {
  // A cell is at least one slice wide.
  const double least = 1.05 * grid.geometry().stepRadians() * kLetterRadius;
  const double most = kWidestLetterDegrees * kPi / 180 * kLetterRadius / kLetterColumns;
  return std::min(most, std::max(least, kLetterCellWidth * std::min(1.0, grid.geometry().halfHeight())));
}

bool sideLetterLit(const PatternGrid& grid, const PatternVoxel& v, double cellWidth) {
  const double half = grid.geometry().halfHeight();
  for (const SideLetter& side : kSideLetters) {
    // Who stands outside sees angles grow to the left.
    const double right = -std::remainder(grid.radiansOf(v.sector) - side.radians, 2 * kPi) * kLetterRadius;
    const double down = (side.above ? 0.45 : -0.45) * half - grid.heightOf(v.row);
    const int column = static_cast<int>(std::floor(right / cellWidth + kLetterColumns / 2.0));
    const int row = static_cast<int>(std::floor(down / (kLetterCellHeight * half) + kLetterRows / 2.0));
    if (letterCell(side.letter, column, row)) {
      return true;
    }
  }
  return false;
}

bool topLetterLit(const PatternGrid& grid, const PatternVoxel& v) {
  const glm::dvec3 p = grid.geometry().voxelCenter(v.slice, v.column, v.row);
  const double cell = kTopWidth / kTopColumns;
  const int column = static_cast<int>(std::floor(p.x / cell + kTopColumns / 2.0));
  const int row = static_cast<int>(std::floor(p.z / cell + kLetterRows / 2.0));
  if (column < 0 || column >= kTopColumns) {
    return false;
  }
  return letterCell("TOP"[column / (kLetterColumns + 1)], column % (kLetterColumns + 1), row);
}

/// Whether the outline of the square with these half sides passes through the cell of a ring in a sector.
bool squarePasses(const PatternGrid& grid, const PatternVoxel& v, double side) {
  const double step = grid.geometry().stepRadians();
  const auto outlineAt = [&](double radians) {
    return side / std::max(std::abs(std::cos(radians)), std::abs(std::sin(radians)));
  };
  const double from = grid.radiansOf(v.sector) - step / 2;
  const auto [least, most] = std::minmax({outlineAt(from), outlineAt(from + step / 2), outlineAt(from + step)});
  return v.ring >= grid.ringAt(least) && v.ring <= grid.ringAt(most);
}

/// Whether the circle of that radius around the middle of the screen passes through the cell of a ring and row.
bool circlePasses(const PatternGrid& grid, const PatternVoxel& v, double radius) {
  const double halfColumn = grid.geometry().columnWidth() / 2;
  const double halfRow = grid.geometry().rowHeight() / 2;
  const double r = grid.radiusOf(v.ring);
  const double y = std::abs(grid.heightOf(v.row));
  return std::hypot(std::max(0.0, r - halfColumn), std::max(0.0, y - halfRow)) <= radius &&
         std::hypot(r + halfColumn, y + halfRow) >= radius;
}

}  // namespace

Volume axisPattern(const DisplayProfile& profile) {
  const PatternGrid grid(profile);
  const int rows = grid.rows();
  const int smallRing = grid.ringAt(kSmallRingRadius);
  const double smallHeight = kSmallRingHeight * profile.halfHeightRadii;
  const int upper = grid.rowAt(smallHeight);
  return painted(grid, [&](const PatternVoxel& v) {
    const int third = 3 * v.row / rows;
    const bool front = v.sector < profile.slicesPerHalfTurn;
    bool lit = v.ring == 0 && (third == 0 || front == (third == 1));
    if (v.row == rows / 2) {
      for (const double radius : {0.25, 0.5, 0.75, 1.0}) {
        lit |= v.ring == grid.ringAt(radius);
      }
    }
    lit |= v.ring == smallRing && (v.row == upper || v.row == rows - 1 - upper);
    return lit ? grid.white() : Rgb8(0);
  });
}

Volume orientationPattern(const DisplayProfile& profile) {
  const PatternGrid grid(profile);
  const int letterRing = grid.ringAt(kLetterRadius);
  const int topRow = grid.rowAt(kTopHeight * profile.halfHeightRadii);
  const double cellWidth = letterCellWidth(grid);
  return painted(grid, [&](const PatternVoxel& v) {
    const bool lit =
        (v.ring == letterRing && sideLetterLit(grid, v, cellWidth)) || (v.row == topRow && topLetterLit(grid, v));
    return lit ? grid.white() : Rgb8(0);
  });
}

BoxSides boxSides(const DisplayProfile& profile) {
  return {kBoxSide, std::min(kBoxSide, kMaxOfHeight * profile.halfHeightRadii)};
}

Volume boxPattern(const DisplayProfile& profile) {
  const PatternGrid grid(profile);
  const BoxSides sides = boxSides(profile);
  const int top = grid.rowAt(sides.up);
  const int bottom = grid.rows() - 1 - top;
  const int middle = grid.rows() / 2;
  const int cornerRing = grid.ringAt(std::sqrt(2.0) * sides.across);
  const int faceRing = grid.ringAt(sides.across);
  return painted(grid, [&](const PatternVoxel& v) {
    if (v.row < top || v.row > bottom) {
      return Rgb8(0);
    }
    bool lit = false;
    if (v.row == top || v.row == middle || v.row == bottom) {
      lit = squarePasses(grid, v, sides.across);
    }
    for (int eighth = 0; eighth < 8 && !lit; ++eighth) {
      lit = v.ring == (eighth % 2 == 0 ? faceRing : cornerRing) && grid.holds(v.sector, eighth * kPi / 4);
    }
    return lit ? grid.white() : Rgb8(0);
  });
}

double sphereRadius(const DisplayProfile& profile) {
  return kMaxOfHeight * std::min(1.0, profile.halfHeightRadii);
}

Volume spherePattern(const DisplayProfile& profile) {
  const PatternGrid grid(profile);
  const double radius = sphereRadius(profile);
  struct Parallel {
    int row;
    int ring;
  };
  std::vector<Parallel> parallels;
  for (int degrees = -90 + kSphereStepDegrees; degrees < 90; degrees += kSphereStepDegrees) {
    const double latitude = degrees * kPi / 180;
    parallels.push_back({grid.rowAt(radius * std::sin(latitude)), grid.ringAt(radius * std::cos(latitude))});
  }
  std::vector<bool> meridian(static_cast<size_t>(grid.sectors()));
  for (int sector = 0; sector < grid.sectors(); ++sector) {
    for (int degrees = 0; degrees < 360; degrees += kSphereStepDegrees) {
      meridian[static_cast<size_t>(sector)] =
          meridian[static_cast<size_t>(sector)] || grid.holds(sector, degrees * kPi / 180);
    }
  }
  return painted(grid, [&](const PatternVoxel& v) {
    bool lit = meridian[static_cast<size_t>(v.sector)] && circlePasses(grid, v, radius);
    for (const Parallel& parallel : parallels) {
      lit |= v.row == parallel.row && v.ring == parallel.ring;
    }
    return lit ? grid.white() : Rgb8(0);
  });
}

}  // namespace ocelli
