// Depth images as targets of many rays at once, cast with OpenGL.
#pragma once

#include <memory>

#include "oc_core/depth_rays/depth_ray_caster.h"
#include "oc_core/gl/gl_context.h"

namespace ocelli {

class GlRayCaster final : public DepthRayCaster {
 public:
  explicit GlRayCaster(std::shared_ptr<GlContext> context) : context_(std::move(context)) {}
  /// A context that others own, such as a window's: it must outlive this and all that prepare() returns.
  explicit GlRayCaster(GlContext& context) : context_(std::shared_ptr<GlContext>(), &context) {}

  /// Throws GlError where the GPU has no room, or its driver refuses a shader; so does what it returns.
  std::unique_ptr<Target> prepare(const DepthImageTarget& target) const override;
  std::string description() const override { return describe(context_->info()); }

 private:
  std::shared_ptr<GlContext> context_;
};

}  // namespace ocelli
