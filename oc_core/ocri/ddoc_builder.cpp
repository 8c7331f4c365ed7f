#include "oc_core/ocri/ddoc_builder.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

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

bool isHarmful(const DistortionSplat& splat, int harm, const DdocOptions& options) {
  return static_cast<float>(harm) > options.harmlessPerHiddenPixel * splat.hidden;
}

/// "Do no harm": shrinks the splats that hide visible samples.
void shrinkHarmful(std::vector<DistortionSplat>& splats, const Harm& harm, const DdocOptions& options) {
  for (size_t i = 0; i < splats.size(); ++i) {
    if (isHarmful(splats[i], harm.ofSplats[i], options)) {
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

class DdocConstruction {
 public:
  /// Steps 1 to 4. All must outlive it.
  DdocConstruction(const PinholeCamera& reference, const Mesh& mesh, const DdocOptions& options,
                   const Progress& progress, const SceneRenderer* renderer)
      : reference_(reference), mesh_(mesh), options_(options), progress_(progress), renderer_(renderer) {
    report(progress_, "depth edges", 0);
    projected_ = projectedFor(reference, mesh, renderer);
    seen_ = projected_ ? rasterize(*projected_) : renderer->draw(reference);
    splats_ = makeSplats(findEdges(reference, seen_, options), reference, options);
    owners_ = claimPixels(splats_, seen_.width(), seen_.height());
    shrinkConflicts(splats_, owners_, options.conflicts, options.maxHiddenPerRoom);
  }

  const std::vector<DistortionSplat>& splats() const { return splats_; }

  /// Steps 5 and 6, and the rounds of feedback.
  Built cold() {
    DdocCamera camera = cameraOfSplats();
    noteWholeBands();
    TrianglePart part = displaced(camera);
    HarmMeter meter(reference_, mesh_, seen_, part, options_.feedbackSubdivision, renderer_);
    for (int round = 0; round < options_.feedbackRounds; ++round) {
      report(progress_, "do no harm", static_cast<double>(round) / options_.feedbackRounds);
      const Harm harm = meter.measure(camera, splats_, owners_);
      if (harm.missing == 0) {
        break;
      }
      shrinkHarmful(splats_, harm, options_);
      camera = cameraOfSplats();
    }
    report(progress_, "do no harm", 1);
    return {std::move(seen_), std::move(camera), std::move(part)};
  }

  /// Steps 5 and 6 with bands of which so much is kept, without rounds.
  Built warm(const std::vector<float>& kept) {
    limitBandGrowth(splats_, options_.steepestBandGrowth);
    noteWholeBands();
    for (size_t i = 0; i < splats_.size(); ++i) {
      splats_[i].hidden *= kept[i];
    }
    DdocCamera camera = cameraOfSplats();
    TrianglePart part = displaced(camera);
    return {std::move(seen_), std::move(camera), std::move(part)};
  }

  /// What is left of the bands that the parallax asks for.
  std::vector<float> kept() const {
    std::vector<float> kept(splats_.size(), 1.0f);
    for (size_t i = 0; i < kept.size(); ++i) {
      kept[i] = wholeBands_[i] > 0 ? std::min(splats_[i].hidden / wholeBands_[i], 1.0f) : 1.0f;
    }
    return kept;
  }
  /// The same for the next image, after what this one shows.
  std::vector<float> keptAfter(const ReferenceImage& image, const Built& built) const {
    const HarmMeter meter(reference_, mesh_, built.seen, built.part, options_.feedbackSubdivision, renderer_);
    const Harm harm = meter.measureIn(image, built.camera, splats_, owners_);
    std::vector<float> next = kept();
    for (size_t i = 0; i < next.size(); ++i) {
      next[i] = isHarmful(splats_[i], harm.ofSplats[i], options_) ? std::max(next[i] * kShrinkOfNext, leastKept())
                                                                  : std::min(next[i] * kGrowthOfNext, 1.0f);
    }
    return next;
  }

 private:
  // One image judges less surely than rounds of feedback on one view: bands shrink less for it, and grow back in some
  // images. Found over ways of heads by bench/warm_start_bench: errors are least between here and twice as fast.
  static constexpr float kShrinkOfNext = 0.7f;
  static constexpr float kGrowthOfNext = 1.05f;

  /// What the rounds of a cold start leave at the least.
  float leastKept() const { return std::pow(options_.feedbackShrink, static_cast<float>(options_.feedbackRounds)); }

  void noteWholeBands() {
    wholeBands_.clear();
    for (const DistortionSplat& splat : splats_) {
      wholeBands_.push_back(splat.hidden);
    }
  }
  DdocCamera cameraOfSplats() {
    limitBandGrowth(splats_, options_.steepestBandGrowth);
    owners_ = options_.reclaimPixels ? claimPixels(splats_, seen_.width(), seen_.height()) : std::move(owners_);
    return DdocCamera(reference_, mapOf(splats_, owners_, options_));
  }
  TrianglePart displaced(const DdocCamera& camera) const {
    return projected_ ? displacedPart(camera, projected_) : TrianglePart{};
  }

  const PinholeCamera& reference_;
  const Mesh& mesh_;
  const DdocOptions& options_;
  const Progress& progress_;
  const SceneRenderer* renderer_;
  std::shared_ptr<const ProjectedMesh> projected_;
  FragmentImage seen_;
  std::vector<DistortionSplat> splats_;
  SplatOwners owners_;
  std::vector<float> wholeBands_;  ///< hidden bands of the splats, before any feedback
};

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
  return DdocConstruction(reference, mesh, options, progress, renderer).cold().camera;
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
  return imageOf(DdocConstruction(reference, mesh, options, progress, renderer).cold(), mesh, options.subdivision,
                 renderer);
}

NextDdocImage buildNextDdocImage(const PinholeCamera& reference, const Mesh& mesh, const DdocOptions& options,
                                 BandMemory& memory, const Progress& progress, const SceneRenderer* renderer) {
  DdocConstruction construction(reference, mesh, options, progress, renderer);
  BandMemory::Recalled recalled;
  if (options.feedbackRounds > 0 && memory.eye() &&
      glm::distance(*memory.eye(), reference.eye()) <= options.cellSideRadii / 2) {
    recalled = memory.recall(reference, construction.splats());
  }
  const bool warm = 2 * recalled.known > construction.splats().size();
  const Built built = warm ? construction.warm(recalled.kept) : construction.cold();
  NextDdocImage next{imageOf(built, mesh, options.subdivision, renderer), warm};
  memory.remember(reference, construction.splats(),
                  warm ? construction.keptAfter(next.image, built) : construction.kept());
  return next;
}

}  // namespace ocelli
