// What a value of a volume looks like: its colour and its opacity.
//
// Light that goes a length ds through a place of extinction s loses the share s ds of itself, and gains s ds times the
// colour of the place (emission and absorption, N. Max, "Optical models for direct volume rendering", 1995). Opacity is
// told as users see it: the share of light that a slab of `opacityLength` keeps, so that
// extinction = -ln(1 - opacity) / opacityLength. Colour and opacity are linear between points, in the value, and
// constant beyond the first and the last.
#pragma once

#include <glm/vec3.hpp>
#include <string>
#include <vector>

namespace ocelli {

struct TransferPoint {
  double value = 0;
  glm::dvec3 color{1};  ///< linear RGB, 0 to 1
  double opacity = 0;   ///< 0 to 1, of a slab of the opacity length
};

/// What a place does with light.
struct OpticalSample {
  glm::dvec3 color{0};    ///< linear RGB
  double extinction = 0;  ///< by the world's unit of length of the volume's grid
};

class TransferFunction {
 public:
  /// Opacities above this count as this: what keeps all would have an extinction that no step resolves.
  static constexpr double kMaxOpacity = 0.9999;

  /// `points` are at least one, and their values do not fall; two of the same value are a step. `opacityLength`, in
  /// units of the grid's world, is positive.
  TransferFunction(std::vector<TransferPoint> points, double opacityLength);

  const std::vector<TransferPoint>& points() const { return points_; }
  double opacityLength() const { return opacityLength_; }
  OpticalSample at(double value) const;

 private:
  std::vector<TransferPoint> points_;
  double opacityLength_;
};

}  // namespace ocelli
