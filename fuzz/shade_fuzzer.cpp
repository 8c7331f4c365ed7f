// libFuzzer target: what `ocelli shade` reads from files and names. The first line as a file of roles, the second as
// the words of a way, the third as a camera file that `--by` names.
#include <cmath>
#include <cstdlib>
#include <sstream>
#include <string>

#include "oc_core/base/error.h"
#include "oc_core/base/json_fields.h"
#include "oc_core/ocri/camera_choice.h"
#include "oc_core/shade/scene_proxies.h"
#include "oc_core/worlds/object_roles.h"

namespace {

template <class Body>
void orInputError(const Body& body) {
  try {
    body();
  } catch (const ocelli::InputError&) {
    // Any other exception is a finding.
  }
}

void readRoles(const std::string& text) {
  for (const ocelli::RoledObject& object : ocelli::objectRolesFromJsonText(text, "fuzz")) {
    const glm::vec3& c = object.center;
    if (object.roles == 0 || !std::isfinite(c.x + c.y + c.z) || !(object.radius > 0) ||
        !(object.refractiveIndex >= 1) || object.source.find('\0') != std::string::npos) {
      std::abort();
    }
  }
}

void readWay(const std::string& text) {
  const ocelli::SpecularWayName way = ocelli::specularWay(text);
  if (!way.full.starts_with(way.target)) {
    std::abort();
  }
  if (way.target.ends_with(".json")) {
    return;  // no files here
  }
  ocelli::checkProxyName(text);
}

void readCamera(const std::string& text) {
  const nlohmann::json json = ocelli::parseJson(text, "fuzz");
  ocelli::JsonFields fields(json, "fuzz");
  const ocelli::CameraChoice choice = ocelli::readCameraChoice(fields, {});
  fields.rejectUnknown();
  if (choice.kind == nullptr || !std::isfinite(choice.cellSideRadii)) {
    std::abort();
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
  std::istringstream lines(std::string(data, data + size));
  std::string line;
  for (void (*read)(const std::string&) : {readRoles, readWay, readCamera}) {
    if (std::getline(lines, line)) {
      orInputError([&] { read(line); });
    }
  }
  return 0;
}
