#include "oc_core/camera/view.h"

#include <array>
#include <cmath>
#include <glm/geometric.hpp>

#include "oc_core/base/error.h"
#include "oc_core/base/json_fields.h"

namespace ocelli {
namespace {

constexpr double kMaxCoordinate = 1e6;
constexpr float kMaxCenterShift = 10;

template <int kLength>
glm::vec<kLength, float> readVector(JsonFields& fields, const std::string& name,
                                    const glm::vec<kLength, float>& otherwise) {
  if (!fields.has(name)) {
    return otherwise;
  }
  const std::vector<double> numbers = fields.numbers(name, kLength, -kMaxCoordinate, kMaxCoordinate);
  glm::vec<kLength, float> vector;
  for (int i = 0; i < kLength; ++i) {
    vector[i] = static_cast<float>(numbers[static_cast<size_t>(i)]);
  }
  return vector;
}

std::array<double, 3> asArray(const glm::vec3& v) {
  return {v.x, v.y, v.z};
}

}  // namespace

double View::resolvedFovVerticalDegrees() const {
  if (fovVerticalDegrees > 0) {
    return fovVerticalDegrees;
  }
  return degreesFromRadians(2 * std::asin(1.0 / std::max(1.0f, glm::distance(eye, target))));
}

void validate(const View& view, const std::string& where) {
  const glm::vec3 direction = view.target - view.eye;
  const float distance = glm::length(direction);
  if (!std::isfinite(distance) || !std::isfinite(glm::length(view.up)) || !std::isfinite(view.fovVerticalDegrees) ||
      !std::isfinite(view.zNear) || !std::isfinite(view.zFar)) {
    throw InputError("the view has a number that is not finite", where, "give finite numbers");
  }
  if (distance < 1e-6f) {
    throw InputError("the eye of the view is at its target, so it has no direction", where,
                     "move \"eye\" or \"target\"");
  }
  if (glm::length(view.up) < 1e-6f || glm::length(glm::cross(direction / distance, glm::normalize(view.up))) < 1e-4f) {
    throw InputError("\"up\" of the view is parallel to its direction", where, "choose another \"up\"");
  }
  if (view.fovVerticalDegrees == 0 && distance <= 1.001f) {
    throw InputError("the eye is within the unit sphere around its target, so no field of view holds that sphere",
                     where, "move \"eye\" away or give \"fov_vertical_degrees\"");
  }
  if (view.fovVerticalDegrees < 0 || view.resolvedFovVerticalDegrees() >= 179) {
    throw InputError("the vertical field of view must lie between 0 and 179 degrees", where,
                     "change \"fov_vertical_degrees\"");
  }
  if (!(std::abs(view.centerShift.x) <= kMaxCenterShift) || !(std::abs(view.centerShift.y) <= kMaxCenterShift)) {
    throw InputError("the centre of the view is shifted by more than 10 image heights", where,
                     "change \"center_shift\"");
  }
  if (!(view.zNear > 0) || !(view.zFar > view.zNear)) {
    throw InputError("\"z_near\" must be positive and less than \"z_far\"", where, "change them");
  }
}

View viewFromJsonText(const std::string& text, const std::string& where) {
  return readAs("oc_core/camera/view.schema.json", [&] {
    const nlohmann::json json = parseJson(text, where);
    JsonFields fields(json, where);
    View view;
    view.eye = readVector<3>(fields, "eye", view.eye);
    view.target = readVector<3>(fields, "target", view.target);
    view.up = readVector<3>(fields, "up", view.up);
    view.fovVerticalDegrees = fields.number("fov_vertical_degrees", 0, 179, 0);
    view.zNear = static_cast<float>(fields.number("z_near", 1e-6, 1e6, view.zNear));
    view.zFar = static_cast<float>(fields.number("z_far", 1e-6, 1e9, view.zFar));
    view.centerShift = readVector<2>(fields, "center_shift", view.centerShift);
    fields.rejectUnknown();
    validate(view, where);
    return view;
  });
}

View readView(const std::filesystem::path& path) {
  return viewFromJsonText(readJsonFile(path).dump(), path.string());
}

std::string jsonText(const View& view) {
  nlohmann::ordered_json json;
  json["eye"] = asArray(view.eye);
  json["target"] = asArray(view.target);
  json["up"] = asArray(view.up);
  json["fov_vertical_degrees"] = view.resolvedFovVerticalDegrees();
  json["z_near"] = view.zNear;
  json["z_far"] = view.zFar;
  if (view.centerShift != glm::vec2(0)) {
    json["center_shift"] = {view.centerShift.x, view.centerShift.y};
  }
  return textOfJson(json);
}

View movedEye(const View& view, const glm::vec3& offset) {
  const glm::vec3 backward = glm::normalize(view.eye - view.target);
  const glm::vec3 right = glm::normalize(glm::cross(view.up, backward));
  const glm::vec3 up = glm::cross(backward, right);
  View moved = view;
  moved.eye += right * offset.x + up * offset.y + backward * offset.z;
  moved.fovVerticalDegrees = view.resolvedFovVerticalDegrees();
  return moved;
}

}  // namespace ocelli
