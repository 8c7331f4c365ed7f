// What has been made of the scene so far, in memory and on the GPU.
#pragma once

#include <memory>
#include <optional>

#include "display_sim/viewer/background_work.h"
#include "oc_core/gl/gl_mesh.h"

namespace ocelli {

struct ViewerData {
  std::shared_ptr<const LoadedScene> scene;
  std::shared_ptr<const BuiltCamera> camera;
  std::shared_ptr<const std::vector<RayFunction>> rays;  ///< null until they are known
  std::shared_ptr<const SlicedVolume> volume;
  std::optional<GlMesh> sceneMesh;   ///< nothing of a scene without triangles
  std::optional<GlMesh> cameraMesh;  ///< of what stands for the scene
  uint64_t version = 0;              ///< counts changes

  /// Takes over what is new; what no longer fits it goes. Throws GlError where the GPU has no room: then the piece is
  /// missing. Hold a GlScope.
  void take(GlContext& context, const WorkResult& result);
};

}  // namespace ocelli
