#include "oc_core/frustum_editor/drawn_edits.h"

#include <cmath>

#include "oc_core/base/json_document.h"

namespace ocelli {
namespace {

using EditJson = nlohmann::ordered_json;

constexpr double kRoundedNormal = 1e-6;
constexpr double kRoundedPart = 1e-5;  // of the image: a hundredth of a pixel of a thousand

EditJson pointJson(const glm::dvec3& point, double rounding) {
  EditJson json = EditJson::array();
  for (int axis = 0; axis < 3; ++axis) {
    json.push_back(roundedTo(point[axis], rounding));
  }
  return json;
}

EditJson planeJson(const DrawnEditPlane& plane, double rounding) {
  return {{"point", pointJson(plane.point, rounding)},
          {"normal", pointJson(glm::normalize(plane.normal), kRoundedNormal)}};
}

EditJson partJson(const GraphCamera::Part& shares) {
  EditJson json = EditJson::array();
  for (const glm::dvec2& corner : shares) {
    json.push_back({roundedTo(glm::clamp(corner.x, 0.0, 1.0), kRoundedPart),
                    roundedTo(glm::clamp(corner.y, 0.0, 1.0), kRoundedPart)});
  }
  return json;
}

std::string changeEdit(const std::string& name, const EditJson& to) {
  return EditJson{{"edit", "change"}, {"name", name}, {"to", to}}.dump();
}

std::string addOperation(const EditJson& operation) {
  return EditJson{{"edit", "add"}, {"operation", operation}}.dump();
}

}  // namespace

double roundedTo(double value, double powerOfTen) {
  // Multiples of 0.001 are not exact: of 1/1000 they come out as one types them.
  const double steps = std::round(1 / powerOfTen);
  const double rounded = steps >= 1 ? std::round(value * steps) / steps : std::round(value / powerOfTen) * powerOfTen;
  return rounded == 0 ? 0 : rounded;  // no -0
}

std::string DrawnEdits::view(const View& view) const {
  View rounded = view;
  for (int axis = 0; axis < 3; ++axis) {
    rounded.eye[axis] = static_cast<float>(roundedTo(static_cast<double>(view.eye[axis]), camera_.rounding));
    rounded.target[axis] = static_cast<float>(roundedTo(static_cast<double>(view.target[axis]), camera_.rounding));
  }
  return EditJson{{"edit", "view"}, {"view", EditJson::parse(jsonText(rounded))}}.dump();
}

std::string DrawnEdits::viewpoint(const std::string& name, const glm::dvec3& at) const {
  return changeEdit(name, {{"viewpoint", pointJson(at, camera_.rounding)}});
}

std::string DrawnEdits::plane(const std::string& name, const char* field, const DrawnEditPlane& plane) const {
  return changeEdit(name, {{field, planeJson(plane, camera_.rounding)}});
}

std::string DrawnEdits::part(const std::string& name, const GraphCamera::Part& shares) const {
  return changeEdit(name, {{"part", partJson(shares)}});
}

std::string DrawnEdits::limits(const std::string& name, std::span<const DrawnEditPlane> planes) const {
  EditJson json = EditJson::array();
  for (const DrawnEditPlane& plane : planes) {
    json.push_back(planeJson(plane, camera_.rounding));
  }
  return EditJson{{"edit", "limits"}, {"name", name}, {"planes", json}}.dump();
}

std::string DrawnEdits::addBend(const std::string& of, const std::string& name, const DrawnEditPlane& plane,
                                const glm::dvec3& viewpoint, const GraphCamera::Part& shares) const {
  EditJson into{{"name", name},
                {"plane", planeJson(plane, camera_.rounding)},
                {"viewpoint", pointJson(viewpoint, camera_.rounding)}};
  if (!shares.empty()) {
    into["part"] = partJson(shares);
  }
  return addOperation({{"operation", "bend"}, {"of", of}, {"into", into}});
}

std::string DrawnEdits::addSplit(const std::string& of, std::span<const std::string, 2> names,
                                 std::span<const DrawnEditPlane, 2> planes, const glm::dvec3& viewpoint) const {
  EditJson into = EditJson::array();
  for (size_t i = 0; i < 2; ++i) {
    into.push_back({{"name", names[i]},
                    {"plane", planeJson(planes[i], camera_.rounding)},
                    {"viewpoint", pointJson(viewpoint, camera_.rounding)}});
  }
  return addOperation({{"operation", "split"}, {"of", of}, {"into", into}});
}

std::string DrawnEdits::addMerge(std::span<const std::string, 2> of, const std::string& name,
                                 const DrawnEditPlane& plane, const glm::dvec3& viewpoint) const {
  return addOperation({{"operation", "merge"},
                       {"of", EditJson::array({of[0], of[1]})},
                       {"into",
                        {{"name", name},
                         {"plane", planeJson(plane, camera_.rounding)},
                         {"viewpoint", pointJson(viewpoint, camera_.rounding)}}}});
}

std::string DrawnEdits::addTurn(const std::string& name, std::span<const DrawnEditPlane, 3> planes,
                                const glm::dvec3& viewpoint) const {
  return EditJson{{"edit", "add"},
                  {"turn",
                   {{"name", name},
                    {"from", planeJson(planes[0], camera_.rounding)},
                    {"middle", planeJson(planes[1], camera_.rounding)},
                    {"to", planeJson(planes[2], camera_.rounding)},
                    {"viewpoint", pointJson(viewpoint, camera_.rounding)}}}}
      .dump();
}

std::string DrawnEdits::remove(const std::string& name) {
  return EditJson{{"edit", "remove"}, {"name", name}}.dump();
}

std::string DrawnEdits::rename(const std::string& name, const std::string& to) {
  return textOfJson(EditJson{{"edit", "rename"}, {"name", name}, {"to", to}});
}

std::string DrawnEdits::overlap(bool allowed) {
  return EditJson{{"edit", "overlap"}, {"overlap", allowed ? "allowed" : "refused"}}.dump();
}

std::string DrawnEdits::several(std::span<const std::string> edits) {
  EditJson json = EditJson::array();
  for (const std::string& edit : edits) {
    json.push_back(EditJson::parse(edit));
  }
  return EditJson{{"edit", "several"}, {"edits", json}}.dump();
}

std::vector<DrawnEditPlane> DrawnEdits::limitsOf(const DrawnFrustum& frustum) {
  std::vector<DrawnEditPlane> planes;
  for (const DrawnPlane& limit : frustum.limits) {
    planes.push_back({limit.point, limit.plane.normal});
  }
  return planes;
}

}  // namespace ocelli
