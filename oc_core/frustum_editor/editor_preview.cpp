#include "oc_core/frustum_editor/editor_preview.h"

#include <algorithm>

#include "oc_core/multiperspective/multiperspective_image.h"

namespace ocelli {
namespace {

Image<Rgb8> imageOf(const MultiperspectiveCamera& camera, const Mesh& mesh) {
  return srgbFromLinear(colorImage(rasterize(camera, mesh), mesh, skyColor()));
}

}  // namespace

std::optional<PreviewImage> EditorPreview::next() {
  const int revision = editor_->revision();
  if (wholeRevision_ == revision) {
    return std::nullopt;
  }
  if (smallRevision_ != revision) {
    smallRevision_ = revision;
    const int width = std::max(1, static_cast<int>(editor_->drawn().imageSize().x) / kSmaller);
    return PreviewImage{imageOf(editor_->cameraOfWidth(width), *mesh_), false, revision};
  }
  wholeRevision_ = revision;
  return PreviewImage{imageOf(editor_->camera(), *mesh_), true, revision};
}

}  // namespace ocelli
