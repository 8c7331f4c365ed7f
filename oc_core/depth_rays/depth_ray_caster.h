// Casts many rays at once at depth images, elsewhere than on the CPU: oc_core/gl_rays does it with OpenGL.
#pragma once

#include <memory>
#include <optional>
#include <span>
#include <string>

#include "oc_core/depth_rays/depth_image_target.h"

namespace ocelli {

class DepthRayCaster {
 public:
  virtual ~DepthRayCaster() = default;

  /// A target that rays can be cast at.
  class Target {
   public:
    virtual ~Target() = default;
    /// The first hit of each ray, and what it took, as DepthImageTarget::hit(). Called by one thread at a time. Throws
    /// WorkError where the device fails.
    virtual void hits(std::span<const RayPath> rays, std::span<std::optional<Hit>> found,
                      std::span<RayCost> costs) const = 0;
  };
  /// `target` must outlive what it returns, which may outlive the caster. Throws WorkError where the device has no
  /// room.
  virtual std::unique_ptr<Target> prepare(const DepthImageTarget& target) const = 0;
  /// For a message: "OpenGL on llvmpipe, through EGL".
  virtual std::string description() const = 0;
};

}  // namespace ocelli
