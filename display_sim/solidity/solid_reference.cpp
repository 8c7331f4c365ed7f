#include "display_sim/solidity/solid_reference.h"

#include "display_sim/solidity/opaque_image.h"
#include "display_sim/solidity/voxel_visibility.h"

namespace ocelli {
namespace {

class HiddenBySurfaces final : public HiddenVoxels {
 public:
  HiddenBySurfaces(const Volume& volume, const RayScene& surfaces) : visibility_(volume, surfaces) {}
  Volume hiddenFrom(const glm::vec3& eye) const override { return visibility_.hiddenFrom(eye); }

 private:
  VoxelVisibility visibility_;
};

class SolidSurfaces final : public SolidReference {
 public:
  explicit SolidSurfaces(const Mesh& scene) : scene_(scene), surfaces_(scene) {}
  Image<Rgb8> opaqueImage(const ObserverOptions& options) const override {
    return ocelli::opaqueImage(scene_, options);
  }
  std::unique_ptr<HiddenVoxels> hiddenVoxels(const Volume& volume) const override {
    return std::make_unique<HiddenBySurfaces>(volume, surfaces_);
  }

 private:
  const Mesh& scene_;
  RayScene surfaces_;
};

}  // namespace

std::unique_ptr<SolidReference> solidSurfaces(const Mesh& scene) {
  return std::make_unique<SolidSurfaces>(scene);
}

}  // namespace ocelli
