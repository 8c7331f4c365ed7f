#include "oc_core/ocri/ddoc_builder.h"

#include <algorithm>

#include "oc_core/ocri/construction.h"
#include "oc_core/ocri/depth_edges.h"
#include "oc_core/ocri/harm_meter.h"
#include "oc_core/ocri/image_mesh.h"

namespace ocelli {
namespace {

std::vector<DepthEdge> findEdges(const PinholeCamera& camera, const FragmentImage& seen, const DdocOptions& options) {
  Image<float> inverseZ(seen.width(), seen.height(), 0);
  std::transform(seen.begin(), seen.end(), inverseZ.begin(),
                 [](const Fragment& f) { return f.covered() ? 1 / f.t : 0; });
  DepthEdgeOptions edgeOptions;
  // A step counts when the view cell can uncover a pixel behind it.
  edgeOptions.minInverseZStep = 1 / (camera.focalPixels() * options.cellSideRadii / 2);
  edgeOptions.minZStep = options.edgeDepthStepRadii;
  // What lies behind everything has no depth of its own: it takes that of the farthest sample.
  float farthest = 0;
  for (const float w : inverseZ) {
    farthest = w > 0 && (farthest == 0 || w < farthest) ? w : farthest;
  }
  edgeOptions.backgroundInverseZ = farthest;
  return findDepthEdges(inverseZ, edgeOptions);
}

/// The parallax between occluder and background, in pixels, over the view cell: a step of the eye along the normal n of
/// the edge uncovers f * step * (1/zn - 1/zf). The longest step within a square along n is its support |nx| + |ny| half
/// sides.
float uncoveredPixels(const DepthEdge& edge, const PinholeCamera& camera, const DdocOptions& options) {
  const float support = options.cellSideRadii / 2 * (std::abs(edge.normal.x) + std::abs(edge.normal.y));
  return camera.focalPixels() * support * (edge.inverseNear - edge.inverseFar);
}

std::vector<DistortionSplat> makeSplats(const std::vector<DepthEdge>& edges, const PinholeCamera& camera,
                                        const DdocOptions& options) {
  std::vector<DistortionSplat> splats;
  for (const DepthEdge& edge : edges) {
    DistortionSplat splat{edge, options.constantRadiusPixels, options.constantRadiusPixels};
    if (options.radius == DdocOptions::Radius::kViewCell) {
      splat.hidden = std::min(uncoveredPixels(edge, camera, options) * options.safetyFactor, options.maxHiddenPixels);
      splat.room = splat.hidden * options.roomPerHidden;
    }
    splats.push_back(splat);
  }
  return splats;
}

DistortionMap mapOf(const std::vector<DistortionSplat>& splats, const SplatOwners& owners, const DdocOptions& options) {
  if (options.smoothingSigmaPixels <= 0) {
    return finalizeMap(splats, owners, DistortionMap::Lookup::kNearest);
  }
  return smoothMap(finalizeMap(splats, owners, DistortionMap::Lookup::kBilinear), options.smoothingSigmaPixels);
}

/// "Do no harm": shrinks the splats that hide visible samples.
void shrinkHarmful(std::vector<DistortionSplat>& splats, const Harm& harm, const DdocOptions& options) {
  for (size_t i = 0; i < splats.size(); ++i) {
    if (static_cast<float>(harm.ofSplats[i]) > options.harmlessPerHiddenPixel * splats[i].hidden) {
      splats[i].hidden *= options.feedbackShrink;
    }
  }
}

/// What all drawing of the mesh starts from; nothing where another draws it.
std::shared_ptr<const ProjectedMesh> projectedFor(const PinholeCamera& reference, const Mesh& mesh,
                                                  const SceneRenderer* renderer) {
  return renderer == nullptr ? std::make_shared<const ProjectedMesh>(reference, mesh) : nullptr;
}

/// A camera under construction with what its image can share.
struct Built {
  FragmentImage seen;  ///< by the reference pinhole
  DdocCamera camera;
  TrianglePart part;  ///< what the camera may displace; nothing where another draws it
};

Built construct(const PinholeCamera& reference, const Mesh& mesh, const DdocOptions& options, const Progress& progress,
                const SceneRenderer* renderer) {
  // Steps 1 and 2.
  report(progress, "depth edges", 0);
  const std::shared_ptr<const ProjectedMesh> projected = projectedFor(reference, mesh, renderer);
  FragmentImage seen = projected ? rasterize(*projected) : renderer->draw(reference);
  const std::vector<DepthEdge> edges = findEdges(reference, seen, options);

  // Steps 3 to 6.
  std::vector<DistortionSplat> splats = makeSplats(edges, reference, options);
  SplatOwners owners = claimPixels(splats, seen.width(), seen.height());
  shrinkConflicts(splats, owners, options.conflicts, options.maxHiddenPerRoom);
  const auto cameraOfSplats = [&] {
    limitBandGrowth(splats, options.steepestBandGrowth);
    owners = options.reclaimPixels ? claimPixels(splats, seen.width(), seen.height()) : owners;
    return DdocCamera(reference, mapOf(splats, owners, options));
  };
  DdocCamera camera = cameraOfSplats();
  TrianglePart part = projected ? displacedPart(camera, projected) : TrianglePart{};

  HarmMeter meter(reference, mesh, seen, part, options.feedbackSubdivision, renderer);
  for (int round = 0; round < options.feedbackRounds; ++round) {
    report(progress, "do no harm", static_cast<double>(round) / options.feedbackRounds);
    const Harm harm = meter.measure(camera, splats, owners);
    if (harm.missing == 0) {
      break;
    }
    shrinkHarmful(splats, harm, options);
    camera = cameraOfSplats();
  }
  report(progress, "do no harm", 1);
  return {std::move(seen), std::move(camera), std::move(part)};
}

ReferenceImage imageOf(const Built& built, const Mesh& mesh, const SubdivisionOptions& options,
                       const SceneRenderer* renderer) {
  const PinholeCamera& reference = built.camera.reference();
  const FragmentImage fragments = renderer != nullptr ? renderer->draw(built.camera, built.seen, options)
                                                      : rasterize(built.camera, built.seen, built.part, options);
  // Most samples are the pinhole's own.
  ReferenceImage image = referenceImage(built.seen, mesh, reference, "ddoc");
  image.triangleBound = imageMeshTriangles(image);
  updateReferenceImage(image, built.seen, fragments, mesh, reference);
  return image;
}

}  // namespace

DdocOptions DdocOptions::paper(float constantRadiusPixels) {
  DdocOptions options;
  options.radius = Radius::kConstant;
  options.constantRadiusPixels = constantRadiusPixels;
  options.conflicts = Conflicts::kAll;
  options.roomPerHidden = 1;
  options.maxHiddenPerRoom = 1;
  options.feedbackRounds = 0;
  options.steepestBandGrowth = 0;
  options.smoothingSigmaPixels = 0;
  return options;
}

DdocOptions DdocOptions::literal() {
  DdocOptions options = paper();
  options.edgeDepthStepRadii = kPaperDepthStepRadii;
  options.reclaimPixels = false;
  return options;
}

DdocCamera buildDdocCamera(const PinholeCamera& reference, const Mesh& mesh, const DdocOptions& options,
                           const Progress& progress, const SceneRenderer* renderer) {
  return construct(reference, mesh, options, progress, renderer).camera;
}

ReferenceImage buildDdocImage(const DdocCamera& camera, const Mesh& mesh, const SubdivisionOptions& options,
                              const SceneRenderer* renderer) {
  const std::shared_ptr<const ProjectedMesh> projected = projectedFor(camera.reference(), mesh, renderer);
  if (!projected) {
    return imageOf({renderer->draw(camera.reference()), camera, {}}, mesh, options, renderer);
  }
  return imageOf({rasterize(*projected), camera, displacedPart(camera, projected)}, mesh, options, renderer);
}

ReferenceImage buildDdocImage(const PinholeCamera& reference, const Mesh& mesh, const DdocOptions& options,
                              const Progress& progress, const SceneRenderer* renderer) {
  return imageOf(construct(reference, mesh, options, progress, renderer), mesh, options.subdivision, renderer);
}

}  // namespace ocelli
