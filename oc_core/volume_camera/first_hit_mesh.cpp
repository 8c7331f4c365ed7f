#include "oc_core/volume_camera/first_hit_mesh.h"

#include <array>

#include "oc_core/ocri/image_mesh.h"

namespace ocelli {
namespace {

ReferenceImage firstHitImage(const RayTarget& target, const PinholeCamera& camera) {
  const HitImage hits = castRays(camera, target);
  ReferenceImage image = blankReferenceImage("di", camera.view(), camera.width(), camera.height());
  for (int y = 0; y < hits.height(); ++y) {
    for (int x = 0; x < hits.width(); ++x) {
      if (const std::optional<Hit>& hit = hits(x, y)) {
        image.set(x, y, hit->t, hit->color);
      }
    }
  }
  return image;
}

}  // namespace

Mesh firstHitMesh(const RayTarget& target, const PinholeCamera& reference, float cellSideRadii,
                  const Progress& progress) {
  constexpr int kCorners = 8;
  const float half = cellSideRadii / 2;
  Mesh mesh;
  for (int i = 0; i <= kCorners; ++i) {
    report(progress, "what hides what", static_cast<double>(i) / (kCorners + 1));
    const glm::vec3 corner((i & 1) != 0 ? half : -half, (i & 2) != 0 ? half : -half, (i & 4) != 0 ? half : -half);
    const View view = i < kCorners ? movedEye(reference.view(), corner) : reference.view();
    append(mesh, imageMesh(firstHitImage(target, PinholeCamera(view, reference.width(), reference.height()))));
  }
  mesh.isPart = true;
  return mesh;
}

}  // namespace ocelli
