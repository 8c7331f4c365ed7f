#include <algorithm>
#include <array>
#include <iterator>
#include <memory>

#include "oc_core/base/error.h"
#include "oc_core/camera/cylinder_camera.h"
#include "oc_core/camera/gpc_camera.h"
#include "oc_core/camera/panorama_camera.h"
#include "oc_core/ocri/builtin_representations.h"
#include "oc_core/ocri/cast_representation.h"
#include "oc_core/ocri/corner_depth_images.h"
#include "oc_core/ocri/layered_depth_image.h"
#include "oc_core/ocri/set_difference.h"
#include "oc_core/ocri/simplified_mesh.h"
#include "oc_core/ocri/wide_depth_image.h"
#include "oc_core/render/hybrid_raycast.h"
#include "oc_core/render/points.h"
#include "oc_core/render/rasterize_gpc.h"
#include "oc_core/render/raycast.h"

namespace ocelli {
namespace {

using Inputs = RepresentationInputs;

ViewCell cubeOf(const CameraChoice& choice) {
  return {.sideRadii = choice.cellSideRadii};
}

ViewSegment segmentOf(const Inputs& in, const glm::vec3& direction) {
  return segmentAround(in.reference.view(), direction, in.choice.cellSideRadii);
}

// ---- cameras

SpocCamera spocCamera(const Inputs& in) {
  return buildSpocCamera(in.reference, in.mesh, in.choice.spoc, in.renderer);
}
ReversePinholeCamera reversePinhole(const Inputs& in) {
  return buildReversePinhole(in.reference, in.mesh, in.renderer);
}
DdocCamera ddocCamera(const Inputs& in) {
  return buildDdocCamera(in.reference, in.mesh, in.choice.ddoc, in.progress, in.renderer);
}
EpipolarCamera epipolarCamera(const Inputs& in, const glm::vec3& direction) {
  return buildEpipolarCamera(in.reference, segmentOf(in, direction), in.mesh, in.choice.eoc, in.renderer);
}
CellCamera cellCamera(const Inputs& in) {
  return buildCellCamera(in.reference, in.mesh, in.choice.cell, in.progress, in.renderer);
}

GpcCamera gpcCamera(const Inputs& in) {
  return {in.reference, in.choice.gpc};
}

/// The box around what rays are cast at.
Mesh boxMesh(const RayTarget& target) {
  Mesh mesh;
  const std::array<glm::vec3, 8> corners = cornersOf(target.bounds());
  mesh.positions.assign(corners.begin(), corners.end());
  // The corners of each side in turn, by the numbers of cornersOf().
  constexpr std::array<std::array<uint32_t, 4>, 6> kSides{
      {{0, 2, 6, 4}, {1, 3, 7, 5}, {0, 1, 5, 4}, {2, 3, 7, 6}, {0, 1, 3, 2}, {4, 5, 7, 6}}};
  for (const auto& [a, b, c, d] : kSides) {
    mesh.triangles.emplace_back(a, b, c);
    mesh.triangles.emplace_back(a, c, d);
  }
  return mesh;
}

// ---- their maps

/// Each image is of a pinhole, which it names.
std::vector<CameraMap> pinholeMaps(const Inputs&, const ReferenceImages& images) {
  std::vector<CameraMap> maps;
  for (const ReferenceImage& image : images) {
    maps.push_back(mapOf(PinholeCamera(image.view, image.width(), image.height())));
  }
  return maps;
}

// ---- their images, drawn in another way

[[noreturn]] void refuse(const Inputs& in, const char* how) {
  throw InputError("camera \"" + in.choice.name + "\" is drawn " + how, "--method", "use raster or raycast");
}

/// With what the mesher, and who resamples it, need to know of its samples.
ReferenceImage gpcImage(const FragmentImage& fragments, const Inputs& in) {
  ReferenceImage image = referenceImage(fragments, in.mesh, in.reference, in.choice.name);
  image.layout = in.choice.gpc;
  return image;
}

template <BoundedCamera C>
ReferenceImage drawnBy(Technique technique, const C& camera, const Inputs& in) {
  const auto fragments = [&] {
    switch (technique) {
      case Technique::kPoints:
        return renderPoints(camera, in.mesh);
      case Technique::kHybrid:
        return hybridRaycast(camera, in.mesh);
      case Technique::kRaycast:
        return castAlongRays(camera, in);
    }
    OC_CHECK(false, "every technique draws");
  };
  return referenceImage(fragments(), in.mesh, in.reference, in.choice.name);
}

// ---- what of a scene they look at (representation_kind.h)

std::optional<ViewedPart> viewedFromEye(const CameraChoice&, const PinholeCamera&) {
  return ViewedPart{};
}

/// The same with more detail.
std::optional<ViewedPart> viewedZoomed(const CameraChoice& choice, const PinholeCamera&) {
  ViewedPart part;
  for (const GpcRegion& region : choice.gpc.regions) {
    part.detail = std::max(part.detail, region.zoom);
  }
  return part;
}

/// What a pinhole displaces into its image.
std::optional<ViewedPart> viewedDisplaced(const CameraChoice& choice, const PinholeCamera&) {
  constexpr float kBetweenPixels = 4;
  const float longest = std::max(choice.ddoc.maxHiddenPixels, choice.ddoc.constantRadiusPixels);
  return ViewedPart{.marginPixels = 2 * longest + kBetweenPixels};
}

/// From viewpoints that far away that look at the same target.
std::optional<ViewedPart> viewedWithin(float reach, const PinholeCamera& reference) {
  const View& view = reference.view();
  const glm::vec3 step = view.target - view.eye;
  const float distance = glm::length(step);
  constexpr float kUpright = 0.9f;  // nearer to their up directions viewpoints roll
  if (reach >= distance / 2 || std::abs(glm::dot(step, glm::normalize(view.up))) > kUpright * distance) {
    return std::nullopt;
  }
  const float f = reference.focalPixels();
  const float half = static_cast<float>(std::max(reference.width(), reference.height())) *
                     (0.5f + std::max(std::abs(view.centerShift.x), std::abs(view.centerShift.y)));
  // How far a point at the border moves where the view turns by that angle, and comes nearer by that share.
  const float angle = reach / (distance - reach);
  return ViewedPart{reach, angle * (f + 2 * half + half * half / f)};
}

std::optional<ViewedPart> viewedFromCell(const CameraChoice& choice, const PinholeCamera& reference) {
  return viewedWithin(choice.cellSideRadii * 0.8661f, reference);  // half the diagonal of a cube
}

std::optional<ViewedPart> viewedFromSegment(const CameraChoice& choice, const PinholeCamera& reference) {
  std::optional<ViewedPart> part = viewedWithin(choice.cellSideRadii / 2, reference);
  const glm::vec3 along = glm::normalize(choice.segmentDirection);
  if (part && std::max({std::abs(along.x), std::abs(along.y), std::abs(along.z)}) < 0.999f) {
    // The image is rolled, and holds the reference's.
    part->marginPixels += static_cast<float>(std::max(reference.width(), reference.height())) / 2;
  }
  return part;
}

// ---- images of several cameras

ReferenceImages layeredDepthImage(const Inputs& in) {
  ReferenceImages images = buildLayeredDepthImage(in.reference, in.mesh, in.choice.count, in.renderer);
  for (size_t i = 0; i < images.size(); ++i) {
    images[i].layer = static_cast<int>(i);
  }
  return images;
}

ReferenceImages spocUnion(const Inputs& in) {
  ReferenceImages images{buildDepthImage(in.reference, in.mesh, in.renderer),
                         buildSpocImage(spocCamera(in), in.mesh, in.renderer)};
  subtract(images[1], images[0], [&](const glm::vec3& point) { return in.reference.project(point); });
  images[1].triangleBound = 0;
  return images;
}

/// Two EOCs whose segments cross at the reference eye, and a DDOC if wanted; each without what those before it hold.
ReferenceImages crossedEocs(const Inputs& in, bool withDdoc) {
  ReferenceImages images;
  std::vector<Projection> projections;
  const auto add = [&](ReferenceImage image, Projection projection) {
    for (size_t i = 0; i < images.size(); ++i) {
      subtract(image, images[i], projections[i]);
    }
    image.triangleBound = 0;
    images.push_back(std::move(image));
    projections.push_back(std::move(projection));
  };
  for (const glm::vec3& direction : {kHorizontalSegment, kVerticalSegment}) {
    const auto camera = std::make_shared<EpipolarCamera>(epipolarCamera(in, direction));
    add(buildEocImage(*camera, in.mesh, in.renderer),
        [camera](const glm::vec3& point) { return camera->project(point); });
  }
  if (withDdoc) {
    const auto camera = std::make_shared<DdocCamera>(ddocCamera(in));
    add(buildDdocImage(*camera, in.mesh, in.choice.ddoc.subdivision, in.renderer),
        [camera](const glm::vec3& point) { return camera->project(point); });
  }
  return images;
}

// ---- rows

/// One list after the other, without what came before.
std::vector<const CameraOption*> joined(std::initializer_list<std::vector<const CameraOption*>> lists) {
  std::vector<const CameraOption*> all;
  for (const auto& list : lists) {
    std::copy_if(list.begin(), list.end(), std::back_inserter(all),
                 [&](const CameraOption* option) { return std::find(all.begin(), all.end(), option) == all.end(); });
  }
  return all;
}

RepresentationKind cornersRow(const char* name, const char* description, int count) {
  return {.name = name,
          .description = description,
          .options = {&kCellSide},
          .prepare = [count](CameraChoice& choice) { choice.count = count; },
          .images =
              [](const Inputs& in) {
                return buildCornerDepthImages(in.reference, in.mesh, cubeOf(in.choice), in.choice.count, in.renderer);
              },
          .viewed = viewedFromCell,
          .maps = pinholeMaps};
}

class DdocSequence final : public ImageSequence {
 public:
  Next next(const Inputs& in) override {
    NextDdocImage next = buildNextDdocImage(in.reference, in.mesh, in.choice.ddoc, memory_, in.progress, in.renderer);
    return {{std::move(next.image)}, next.warm};
  }

