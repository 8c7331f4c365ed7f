#include "python/bindings/options.h"

#include "oc_core/base/json_fields.h"
#include "oc_core/ocri/ray_map_kind.h"

namespace ocelli {

CameraChoice cameraChoiceOf(const CameraArgument& camera, const ViewCell& cell) {
  if (const auto* rays = std::get_if<std::shared_ptr<RayMap>>(&camera)) {
    return rayMapChoice(*rays);
  }
  const nlohmann::json parsed = parseJson(std::get<std::string>(camera), kCameraOptions);
  return readAs("oc_core/ocri/camera.schema.json", [&] {
    JsonFields fields(parsed, kCameraOptions);
    CameraChoice choice = readCameraChoice(fields, cell);
    fields.rejectUnknown();
    return choice;
  });
}

}  // namespace ocelli
