#include "oc_core/ocri/ray_map_kind.h"

#include <utility>

#include "oc_core/base/error.h"
#include "oc_core/camera/ray_map_camera.h"
#include "oc_core/ocri/cast_representation.h"

namespace ocelli {
namespace {

RayMapCamera rayMapCamera(const RepresentationInputs& in) {
  const std::shared_ptr<const RayMap>& map = in.choice.rayMap;
  OC_CHECK(map != nullptr, "the camera of a ray map has one");
  const bool isInWorld = map->notes().frame == RayFrame::kWorld;
  return {isInWorld ? map : std::make_shared<const RayMap>(map->placedAt(in.reference.view())),
          {in.reference.width(), in.reference.height()}};
}

/// What rays meet, they see: where else a point of it may be seen is not asked.
FragmentImage castRayMap(const RayMapCamera& camera, const RepresentationInputs& in) {
  CameraRays rays = raysOfCamera(camera);
  rays.project = {};
  std::optional<FragmentImage> cast = in.renderer != nullptr ? in.renderer->drawAlong(rays) : std::nullopt;
  return cast ? *std::move(cast)
              : raycast(rays, in.mesh, RayScene(in.mesh), FragmentImage(camera.width(), camera.height()));
}

ReferenceImage rayMapImage(const RepresentationInputs& in) {
  const RayMapCamera camera = rayMapCamera(in);
  return placedImage(camera, castRayMap(camera, in), in.mesh, in.reference.view(), in.choice.name,
                     camera.wrapsAround());
}

const RepresentationKind& rayMapKind() {
  static const RepresentationKind kind{
      .name = "rays",
      .description = "the rays of a file, of any camera",
      .images = [](const RepresentationInputs& in) -> ReferenceImages { return {rayMapImage(in)}; },
      .rayCrossover = 0,
      .draw =
          [](Technique technique, const RepresentationInputs& in) {
            if (technique != Technique::kRaycast) {
              throw InputError("ray map \"" + in.choice.name + "\" is drawn by ray casting", "--method",
                               "use raycast, or leave it out");
            }
            return rayMapImage(in);
          },
      .maps = [](const RepresentationInputs& in, const ReferenceImages&) -> std::vector<CameraMap> {
        return {mapOf(rayMapCamera(in))};
      },
      .castsRays = true,
      .ofViewAlone = true,
      .needsCpu = "is cast along its rays, which only the CPU does",
      .seesFromReference = false};
  return kind;
}

}  // namespace

CameraChoice rayMapChoice(std::shared_ptr<const RayMap> map) {
  CameraChoice choice;
  choice.kind = &rayMapKind();
  choice.name = map->notes().name;
  choice.rayMap = std::move(map);
  return choice;
}

}  // namespace ocelli
