#include "study/views/camera_field.h"

#include <fmt/format.h>

#include "oc_core/base/json_fields.h"

namespace ocelli {

CameraChoice readCameraField(JsonFields& fields, const ViewCell& cell) {
  const nlohmann::json& value = fields.value("camera");
  if (!value.is_string() && !value.is_object()) {
    fields.fail("camera", "must be the name of a camera, or an object with the field \"camera\" and options");
  }
  const nlohmann::json named = value.is_string() ? nlohmann::json{{"camera", value}} : value;
  JsonFields of(named, value.is_string() ? fields.where() : fmt::format("{}, \"camera\"", fields.where()));
  const CameraChoice choice = readCameraChoice(of, cell);
  of.rejectUnknown();
  return choice;
}

}  // namespace ocelli
