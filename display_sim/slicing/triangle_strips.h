// Where a triangle is sampled: in strips along its longest side, as far apart along and across as each direction
// allows; small ones in a lattice of two or three parts where that has fewer samples.
//
// Claim: each point of a sampled triangle has a sample of that triangle, or a corner of it, less than half a voxel away
// in each direction of the sweep: sectors u, columns v, rows w. So a side that two triangles share needs no agreement
// between them.
//
// Lengths. Let the corners span the angle 2a about the axis, seen from its middle; r points outwards there, t across,
// y up, all in columns except y in rows; r0 > 0 is the least r of the corners. S sectors are a radian. A point of the
// triangle is at least r0 from the axis, and its own outwards direction at most a from r. So along a difference d of
// two of its points
//     |du| <= U(d) = S / r0 (|d.t| + a |d.r|),   |dv| <= V(d) = |d.r| + a |d.t|,   |dw| = W(d) = |d.y|   (1)
// by the mean value theorem, as du = S (d . across) / radius and dv = d . outwards there, and sin a <= a. U, V and W
// are seminorms.
//
// Strips. AB is the longest side, e = B - A, D = A + l e a point of it, f = C - D. P = A + s e + t f lies in the
// triangle iff 0 <= t <= 1 and l t <= s <= 1 - (1 - l) t. Let strip j of m hold j / m <= t <= (j + 1) / m. It is the
// widest at its lower end, 1 - j / m, and is cut along f into pieces no longer than 1 / n. Seen from its lower end a
// strip's height is a concave function of s; where it is at most h in a piece, the piece's sample is its middle in s,
// h / 2 above the lower end: inside of the triangle, as a concave function that is not negative has at least half of
// its largest value in the middle. A point of the piece is at most 1 / (2 n) from the sample in s, and h / 2 <=
// 1 / (2 m) in t. So if
//     U(e) / n + U(f) / m < 1,   V(e) / n + V(f) / m < 1,   W(e) / n + W(f) / m < 1                              (2)
// then (1) gives less than 1/2 in every direction.
//
// Corners alone. Let x, y, z be the largest U, V + 2 k, W of the sides, k = R (1 - cos a), R the largest radius of a
// corner: a chord comes no more than k nearer to the axis than its ends. If x, y, z < 1 and
//     1/x + 1/y + 1/z > 4                                                                                         (3)
// then each point P = p A + q B + c C of the triangle (weights, p + q + c = 1) is less than 1/2 from a corner in every
// direction. Otherwise each corner has a direction in which it is not.
// - A, B, C have different ones: by (1) 1/2 <= (1 - p) x, and so on. The sum gives 1/x + 1/y + 1/z <= 2 (3 - 1) = 4.
// - A and B have the same one and lie on both sides of P: they are 1 apart, but x, y, z < 1.
// - A and B have the same one, say x, on the same side of P, and C another one, say y. P lies on a segment from C to a
//   point Q of AB, P - Q = c (C - Q). u is monotone on AB, so Q is 1/2 from P, too: 1/2 <= c x. C: 1/2 <= (1 - c) y.
//   As x, y < 1, c > 1/2 and 1 - c > 1/2. For v, Q may lie k nearer to P: 1/2 - k <= c V, and c > 1/2 as V + 2 k < 1.
// - All have the same one on the same side: u and w of P lie between those of the corners, v at most k beside them.
//
// Lattices. A triangle that is divided in p^2 similar ones whose corners are samples has (3) for each of these if it
// has it with x / p, V / p + 2 k and z / p: its sides are p times shorter, its k is no larger.
//
// Figures of the display in single precision are some 1e-4 voxels off; (2) and (3) keep 0.005 from their limits.
#pragma once

#include <cstdint>
#include <vector>

namespace ocelli {

/// 1 in (2) and (3), less room for rounding.
inline constexpr float kWidestPiece = 0.995f;

/// A triangle of a mesh, A B C as above, and which weights of B and C (TriangleStrips) its samples have.
struct SampledTriangle {
  uint32_t corners[3];
  uint32_t firstWeight;
  uint32_t samples;
};

/// Weights of corners for all patterns of strips and lattices.
class TriangleStrips {
 public:
  static constexpr int kMaxStrips = 16;
  static constexpr int kMaxPieces = 32;
  /// l is in steps of 1 / kFootSteps; no more than half of them, as A and B can change places.
  static constexpr int kFootSteps = 16;

  /// A number for m strips in [1, kMaxStrips], 1 / n in [1, kMaxPieces] and l in [0, kFootSteps / 2].
  static constexpr int pattern(int strips, int pieces, int foot) {
    return (foot * (kMaxStrips + 1) + strips) * (kMaxPieces + 1) + pieces;
  }

  /// A number for lattices without the corners, p = 2 and 3: 3 and 7 samples.
  static constexpr int latticePattern(int parts) { return pattern(kMaxStrips, kMaxPieces, kFootSteps / 2) + parts - 1; }

  TriangleStrips();

  /// `order` k < 3: A is corner k, B and C the next ones; k + 3: A and B have changed places.
  SampledTriangle sampled(const uint32_t (&corners)[3], int pattern, int order) const {
    const auto first = static_cast<unsigned>(order) % 3;
    const uint32_t a = corners[first];
    const uint32_t b = corners[(first + 1) % 3];
    const Range& range = ranges_[static_cast<size_t>(pattern)];
    return {{order < 3 ? a : b, order < 3 ? b : a, corners[(first + 2) % 3]}, range.first, range.count};
  }

  /// B's and C's weights; A has the rest.
  const float* weightsOfB() const { return weightsOfB_.data(); }
  const float* weightsOfC() const { return weightsOfC_.data(); }

 private:
  struct Range {
    uint32_t first = 0;
    uint32_t count = 0;
  };
  void addLattice(int parts);
  void addStrip(int strip, int strips, int pieces, double foot);

  std::vector<Range> ranges_;
  std::vector<float> weightsOfB_;
  std::vector<float> weightsOfC_;
};

}  // namespace ocelli
