// What of a percept reaches someone who looks at one point of the screen: near the gaze small things are seen, farther
// from it large ones alone.
#pragma once

#include <cmath>
#include <glm/geometric.hpp>

#include "study/agent/human_factors.h"
#include "study/agent/percept.h"

namespace ocelli {

class Vision {
 public:
  Vision(const HumanFactors& factors, double pixelsPerDegree) : factors_(factors), pixelsPerDegree_(pixelsPerDegree) {}

  const HumanFactors& factors() const { return factors_; }
  double pixelsPerDegree() const { return pixelsPerDegree_; }
  double degrees(const glm::dvec2& a, const glm::dvec2& b) const { return glm::distance(a, b) / pixelsPerDegree_; }

  bool notices(const Sighting& object, const glm::dvec2& gaze) const {
    return sideOf(object.pixels) >= factors_.noticedDegrees * magnification(degrees(object.centroid, gaze));
  }
  bool takesIn(const FloorPatch& patch, const glm::dvec2& gaze) const {
    return degrees(patch.centroid, gaze) <= factors_.usefulFieldDegrees &&
           sideOf(patch.pixels) >= factors_.minFloorDegrees;
  }

 private:
  double sideOf(size_t pixels) const { return std::sqrt(static_cast<double>(pixels)) / pixelsPerDegree_; }
  double magnification(double degreesFromGaze) const { return 1 + degreesFromGaze / factors_.doublingDegrees; }

  const HumanFactors& factors_;
  double pixelsPerDegree_;
};

}  // namespace ocelli
