#include "oc_core/ocri/packed_view.h"

#include <limits>

#include "oc_core/ocri/nothing_seen.h"
#include "oc_core/ocri/representation_kind.h"
#include "oc_core/scene/winding_number.h"

namespace ocelli {
namespace {

/// Throws where a point lies inside an object. What is far away decides by directions alone, and may be coarse.
void requireOutside(const PackedScene& scene, const glm::vec3& eye, const std::string& where) {
  if (!contains(scene.bounds(), eye)) {
    return;
  }
  constexpr float kMaxErrorPerDistance = 0.02f;
  const std::vector<ClusterChoice> cut = chooseClusters(
      scene, [](const Sphere&) { return true; },
      [&](const Sphere& sphere, float error) {
        return error <= kMaxErrorPerDistance * (glm::distance(sphere.center, eye) - sphere.radius);
      });
  ocelli::requireOutside(weldedMeshOf(scene, cut), eye, where);
}

}  // namespace

Mesh meshForView(const PackedScene& scene, const CameraChoice& choice, const PinholeCamera& reference,
                 float maxErrorPixels) {
  const RepresentationKind& kind = *choice.kind;
  const std::optional<ViewedPart> part = kind.viewed ? kind.viewed(choice, reference) : std::nullopt;
  ViewCutOptions options{.maxErrorPixels = maxErrorPixels, .allAround = !part};
  if (part) {
    options.reach = part->reach;
    options.marginPixels = part->marginPixels;
    options.maxErrorPixels /= part->detail;
  } else {
    options.reach = choice.cellSideRadii;
  }
  Mesh mesh = meshOf(scene, viewCut(scene, reference, options));
  mesh.isPart = true;
  return mesh;
}

void requireViewpointsOutside(const PackedScene& scene, const CameraChoice& choice, const PinholeCamera& reference) {
  if (choice.kind->seesFromReference) {
    requireOutside(scene, reference.eye(), "view");
  }
  if (choice.kind->segments) {
    for (const glm::vec3& direction : choice.kind->segments(choice)) {
      const ViewSegment segment = segmentAround(reference.view(), direction, choice.cellSideRadii);
      requireOutside(scene, segment.left, "view segment, left end");
      requireOutside(scene, segment.right, "view segment, right end");
    }
  }
}

ReferenceImages buildReferenceImages(const CameraChoice& choice, const PinholeCamera& reference,
                                     const PackedScene& scene, const Progress& progress) {
  requireViewpointsOutside(scene, choice, reference);
  return buildReferenceImages(choice, reference, meshForView(scene, choice, reference), progress);
}

}  // namespace ocelli
