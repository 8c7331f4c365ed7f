#include "oc_core/volume_ocri/volume_first_hits.h"

#include <fmt/format.h>

#include <utility>

#include "oc_core/base/sha256.h"

namespace ocelli {

VolumeFirstHits::VolumeFirstHits(VolumeScene scene, const VolumeRenderOptions& options)
    : renderer_(std::move(scene), options), target_(renderer_), matter_(renderer_.scene(), options.depthOpacity) {}

TargetRenderer::Behind VolumeFirstHits::behind() const {
  return [this](const RayPath& ray, const Hit& hit) { return matter_.behind(ray, hit.t); };
}

TargetScene VolumeFirstHits::evaluated() const {
  return {target_, behind(), [this](const glm::vec3& point, float reach) { return matter_.isNear(point, reach); }};
}

std::string VolumeFirstHits::description() const {
  const glm::ivec3& size = scene().volume->grid().size;
  return fmt::format("{} x {} x {} voxels, first hits at an opacity of {:g}", size.x, size.y, size.z, opacity());
}

std::string VolumeFirstHits::identity() const {
  const VolumeScene& scene = this->scene();
  const std::span<const std::byte> voxels = scene.volume->voxels();
  std::string text = sha256({reinterpret_cast<const uint8_t*>(voxels.data()), voxels.size()});
  const auto add = [&](double number) { text += fmt::format(" {}", number); };
  for (int axis = 0; axis < 3; ++axis) {
    add(scene.volume->grid().size[axis]);
  }
  text += nameOf(scene.volume->type());
  add(scene.volume->scale());
  add(scene.volume->offset());
  for (int column = 0; column < 4; ++column) {
    for (int row = 0; row < 3; ++row) {
      add(scene.worldFromIndex[column][row]);
    }
  }
  const auto addColor = [&](const glm::dvec3& v) {
    add(v.x);
    add(v.y);
    add(v.z);
  };
  add(scene.appearance.transfer.opacityLength());
  for (const TransferPoint& point : scene.appearance.transfer.points()) {
    add(point.value);
    addColor(point.color);
    add(point.opacity);
  }
  const VolumeShading& shading = scene.appearance.shading;
  for (const double number :
       {double(shading.isOn), shading.ambient, shading.diffuse, shading.specular, shading.shininess,
        scene.sceneLengthOfUnit(), renderer_.options().step, renderer_.options().endTransmittance, opacity()}) {
    add(number);
  }
  for (const ClipPlane& clip : scene.clips) {
    addColor(clip.normal);
    add(clip.distance);
  }
  const auto addArray = [&](const auto& array) {
    text += fmt::format(" {} ", array.size());
    text += sha256({reinterpret_cast<const uint8_t*>(array.data()), array.size() * sizeof(array[0])});
  };
  addArray(scene.surfaces.positions);
  addArray(scene.surfaces.colors);
  addArray(scene.surfaces.triangles);
  return sha256(text);
}

}  // namespace ocelli
