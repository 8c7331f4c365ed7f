#include "python/bindings/options.h"

#include "oc_core/base/json_fields.h"

namespace ocelli {

CameraChoice cameraChoiceFromJson(const std::string& json, const ViewCell& cell) {
  const nlohmann::json parsed = parseJson(json, kCameraOptions);
  return readAs("oc_core/ocri/camera.schema.json", [&] {
    JsonFields fields(parsed, kCameraOptions);
    CameraChoice choice = readCameraChoice(fields, cell);
    fields.rejectUnknown();
    return choice;
  });
}

}  // namespace ocelli
