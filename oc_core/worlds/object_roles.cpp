#include "oc_core/worlds/object_roles.h"

#include <set>

#include "oc_core/base/error.h"
#include "oc_core/base/file_bytes.h"
#include "oc_core/base/json_fields.h"

namespace ocelli {
namespace {

constexpr size_t kMaxObjects = 256;
constexpr size_t kMaxPlaces = 4096;
constexpr size_t kMaxSourceCharacters = 4096;
constexpr int kMaxIdentity = 1'000'000;
constexpr double kMaxPlace = 1000;

uint32_t readRoles(JsonFields& fields) {
  uint32_t roles = 0;
  const std::vector<std::string> names = fields.texts("roles", 1, kObjectRoles.size(), 32);
  if (names.empty()) {
    fields.fail("roles", "is missing");
  }
  std::string known;
  for (const ObjectRole& role : kObjectRoles) {
    known += (known.empty() ? "" : ", ") + std::string(role.name);
  }
  for (const std::string& name : names) {
    uint32_t bit = 0;
    for (const ObjectRole& role : kObjectRoles) {
      bit |= name == role.name ? role.bit : 0;
    }
    if (bit == 0) {
      fields.fail("roles", "has no role \"" + name + "\"; there are " + known);
    }
    if ((roles & bit) != 0) {
      fields.fail("roles", "says \"" + name + "\" twice");
    }
    roles |= bit;
  }
  if ((roles & kMirrors) != 0 && (roles & kRefracts) != 0) {
    fields.fail("roles", "cannot be both mirror and refract");
  }
  if ((roles & kRefracts) != 0 && (roles & kCasts) != 0) {
    fields.fail("roles", "of what refracts cannot be cast: no depth image stands for it");
  }
  if ((roles & (kMirrors | kRefracts)) != 0 && (roles & (kIsBillboard | kIsRelief)) != 0) {
    fields.fail("roles", "of what mirrors or refracts cannot be billboard or relief: rays do not end there");
  }
  if ((roles & kShines) != 0 && roles != kShines) {
    fields.fail("roles", "of a light cannot be anything else");
  }
  return roles;
}

glm::vec3 readPlace(JsonFields& fields, const std::string& name) {
  const std::vector<double> place = fields.numbers(name, 3, -kMaxPlace, kMaxPlace);
  return {place[0], place[1], place[2]};
}

AreaLight readLight(JsonFields fields) {
  const glm::vec3 center = readPlace(fields, "center");
  const glm::vec3 target = readPlace(fields, "target");
  const std::vector<double> size = fields.numbers("size", 2, 0, kMaxPlace);
  const std::string shape = fields.choice("shape", {"rectangle", "disc"}, "rectangle");
  const double turnDegrees = fields.number("turn_degrees", -360, 360, 0);
  fields.rejectUnknown();
  if (center == target) {
    fields.fail("target", "is the center of the light, so it shines nowhere");
  }
  return areaLightTowards(center, target, static_cast<float>(size[0]), static_cast<float>(size[1]), shape == "disc",
                          turnDegrees, fields.where());
}

RoledObject readObject(JsonFields& fields) {
  RoledObject object;
  object.roles = readRoles(fields);
  if (fields.has("light")) {
    if (object.roles != kShines) {
      fields.fail("light", "is only for what has the role \"light\"");
    }
    object.light = readLight(fields.inner("light"));
    return object;
  }
  object.refractiveIndex = fields.number("refractive_index", 1, 4, object.refractiveIndex);
  const bool isOfScene = fields.has("object");
  const bool comes = fields.has("source");
  if (isOfScene == comes) {
    fields.fail("object", "or \"source\" must be given, and not both");
  }
  if (object.roles == kShines && !isOfScene) {
    fields.fail("source", "cannot be a light: give \"object\" for a panel of the scene, or \"light\"");
  }
  if (isOfScene) {
    object.object = static_cast<uint32_t>(fields.integer("object", 0, kMaxIdentity));
    return object;
  }
  object.source = fields.shortText("source", kMaxSourceCharacters);
  if (fields.has("center")) {
    object.center = readPlace(fields, "center");
  }
  object.radius = fields.number("radius", 1e-4, 1000, object.radius);
  object.turnDegrees = fields.number("turn_degrees", -360, 360, object.turnDegrees);
  fields.forEach("places", fields.has("places") ? 1 : 0, kMaxPlaces, [&](JsonFields& each) {
    const std::vector<double> center = each.numbers("center", 3, -1000, 1000);
    object.places.push_back({center[0], center[1], center[2], each.number("turn_degrees", -360, 360, 0)});
  });
  if (!object.places.empty() && !object.has(kIsRelief)) {
    fields.fail("places", "are of an object with the role \"relief\", whose one image is drawn at each of them");
  }
  return object;
}

}  // namespace

std::vector<RoledObject> objectRolesFromJsonText(const std::string& text, const std::string& where) {
  return readAs("oc_core/worlds/object_roles.schema.json", [&] {
    const nlohmann::json json = parseJson(text, where);
    JsonFields fields(json, where);
    std::vector<RoledObject> objects;
    std::set<uint32_t> known;
    fields.forEach("objects", 1, kMaxObjects, [&](JsonFields& each) {
      objects.push_back(readObject(each));
      if (objects.back().source.empty() && !objects.back().light && !known.insert(objects.back().object).second) {
        each.fail("object", "is the same as that of an object before");
      }
    });
    if (objects.empty()) {
      fields.fail("objects", "is missing");
    }
    fields.rejectUnknown();
    return objects;
  });
}

std::vector<RoledObject> readObjectRoles(const std::filesystem::path& path) {
  return objectRolesFromJsonText(readFile(path, kMaxTextBytes), path.string());
}

}  // namespace ocelli
