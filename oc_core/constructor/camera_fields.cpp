#include "oc_core/constructor/camera_fields.h"

namespace ocelli {

glm::dvec3 readVector(JsonFields& fields, const std::string& name) {
  const std::vector<double> numbers = fields.numbers(name, 3, -1e6, 1e6);
  return {numbers[0], numbers[1], numbers[2]};
}

Plane readPlane(const nlohmann::json& json, const std::string& where) {
  JsonFields fields(json, where);
  const glm::dvec3 point = readVector(fields, "point");
  const glm::dvec3 normal = readVector(fields, "normal");
  if (!(glm::length(normal) > 1e-9)) {
    fields.fail("normal", "has no length");
  }
  fields.rejectUnknown();
  return Plane::through(point, normal);
}

PinholeCamera readRoot(JsonFields& fields, const PinholeCamera& reference) {
  if (!fields.has("view")) {
    return reference;
  }
  return {viewFromJsonText(fields.value("view").dump(), fields.where() + ", \"view\""), reference.width(),
          reference.height()};
}

nlohmann::ordered_json jsonOf(const glm::dvec3& vector) {
  return {vector.x, vector.y, vector.z};
}

nlohmann::ordered_json jsonOf(const Plane& plane) {
  return {{"point", jsonOf(plane.normal * plane.distance)}, {"normal", jsonOf(plane.normal)}};
}

nlohmann::ordered_json jsonOf(const View& view) {
  return nlohmann::ordered_json::parse(jsonText(view));
}

}  // namespace ocelli
