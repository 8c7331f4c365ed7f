#include "oc_core/constructor/curved_bends.h"

#include "oc_core/base/error.h"
#include "oc_core/base/json_fields.h"
#include "oc_core/constructor/camera_fields.h"

namespace ocelli {
namespace {

constexpr const char* kConic = "conic";
constexpr const char* kBezier = "bezier";

}  // namespace

CurvedRayCamera readCurvedRayCamera(JsonFields& fields, const PinholeCamera& reference) {
  const std::string arcs = fields.text("arcs", kConic);
  if (arcs != kConic && arcs != kBezier) {
    fields.fail("arcs", "must be conic or bezier");
  }
  CurvedRayCamera camera(readRoot(fields, reference), arcs == kConic ? ArcModel::kConic : ArcModel::kBezier);
  const nlohmann::json& bends = fields.value("turns");
  if (!bends.is_array() || bends.size() > CurvedRayCamera::kMaxBends) {
    fields.fail("turns", "must be an array of at most " + std::to_string(CurvedRayCamera::kMaxBends));
  }
  for (const nlohmann::json& each : bends) {
    JsonFields bend(each, fields.where() + ", turn " + std::to_string(camera.bends().size() + 1));
    bend.text("name", "");
    const auto plane = [&](const std::string& name) {
      return readPlane(bend.value(name), bend.where() + ", \"" + name + "\"");
    };
    const TransitionPlanes planes{plane("from"), plane("middle"), plane("to")};
    const glm::dvec3 viewpoint = readVector(bend, "viewpoint");
    bend.rejectUnknown();
    camera.bend(planes, viewpoint);
  }
  return camera;
}

std::string jsonText(const CurvedRayCamera& camera) {
  nlohmann::ordered_json bends = nlohmann::ordered_json::array();
  for (const RayTransition& bend : camera.bends()) {
    bends.push_back({{"name", "turn " + std::to_string(bends.size() + 1)},
                     {"from", jsonOf(bend.planes().from)},
                     {"middle", jsonOf(bend.planes().middle)},
                     {"to", jsonOf(bend.planes().to)},
                     {"viewpoint", jsonOf(bend.beyond())}});
  }
  nlohmann::ordered_json json{{"camera", "curved"}};
  writeRoot(json, camera.root());
  json["arcs"] = camera.arcModel() == ArcModel::kConic ? kConic : kBezier;
  json["turns"] = bends;
  return textOfJson(json, 1);
}

}  // namespace ocelli
