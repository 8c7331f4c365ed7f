// How a picture shows the floor around a thing: at what scale and turned which way. A picture along bent rays shows
// each piece of a maze in a perspective of its own, and so do several pictures side by side; what an observer can say
// about places comes from this alone, whatever camera made the picture.
#pragma once

#include <glm/mat2x2.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <optional>
#include <vector>

namespace ocelli {

struct PicturePerspective {
  /// Times metres (east, south) are pixels (right, down). Regular.
  glm::dmat2 pixelsFromMeters{1};

  /// Side of a square of a square metre of the floor, pixels.
  double pixelsPerMeter() const;
  /// By which the picture is turned, clockwise from north at the top; radians, in (-pi, pi].
  double turnRadians() const;
  /// How far off a place on the floor is (east, south, metres) where it is taken to be `pixels` off in the picture.
  glm::dvec2 metersFrom(const glm::dvec2& pixels) const;
  /// Square metres: of places, where those in the picture are off by `pixels` each way (standard deviation).
  glm::dmat2 placeCovariance(double pixels) const;
};

/// Between the turns of two of them, [0, pi] radians.
double turnBetween(const PicturePerspective& a, const PicturePerspective& b);

/// The linear map nearest, by least squares, to what some pixels show. Heights are fitted too, so that walls do not
/// count as floor.
class PerspectiveFit {
 public:
  /// `pixel` shows the point, metres.
  void add(const glm::dvec2& pixel, const glm::dvec3& point);
  /// Nothing where the points lie in a line or are fewer than four. The map is never flatter than 1 to 50: floors that
  /// are seen nearly along themselves tell hardly anything about the distance.
  std::optional<PicturePerspective> result() const;

 private:
  std::vector<glm::dvec2> pixels_{};
  std::vector<glm::dvec3> points_{};
};

}  // namespace ocelli
