// What a relief tile carries (section 3.5.2.3.2): something that stands for an object in the object's own coordinates,
// where rays meet it. Made once, and drawn wherever a tile places it.
#pragma once

#include <cstddef>
#include <optional>

#include "oc_core/depth_rays/ray_block.h"
#include "oc_core/depth_rays/ray_cost.h"
#include "oc_core/depth_rays/straight_ray.h"
#include "oc_core/scene/box.h"

namespace ocelli {

/// What is seen where a ray meets a relief object.
struct ReliefSurface {
  glm::vec3 color{0};   ///< linear, without light
  glm::vec3 normal{0};  ///< in the coordinates of the object, of any length; either side may be the outer one
};

class ReliefObject {
 public:
  virtual ~ReliefObject() = default;

  /// The first surface that the ray meets; `share` of its step. What the number and the weights of a meeting mean is
  /// the object's own matter. The ray has finite numbers and a direction. `cost` grows. Safe to call from many threads,
  /// as all of these are.
  virtual std::optional<TriangleMeeting> meet(const StraightRay& ray, RayCost& cost) const = 0;
  /// The same, slowly, by looking at all there is: what tests compare with.
  virtual std::optional<TriangleMeeting> meetSlowly(const StraightRay& ray) const = 0;
  /// The same for all rays of a block. Meetings that lie before the reach of their ray replace what the block says.
  virtual void meetBlock(RayBlock& block, RayCost& cost) const;
  virtual ReliefSurface surfaceAt(const TriangleMeeting& meeting) const = 0;

  /// Around all that rays can meet; empty where they can meet nothing.
  virtual Box bounds() const = 0;
  /// Pixels of its images, those that hold nothing among them.
  virtual size_t texels() const = 0;
  /// Pixels that hold something.
  virtual size_t samples() const = 0;
  /// The distance between neighbouring samples of a surface that the image faces.
  virtual float texelSize() const = 0;
};

inline void ReliefObject::meetBlock(RayBlock& block, RayCost& cost) const {
  for (int row = 0; row < block.rows; ++row) {
    for (int column = 0; column < block.columns; ++column) {
      const auto i = static_cast<size_t>(block.indexOf(column, row));
      const auto found = meet(block.ray(column, row), cost);
      if (found && (!block.meets[i] || found->share < block.meeting[i].share)) {
        block.meeting[i] = *found;
        block.meets[i] = true;
        block.reach[i] = static_cast<float>(found->share);
      }
    }
  }
}

}  // namespace ocelli
