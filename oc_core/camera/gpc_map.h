// The mapping of a general pinhole camera (section 5.2.1.2 and 5.2.2.2) between the pixels of its image and those of
// the pinhole whose rays it takes, in double precision.
//
// A point of a region moves along its line to the region's centre: image - c = (r / f(r)) (pinhole - c), where r is the
// distance from c in the rectangular norm max(|du| / half width, |dv| / half height), and f that of gpc_profile.h. The
// inner edge, the outer edge and the diagonals between, where the text changes from one of its four expressions to the
// next, are then where it says; and f is the same for both axes, so the mapping is continuous across the diagonals too.
//
// "Image" here is the camera's own, "pinhole" that of the reference; the text calls the first undistorted.
#pragma once

#include <glm/mat2x2.hpp>
#include <glm/vec2.hpp>
#include <span>
#include <vector>

#include "oc_core/camera/distorted_pinhole.h"
#include "oc_core/camera/gpc_layout.h"

namespace ocelli {

/// A region in pixels.
class GpcZone {
 public:
  GpcZone(const GpcRegion& region, const GpcSampling& sampling, const glm::ivec2& size);

  const glm::dvec2& center() const { return center_; }
  const glm::dvec2& half() const { return half_; }
  const GpcProfile& profile() const { return profile_; }
  /// Half the size of what the inner rectangle shows, in the pinhole's image.
  glm::dvec2 innerHalfInPinhole() const { return half_ / profile_.zoom(); }
  glm::dvec2 outerHalf() const { return half_ * profile_.outer(); }

  /// Distance from the centre in half extents.
  double distance(const glm::dvec2& p) const {
    const glm::dvec2 d = (p - center_) / half_;
    return std::max(std::abs(d.x), std::abs(d.y));
  }
  /// Beyond the outer edge both are the identity.
  glm::dvec2 pinholeFromImage(const glm::dvec2& image) const {
    const double r = distance(image);
    return r <= 1                  ? center_ + (image - center_) / profile_.zoom()
           : r >= profile_.outer() ? image
                                   : center_ + (image - center_) * (profile_.sampled(r) / r);
  }
  glm::dvec2 imageFromPinhole(const glm::dvec2& pinhole) const {
    const double f = distance(pinhole);
    return f * profile_.zoom() <= 1 ? center_ + (pinhole - center_) * profile_.zoom()
           : f >= profile_.outer()  ? pinhole
                                    : center_ + (pinhole - center_) * (profile_.inverse(f) / f);
  }
  /// r / f(r) for a value of f: how far from the centre the image shows what the pinhole sees at f. Monotone.
  double magnification(double f) const {
    return f * profile_.zoom() <= 1 ? profile_.zoom() : f >= profile_.outer() ? 1 : profile_.inverse(f) / f;
  }
  /// d(pinhole) / d(image) at a point of the image; columns are what a step in u and one in v become.
  glm::dmat2 jacobian(const glm::dvec2& image) const;
  /// What magnification() lies between for the points of the pinhole's image in a box: least, greatest.
  glm::dvec2 magnificationOver(const ImageBox& pinhole) const;
  /// Around the images of all points of the pinhole in a box: never too small.
  ImageBox imageBox(const ImageBox& pinhole) const;

 private:
  glm::dvec2 center_;
  glm::dvec2 half_;
  GpcProfile profile_;
};

class GpcMap {
 public:
  /// Throws InputError as validate() of gpc_layout.h.
  GpcMap(GpcLayout layout, int width, int height);

  const GpcLayout& layout() const { return layout_; }
  std::span<const GpcZone> zones() const { return zones_; }

  glm::dvec2 pinholeFromImage(const glm::dvec2& image) const {
    const GpcZone* zone = zoneAt(image);
    return zone != nullptr ? zone->pinholeFromImage(image) : image;
  }
  glm::dvec2 imageFromPinhole(const glm::dvec2& pinhole) const {
    const GpcZone* zone = zoneAt(pinhole);
    return zone != nullptr ? zone->imageFromPinhole(pinhole) : pinhole;
  }
  glm::dmat2 jacobian(const glm::dvec2& image) const;
  /// Samples for each one of the pinhole, at a point of the image, in the direction that has fewest.
  double rateAt(const glm::dvec2& image) const;

  /// The zone whose outer rectangle, which is the same in both images, holds a point.
  const GpcZone* zoneAt(const glm::dvec2& p) const {
    for (const GpcZone& zone : zones_) {
      if (zone.distance(p) < zone.profile().outer()) {
        return &zone;
      }
    }
    return nullptr;
  }

 private:
  GpcLayout layout_;
  std::vector<GpcZone> zones_;
};

/// How far apart two neighbouring samples may lie, and how near, as a step of unit length becomes: the singular values
/// of a Jacobian, the greater first.
glm::dvec2 singularValues(const glm::dmat2& jacobian);

}  // namespace ocelli
