#include "oc_core/constructor/camera_fields.h"

#include <cmath>

#include "oc_core/base/error.h"

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

std::optional<glm::ivec2> readSize(JsonFields& fields) {
  if (!fields.has("size")) {
    return std::nullopt;
  }
  JsonFields size = fields.inner("size");
  const glm::ivec2 read(size.integer("width", 1, PinholeCamera::kMaxPixelsASide),
                        size.integer("height", 1, PinholeCamera::kMaxPixelsASide));
  size.rejectUnknown();
  return read;
}

PinholeCamera readRoot(JsonFields& fields, const PinholeCamera& reference) {
  if (const std::optional<glm::ivec2> size = readSize(fields)) {
    // As many rows as the shape asks for, give or take rounding to whole ones.
    const double rows = static_cast<double>(reference.width()) * size->y / size->x;
    if (std::abs(rows - reference.height()) > 1) {
      throw InputError("the camera is made for images of the shape " + std::to_string(size->x) + "x" +
                           std::to_string(size->y) + ", not " + std::to_string(reference.width()) + "x" +
                           std::to_string(reference.height()),
                       fields.where() + ", \"size\"", "draw it with --size of that shape, or make it anew");
    }
  }
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

void writeRoot(nlohmann::ordered_json& json, const PinholeCamera& root) {
  json["view"] = nlohmann::ordered_json::parse(jsonText(root.view()));
  json["size"] = {{"width", root.width()}, {"height", root.height()}};
}

}  // namespace ocelli
