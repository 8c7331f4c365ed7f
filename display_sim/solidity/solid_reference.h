// What a display should look like if it could hide: the opaque truth that solidity is measured against.
#pragma once

#include <glm/vec3.hpp>
#include <memory>

#include "display_sim/frames/volume.h"
#include "display_sim/observing/observer.h"
#include "oc_core/image/png_file.h"
#include "oc_core/scene/mesh.h"

namespace ocelli {

/// Which lit voxels of one volume eyes should not see.
class HiddenVoxels {
 public:
  virtual ~HiddenVoxels() = default;
  /// The voxels that are hidden from `eye`; all others are dark. The same with any number of threads.
  virtual Volume hiddenFrom(const glm::vec3& eye) const = 0;
};

class SolidReference {
 public:
  virtual ~SolidReference() = default;
  /// What is there, on black, as if light did not pass through it: of `options` counts what says where the eye is and
  /// what its image holds.
  virtual Image<Rgb8> opaqueImage(const ObserverOptions& options) const = 0;
  /// The reference and the volume must outlive it.
  virtual std::unique_ptr<HiddenVoxels> hiddenVoxels(const Volume& volume) const = 0;
};

/// Opaque surfaces: `scene` must outlive it.
std::unique_ptr<SolidReference> solidSurfaces(const Mesh& scene);

}  // namespace ocelli