 private:
  BandMemory memory_;
};

RepresentationKind ddocRow(const char* name, const char* description, std::function<void(CameraChoice&)> prepare) {
  return {.name = name,
          .description = description,
          .options = joined({{&kCellSide}, ddocOptions()}),
          .prepare = std::move(prepare),
          .images = [](const Inputs& in) -> ReferenceImages {
            return {buildDdocImage(in.reference, in.mesh, in.choice.ddoc, in.progress, in.renderer)};
          },
          .sequence = [] { return std::make_unique<DdocSequence>(); },
          .rayCrossover = RayCrossover::kDdoc,
          .viewed = viewedDisplaced,
          .draw = [](Technique technique, const Inputs& in) { return drawnBy(technique, ddocCamera(in), in); },
          .maps = [](const Inputs& in, const ReferenceImages&) -> std::vector<CameraMap> {
            return {mapOf(ddocCamera(in))};
          }};
}

RepresentationKind eocRow(const char* name, const char* description, const glm::vec3& direction,
                          const EocOptions& options = {}) {
  return {.name = name,
          .description = description,
          .options = joined({{&kCellSide, &kSegmentDirection}, eocOptions()}),
          .prepare =
              [direction, options](CameraChoice& choice) {
                choice.segmentDirection = direction;
                choice.eoc = options;
                choice.ddoc.edgeDepthStepRadii = options.edgeDepthStepRadii;
              },
          .images = [](const Inputs& in) -> ReferenceImages {
            return {buildEocImage(in.reference, segmentOf(in, in.choice.segmentDirection), in.mesh, in.choice.eoc,
                                  in.renderer)};
          },
          .rayCrossover = RayCrossover::kEoc,
          .segments = [](const CameraChoice& choice) { return std::vector{choice.segmentDirection}; },
          .viewed = viewedFromSegment,
          .draw =
              [](Technique technique, const Inputs& in) {
                if (technique != Technique::kRaycast) {
                  refuse(in, "by epipolar spans or ray casting");
                }
                const EpipolarCamera camera = epipolarCamera(in, in.choice.segmentDirection);
                return eocImage(castAlongRays(camera, in), camera, in.mesh);
              },
          .maps = [](const Inputs& in, const ReferenceImages&) -> std::vector<CameraMap> {
            return {mapOf(epipolarCamera(in, in.choice.segmentDirection))};
          }};
}

RepresentationKind crossedRow(const char* name, const char* description, bool withDdoc) {
  return {
      .name = name,
      .description = description,
      .options = withDdoc ? joined({{&kCellSide}, eocOptions(), ddocOptions()}) : joined({{&kCellSide}, eocOptions()}),
      .images = [withDdoc](const Inputs& in) { return crossedEocs(in, withDdoc); },
      .rayCrossover = RayCrossover::kEoc,
      .segments =
          [](const CameraChoice&) {
            return std::vector{kHorizontalSegment, kVerticalSegment};
          },
      .viewed =
          [withDdoc](const CameraChoice& choice, const PinholeCamera& reference) {
            std::optional<ViewedPart> part = viewedWithin(choice.cellSideRadii / 2, reference);
            if (part && withDdoc) {
              part->marginPixels = std::max(part->marginPixels, viewedDisplaced(choice, reference)->marginPixels);
            }
            return part;
          },
      .maps =
          [withDdoc](const Inputs& in, const ReferenceImages&) {
            std::vector<CameraMap> maps{mapOf(epipolarCamera(in, kHorizontalSegment)),
                                        mapOf(epipolarCamera(in, kVerticalSegment))};
            if (withDdoc) {
              maps.push_back(mapOf(ddocCamera(in)));
            }
            return maps;
          }};
}

/// A camera that displaces no pinhole's image, made of the reference alone.
template <class C>
RepresentationKind castRow(const char* name, const char* description) {
  RepresentationKind row = castRepresentation(
      name, description, [](const Inputs& in) { return C(in.reference); }, C::kWrapsAround);
  row.ofViewAlone = true;
  return row;
}

RepresentationKind meshRow(const char* name, const char* description,
                           std::function<Mesh(const Mesh& mesh, size_t triangles)> mesh) {
  return {.name = name, .description = description, .mesh = std::move(mesh)};
}

}  // namespace

std::vector<RepresentationKind> builtinRepresentations() {
  std::vector<RepresentationKind> rows;
  rows.push_back(
      {.name = "di",
       .description = "depth image of the planar pinhole camera (ppc is the same)",
       .otherName = "ppc",
       .images = [](const Inputs& in) -> ReferenceImages {
         return {buildDepthImage(in.reference, in.mesh, in.renderer)};
       },
       .rayCrossover = RayCrossover::kDepthImage,
       .refitShare = RefitShare::kDepthImage,
       .viewed = viewedFromEye,
       .draw = [](Technique technique, const Inputs& in) { return drawnBy(technique, in.reference, in); },
       .maps = [](const Inputs& in, const ReferenceImages&) -> std::vector<CameraMap> { return {mapOf(in.reference)}; },
       .ofViewAlone = true});
  rows.push_back({.name = "di-wide",
                  .description = "depth image as wide as what the view cell sees beside the reference frustum",
                  .options = {&kCellSide},
                  .images = [](const Inputs& in) -> ReferenceImages {
                    const bool hasMesh = in.renderer == nullptr || in.renderer->hasMesh();
                    const float factor =
                        wideFactor(in.reference, hasMesh ? in.mesh : boxMesh(*in.renderer->rays()), cubeOf(in.choice));
                    return {buildWideDepthImage(in.reference, in.mesh, factor, in.renderer)};
                  },
                  .maps = pinholeMaps});
  rows.push_back(cornersRow(
      "corners-4", "depth images of the reference view and of the four corners of the view cell nearest to the scene",
      4));
  rows.push_back(cornersRow("corners-8", "the same with all eight corners", 8));
  rows.push_back({.name = "ldi-4",
                  .description = "layered depth image of four layers (any number from ldi-1 to ldi-16)",
                  .prepare = [](CameraChoice& choice) { choice.count = 4; },
                  .maxCount = kMaxLayers,
                  // Which sides of its surfaces are seen tells an object as a whole, so it looks at all of the scene.
                  .images = layeredDepthImage,
                  .maps = pinholeMaps,
                  .needsCpu = "peels layers, which only rasterisation on the CPU does"});
  rows.push_back(
      {.name = "rppc",
       .description = "reverse pinhole: its straight rays meet behind the scene",
       .images = [](const Inputs& in) -> ReferenceImages {
         return {buildReversePinholeImage(reversePinhole(in), in.reference, in.mesh, in.renderer)};
       },
       .draw = [](Technique technique, const Inputs& in) { return drawnBy(technique, reversePinhole(in), in); },
       .maps = [](const Inputs& in, const ReferenceImages&) -> std::vector<CameraMap> {
         return {mapOf(reversePinhole(in))};
       }});
  rows.push_back(
      {.name = "gpc",
       .description = "general pinhole: regions of the image that show more detail than the rest",
       .structures = gpcStructures(),
       .images = [](const Inputs& in) -> ReferenceImages {
         const GpcCamera camera = gpcCamera(in);
         return {gpcImage(in.renderer != nullptr ? in.renderer->draw(camera) : rasterizeGpc(camera, in.mesh), in)};
       },
       .rayCrossover = RayCrossover::kDepthImage,
       .refitShare = RefitShare::kDepthImage,
       .viewed = viewedZoomed,
       .draw =
           [](Technique technique, const Inputs& in) {
             ReferenceImage image = drawnBy(technique, gpcCamera(in), in);
             image.layout = in.choice.gpc;
             return image;
           },
       .maps = [](const Inputs& in, const ReferenceImages&) -> std::vector<CameraMap> {
         return {mapOf(gpcCamera(in))};
       },
       .layout = [](const CameraChoice& choice) { return choice.gpc; },
       .ofViewAlone = true});
  rows.push_back({.name = "spoc",
                  .description = "single pole occlusion camera around the foreground",
                  .options = spocOptions(),
                  .images = [](const Inputs& in) -> ReferenceImages {
                    return {buildSpocImage(spocCamera(in), in.mesh, in.renderer)};
                  },
                  .rayCrossover = RayCrossover::kSpoc,
                  .draw = [](Technique technique, const Inputs& in) { return drawnBy(technique, spocCamera(in), in); },
                  .maps = [](const Inputs& in, const ReferenceImages&) -> std::vector<CameraMap> {
                    return {mapOf(spocCamera(in))};
                  }});
  rows.push_back({.name = "di+spoc",
                  .description = "depth image, and what the single pole occlusion camera adds to it",
                  .options = spocOptions(),
                  .images = spocUnion,
                  .rayCrossover = RayCrossover::kSpoc,
                  .maps = [](const Inputs& in, const ReferenceImages&) -> std::vector<CameraMap> {
                    return {mapOf(in.reference), mapOf(spocCamera(in))};
                  }});
  rows.push_back(ddocRow("ddoc", "depth discontinuity occlusion camera, radii from the view cell", {}));
  rows.push_back(ddocRow("ddoc-constant", "the same as the dissertation has it, with a constant radius of 15 pixels",
                         [](CameraChoice& choice) { choice.ddoc = DdocOptions::paper(); }));
  rows.push_back(ddocRow("ddoc-paper", "the dissertation's to the letter: edges on z, and its step 5 only deletes",
                         [](CameraChoice& choice) { choice.ddoc = DdocOptions::literal(); }));
  rows.push_back(eocRow("eoc-h", "epipolar occlusion camera for a horizontal segment as long as the view cell",
                        kHorizontalSegment));
  rows.push_back(eocRow("eoc-v", "the same for a vertical segment", kVerticalSegment));
  rows.push_back(eocRow("eoc-forward", "the same for a segment along the view", kForwardSegment));
  rows.push_back(eocRow("eoc-paper", "eoc-h as the dissertation has it: edges on z, gaps where nothing is hidden",
                        kHorizontalSegment, EocOptions::literal()));
  rows.push_back(crossedRow("eoc-hv", "union of eoc-h and of what eoc-v adds to it", false));
  rows.push_back(crossedRow("eoc-hv+ddoc", "union of eoc-hv and of what ddoc adds to it", true));
  rows.push_back(
      {.name = "cell",
       .description = "view-region occlusion camera: what is seen from anywhere in the view cell, in one image",
       .options = joined({{&kCellSide}, cellOptions()}),
       .images = [](const Inputs& in) -> ReferenceImages {
         return {buildCellImage(in.reference, in.mesh, in.choice.cell, in.progress, in.renderer)};
       },
       .rayCrossover = RayCrossover::kCell,
       .viewed =
           [](const CameraChoice& choice, const PinholeCamera& reference) {
             return viewedWithin(choice.cell.cell.sideRadii * 0.8661f, reference);
           },
       .draw =
           [](Technique technique, const Inputs& in) {
             if (technique != Technique::kRaycast) {
               refuse(in, "from several viewpoints, not by points or hybrid rays");
             }
             const CellCamera camera = cellCamera(in);
             return cellImage(camera, castAlongRays(camera, in), in.mesh);
           },
       .maps = [](const Inputs& in, const ReferenceImages&) -> std::vector<CameraMap> {
         return {mapOf(cellCamera(in))};
       }});
  rows.push_back(castRow<PanoramaCamera>(
      "panorama", "all directions from the eye, 360 by 180 degrees, as an equirectangular image (--size 1440x720)"));
  rows.push_back(castRow<CylinderCamera>(
      "cylinder", "360 degrees around the eye's up direction; vertical lines stay straight (--size 1440x360)"));
  rows.push_back(meshRow("simplified", "the scene with as many triangles as the depth image's mesh: a mesh, no image",
                         [](const Mesh& mesh, size_t triangles) {
                           return simplifyMesh(mesh, triangles, SimplifyMethod::kTopological).mesh;
                         }));
  rows.push_back(meshRow(
      "simplified-sloppy", "the same faster, by clusters of vertices: a mesh, no image",
      [](const Mesh& mesh, size_t triangles) { return simplifyMesh(mesh, triangles, SimplifyMethod::kSloppy).mesh; }));
  rows.push_back(
      meshRow("geometry", "the scene itself: a mesh, no image", [](const Mesh& mesh, size_t) { return mesh; }));
  return rows;
}

}  // namespace ocelli
