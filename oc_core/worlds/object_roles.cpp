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
  return roles;
}

RoledObject readObject(JsonFields& fields) {
  RoledObject object;
  object.roles = readRoles(fields);
  object.refractiveIndex = fields.number("refractive_index", 1, 4, object.refractiveIndex);
  const bool isOfScene = fields.has("object");
  const bool comes = fields.has("source");
  if (isOfScene == comes) {
    fields.fail("object", "or \"source\" must be given, and not both");
  }
  if (isOfScene) {
    object.object = static_cast<uint32_t>(fields.integer("object", 0, kMaxIdentity));
    return object;
  }
  object.source = fields.shortText("source", kMaxSourceCharacters);
  if (fields.has("center")) {
    const std::vector<double> center = fields.numbers("center", 3, -1000, 1000);
    object.center = glm::vec3(center[0], center[1], center[2]);
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
      if (objects.back().source.empty() && !known.insert(objects.back().object).second) {
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
