#include "display_sim/viewer/volume_painter.h"

#include "oc_core/camera/gpc_camera.h"
#include "oc_core/image/color.h"
#include "oc_core/ocri/representation_kind.h"

namespace ocelli {
namespace {

/// The rays of a camera of this size at the view.
RayFunction raysOf(const VolumeWanted& wanted, const glm::ivec2& size) {
  const PinholeCamera reference(wanted.view, size.x, size.y);
  if (wanted.camera.kind->layout) {
    const auto camera = std::make_shared<const GpcCamera>(reference, wanted.camera.kind->layout(wanted.camera));
    return [camera](const glm::vec2& pixel) { return camera->rayPath(pixel); };
  }
  const Mesh& mesh = wanted.scene->mesh;
  if (!hasRaysOfItsOwn(wanted.camera) && !mesh.triangles.empty()) {
    const ReferenceImages images = buildReferenceImages(wanted.camera, reference, mesh);
    return cameraRays(wanted.camera, reference, mesh, images).front();
  }
  return [reference](const glm::vec2& pixel) { return reference.rayPath(pixel); };
}

}  // namespace

std::vector<ClipPlane> clipsOf(const VolumeScene& scene, const std::array<glm::dvec2, 3>& kept) {
  std::vector<ClipPlane> clips = scene.clips;
  const std::vector<ClipPlane> more = clipPlanesOf(kept, scene.bounds());
  clips.insert(clips.end(), more.begin(), more.end());
  return clips;
}

bool hasRaysOfItsOwn(const CameraChoice& camera) {
  return camera.kind->layout || camera.kind->name == std::string_view("di");
}

void VolumePainter::prepare(const VolumeWanted& wanted, bool isPreview) {
  if (volume_ != wanted.scene->volume) {
    renderer_.reset();
    volume_ = wanted.scene->volume;
    renderer_.emplace(volume_->scene);
    appearance_ = nullptr;
    kept_ = {};
  }
  if (appearance_ != wanted.appearance) {
    renderer_->setAppearance(*wanted.appearance);
    appearance_ = wanted.appearance;
  }
  if (kept_ != wanted.kept) {
    renderer_->setClips(clipsOf(volume_->scene, wanted.kept));
    kept_ = wanted.kept;
  }
  VolumeRenderOptions options;
  options.step *= isPreview ? kPreviewStep : 1;
  if (renderer_->options().step != options.step) {
    renderer_->setOptions(options);
  }
}

Image<Rgb8> VolumePainter::paint(const VolumeWanted& wanted, const glm::ivec2& size, const Progress& progress) {
  prepare(wanted, size != wanted.size);
  const VolumeImage pixels = renderer_->render(size.x, size.y, raysOf(wanted, size), progress);
  Image<glm::vec3> colors(size.x, size.y);
  for (size_t i = 0; i < pixels.size(); ++i) {
    colors[i] = colorBefore(glm::vec3(0), pixels[i]);
  }
  return srgbFromLinear(colors);
}

}  // namespace ocelli
