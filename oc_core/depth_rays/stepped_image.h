// Where a ray first meets a reference image, by steps along its projection: the text's way (section 3.5.2.2).
//
// The ray is clipped to the box of the samples and divided in space until each piece is at most a coarse step long in
// the image: a ray's projection is a curve in an occlusion camera's image, so its pieces are projected one by one. A
// coarse piece is left out where both of its ends project to empty pixels, or where it clearly passes before or behind
// what they show. Others are divided further, down to the fine step; there depth is interpolated between the ends, 1/t
// of the ray against 1/t of the samples (t is z for cameras that displace a pinhole's image), and the piece meets the
// surface where the two cross, if the samples are joined as neighbours of one surface are.
//
// DEVIATION: the text interpolates z itself between the ends of a piece. z of a plane is linear in the image only where
// it faces the camera; 1/z is linear for every plane.
//
// A silhouette fades (section 3.5.2.4.1): the opacity of a hit falls to 0 as the ray of the image's sample becomes
// tangential to the surface.
//
// Unlike depth_image_target.h this may pass what is thinner than a step in the image, and meets nothing of layers
// behind the first. It is here to be compared with.
#pragma once

#include <optional>

#include "oc_core/depth_rays/ray_cost.h"
#include "oc_core/depth_rays/straight_ray.h"
#include "oc_core/ocri/representation_kind.h"
#include "oc_core/scene/box.h"

namespace ocelli {

struct SteppingOptions {
  double coarsePixels = 6;  ///< length of a coarse step in the image
  double finePixels = 1;    ///< of a fine one; the text has 1, 1/2 and 1/4
  /// Neighbouring places are of one surface where their depths differ by at most so many footprints, as image_mesh.h
  /// has it.
  double joinFootprints = 10;
  /// A silhouette is opaque from this cosine on between the ray of a sample and the normal of the surface.
  double opaqueCosine = 0.2;
};

class SteppedImage {
 public:
  /// The image and the map must outlive it. The image has at least one pixel.
  SteppedImage(const ReferenceImage& image, const CameraMap& map, const SteppingOptions& options = {});

  struct Meeting {
    double share = 0;     ///< of the ray's step
    glm::dvec2 place{0};  ///< in the image, pixels
    double opacity = 1;   ///< 0 to 1: less where the surface is seen edge-on by the image
  };
  /// Nothing where no piece crosses a surface. `cost.nodes` grows by coarse steps, `cost.cells` by fine ones: each
  /// looks at two places of the image.
  std::optional<Meeting> meet(const StraightRay& ray, RayCost& cost) const;

  /// The most steps that a ray takes: halving ends at pieces of 1 / kMaxPieces of the ray.
  static constexpr int kMaxHalvings = 14;
  static constexpr size_t maxSteps() { return (size_t{2} << kMaxHalvings) - 1; }

  // What a walk elsewhere than on the CPU needs (oc_core/gl_rays), which takes the same decisions.

  /// The ends of a piece of a curve may be closer than the piece is long: the first pieces are always halved.
  static constexpr int kAlwaysHalved = 2;
  /// A piece neither end of which has an image may have one in between; it is given up at 1/32 of the ray.
  static constexpr int kUnseenHalvings = 5;
  /// A coarse piece that stays farther before or behind what both ends show than it moves itself cannot meet it, but
  /// where the surface does as much in between: some factor for that.
  static constexpr double kClearly = 1.5;
  const ReferenceImage& image() const { return image_; }
  const SteppingOptions& options() const { return options_; }
  const Box& bounds() const { return bounds_; }
  /// Of the reference view, pixels.
  float focalPixels() const { return pinhole_.focalPixels(); }
  /// The opacity of a hit that lies in a pixel.
  double opacityOf(int x, int y) const;

 private:
  /// A point of the ray, and what the image shows there.
  struct Probe {
    double share = 0;
    bool projects = false;
    glm::dvec2 place{0};
    double inverse = 0;                       ///< 1/t of the ray
    std::optional<double> shownInverse = {};  ///< 1/t of the sample; nothing where there is none
  };

  Probe probe(const StraightRay& ray, double share) const;
  std::optional<Meeting> meetWithin(const StraightRay& ray, const Probe& a, const Probe& b, int halvings,
                                    RayCost& cost) const;
  std::optional<Meeting> crossing(const StraightRay& ray, const Probe& a, const Probe& b) const;

  const ReferenceImage& image_;
  const CameraMap& map_;
  SteppingOptions options_;
  PinholeCamera pinhole_;
  Box bounds_;
};

}  // namespace ocelli
