// A cell between four neighbouring samples, and which triangles close it: the policy that the meshers of image_mesh.h
// and layered_mesh.h share.
//
//   a --- d     A triangle needs two sides of the cell that meet and the diagonal across them, all of one surface.
//   Where |     |     sides or diagonal are not, it would be a false skin between two surfaces, and is left out. b ---
//   c
#pragma once

#include <cmath>
#include <cstdint>

#include "oc_core/scene/mesh.h"

namespace ocelli {

/// Which sides lie on one surface.
struct CellSides {
  bool ab = false;
  bool bc = false;
  bool cd = false;
  bool da = false;
};

/// Six of the eight triangles around a sample leave no opening that matters; with fewer, its surface ends there, and it
/// gets a square that stands for its pixel.
inline constexpr int kClosedTriangles = 6;

/// Calls `add` with the corners of each triangle of the cell, counter-clockwise: two, one or none. `joins` says whether
/// the two ends of a diagonal lie on one surface. The diagonal that closes more is taken; of two that close as much,
/// the one whose ends differ less in `inverseDepth`, as a plane's do.
template <class Corner, class Joins, class InverseDepth, class Add>
void closeCell(const Corner& a, const Corner& b, const Corner& c, const Corner& d, const CellSides& sides,
               const Joins& joins, const InverseDepth& inverseDepth, const Add& add) {
  if (sides.ab + sides.bc + sides.cd + sides.da < 2) {
    return;
  }
  const int alongAc = joins(a, c) ? (sides.ab && sides.bc) + (sides.cd && sides.da) : 0;
  const int alongBd = joins(b, d) ? (sides.bc && sides.cd) + (sides.da && sides.ab) : 0;
  if (alongAc == 0 && alongBd == 0) {
    return;
  }
  const auto unlike = [&](const Corner& p, const Corner& q) { return std::abs(inverseDepth(p) - inverseDepth(q)); };
  if (alongAc > alongBd || (alongAc == alongBd && unlike(a, c) <= unlike(b, d))) {
    if (sides.ab && sides.bc) {
      add(a, b, c);
    }
    if (sides.cd && sides.da) {
      add(a, c, d);
    }
  } else {
    if (sides.bc && sides.cd) {
      add(b, c, d);
    }
    if (sides.da && sides.ab) {
      add(b, d, a);
    }
  }
}

/// The triangles that closeCell() adds, one bit each: abc, acd, bcd and bda. Given by their first two corners, where a
/// to d are 0 to 3.
inline uint8_t bitOfTriangle(int first, int second) {
  return first == 0 ? (second == 1 ? 1 : 2) : (second == 2 ? 4 : 8);
}
inline int triangleCount(uint8_t bits) {
  return (bits & 1) + (bits >> 1 & 1) + (bits >> 2 & 1) + (bits >> 3 & 1);
}
/// Calls `add` for each, in the order of closeCell().
template <class Corner, class Add>
void forTrianglesOf(uint8_t bits, const Corner& a, const Corner& b, const Corner& c, const Corner& d, const Add& add) {
  if ((bits & 1) != 0) {
    add(a, b, c);
  }
  if ((bits & 2) != 0) {
    add(a, c, d);
  }
  if ((bits & 4) != 0) {
    add(b, c, d);
  }
  if ((bits & 8) != 0) {
    add(b, d, a);
  }
}

}  // namespace ocelli
