// Ambient light by horizons in an image (section 4.3.4.4, after L. Bavoil, M. Sainz and R. Dimitrov, Image-space
// horizon-based ambient occlusion, SIGGRAPH 2008 talks).
//
// A plane through the ray of a pixel is a line of the image, in the image of a pinhole and in that of a graph camera,
// whose frusta are pinholes one after the other. So one walk along a segment of the image tells what hides light in a
// half plane: each sample that stands higher over the tangent plane than all before it hides the angle between, and
// counts by its distance.
//
// DEVIATION: Bavoil et al. weigh all directions over the tangent plane alike, from azimuths in the image. Here the
// integral over a half plane is that of the cosine-weighted hemisphere, in closed form, so that of a height field the
// result is what rays find (as later work has it: J. Jimenez et al., Practical realtime strategies for accurate
// indirect occlusion, 2016).
//
// Samples are what they are in the world: where rays bend between a pixel and a sample, the plane is not exactly one,
// and the angle of the sample over the tangent plane counts.
#pragma once

#include <span>
#include <vector>

#include "oc_core/ambient/ambient_options.h"
#include "oc_core/ambient/ambient_points.h"
#include "oc_core/camera/graph_camera.h"

namespace ocelli {

/// What the samples of a graph camera's image are in the world. A pinhole is a graph camera of one frustum.
class HorizonImage {
 public:
  /// `fragments` are what the camera sees of the mesh.
  HorizonImage(const GraphCamera& camera, const FragmentImage& fragments, const Mesh& mesh);

  const GraphCamera& camera() const { return camera_; }
  bool holds(int x, int y) const { return held_(x, y) != 0; }
  const glm::vec3& position(int x, int y) const { return positions_(x, y); }

 private:
  GraphCamera camera_;
  Image<uint8_t> held_;
  Image<glm::vec3> positions_;
};

struct HorizonWalk {
  int directions = 16;  ///< half planes a point; at least 1
  int steps = 16;       ///< samples that are looked at along each; they lie closer together near the point. At least 1
  uint64_t seed = 1;    ///< of the azimuths of the directions, by pixel
};

struct HorizonLight {
  std::vector<float> light;  ///< of each point, 0 to 1; 1 where the image does not hold the point
  size_t notHeld = 0;        ///< points that no frustum holds, or whose image lies beyond the borders
};

/// Whether a frustum of the camera holds a point, and its image lies within the borders.
bool isHeld(const AmbientPoint& point, const GraphCamera& camera);

/// Throws InputError as validate() does, and for a walk without directions or steps.
HorizonLight ambientByHorizon(std::span<const AmbientPoint> points, const HorizonImage& image,
                              const AmbientOptions& options, const HorizonWalk& walk = {});

/// The slow reference: each sample of the image within the radius counts in the half plane in which it lies, in the
/// order of their distances in the image.
HorizonLight ambientByHorizonSlowly(std::span<const AmbientPoint> points, const HorizonImage& image,
                                    const AmbientOptions& options, int directions);

}  // namespace ocelli
