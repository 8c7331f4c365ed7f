#include "oc_core/constructor/curved_turns.h"

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
  const nlohmann::json& turns = fields.value("turns");
  if (!turns.is_array() || turns.size() > CurvedRayCamera::kMostTurns) {
    fields.fail("turns", "must be an array of at most " + std::to_string(CurvedRayCamera::kMostTurns));
  }
  for (const nlohmann::json& each : turns) {
    JsonFields turn(each, fields.where() + ", turn " + std::to_string(camera.turns().size() + 1));
    turn.text("name", "");
    const auto plane = [&](const std::string& name) {
      return readPlane(turn.value(name), turn.where() + ", \"" + name + "\"");
    };
    const TransitionPlanes planes{plane("from"), plane("middle"), plane("to")};
    const glm::dvec3 viewpoint = readVector(turn, "viewpoint");
    turn.rejectUnknown();
    camera.turn(planes, viewpoint);
  }
  return camera;
}

std::string jsonText(const CurvedRayCamera& camera) {
  nlohmann::ordered_json turns = nlohmann::ordered_json::array();
  for (const RayTransition& turn : camera.turns()) {
    turns.push_back({{"name", "turn " + std::to_string(turns.size() + 1)},
                     {"from", jsonOf(turn.planes().from)},
                     {"middle", jsonOf(turn.planes().middle)},
                     {"to", jsonOf(turn.planes().to)},
                     {"viewpoint", jsonOf(turn.beyond())}});
  }
  nlohmann::ordered_json json{{"camera", "curved"}};
  writeRoot(json, camera.root());
  json["arcs"] = camera.arcModel() == ArcModel::kConic ? kConic : kBezier;
  json["turns"] = turns;
  return textOfJson(json, 1);
}

}  // namespace ocelli
