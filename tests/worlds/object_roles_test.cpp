#include "oc_core/worlds/object_roles.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <glm/geometric.hpp>

#include "oc_core/base/error.h"
#include "oc_core/base/json_fields.h"
#include "oc_core/worlds/builtin_scenes.h"
#include "tests/base/schema_agreement.h"

namespace ocelli {
namespace {

using testing::HasSubstr;

const char* const kGoodRoles = R"({"objects": [
  {"object": 2, "roles": ["cast", "receive"]},
  {"source": "builtin:sphere", "roles": ["refract"], "refractive_index": 1.33, "center": [1, 2, 3], "radius": 0.5,
   "turn_degrees": 30},
  {"source": "car.obj", "roles": ["relief"], "places": [{"center": [1, 0, 2]}, {"center": [3, 0, 2], "turn_degrees": 90}]},
  {"roles": ["light"], "light": {"center": [0, 3, 0], "target": [0, 0, 0], "size": [0.5, 0.25], "shape": "disc",
   "turn_degrees": 10}}]})";

std::string rolesError(const std::string& text) {
  try {
    objectRolesFromJsonText(text, "roles.json");
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

std::string objectError(const std::string& object) {
  return rolesError("{\"objects\": [" + object + "]}");
}

TEST(ObjectRoles, areRead) {
  const std::vector<RoledObject> objects = objectRolesFromJsonText(kGoodRoles, "roles.json");
  ASSERT_EQ(objects.size(), 4u);
  EXPECT_EQ(objects[0].object, 2u);
  EXPECT_EQ(objects[0].roles, kCasts | kReceives);
  EXPECT_EQ(objects[0].source, "");
  EXPECT_EQ(objects[1].source, "builtin:sphere");
  EXPECT_EQ(objects[1].roles, kRefracts);
  EXPECT_EQ(objects[1].refractiveIndex, 1.33);
  EXPECT_EQ(objects[1].center, glm::vec3(1, 2, 3));
  EXPECT_EQ(objects[1].radius, 0.5);
  EXPECT_EQ(objects[1].turnDegrees, 30);
  EXPECT_TRUE(objects[1].places.empty());
  EXPECT_EQ(objects[2].roles, kIsRelief);
  ASSERT_EQ(objects[2].places.size(), 2u);
  EXPECT_EQ(objects[2].places[0], glm::dvec4(1, 0, 2, 0));
  EXPECT_EQ(objects[2].places[1], glm::dvec4(3, 0, 2, 90));
  EXPECT_FALSE(objects[1].light);
  EXPECT_EQ(objects[3].roles, kShines);
  ASSERT_TRUE(objects[3].light);
  EXPECT_EQ(objects[3].light->center, glm::vec3(0, 3, 0));
  EXPECT_LT(glm::distance(objects[3].light->direction(), {0, -1, 0}), 1e-6f);
  EXPECT_EQ(objects[3].light->width, 0.5f);
  EXPECT_EQ(objects[3].light->height, 0.25f);
  EXPECT_TRUE(objects[3].light->isDisc);
}

TEST(ObjectRoles, agreeWithTheirSchema) {
  const nlohmann::json schema = readJsonFile(OCELLI_ROLES_SCHEMA);
  test::SchemaAgreement{schema, rolesError, nlohmann::json::parse(kGoodRoles)}.check();
  const nlohmann::json& properties = schema.at("properties").at("objects").at("items").at("properties");
  const nlohmann::json& names = properties.at("roles").at("items").at("enum");
  ASSERT_EQ(names.size(), kObjectRoles.size());
  for (size_t i = 0; i < kObjectRoles.size(); ++i) {
    EXPECT_EQ(names[i], kObjectRoles[i].name);
    EXPECT_THAT(properties.at("roles").at("description").get<std::string>(), HasSubstr(kObjectRoles[i].name));
  }
  EXPECT_EQ(properties.at("refractive_index").at("default"), RoledObject().refractiveIndex);
  EXPECT_EQ(properties.at("radius").at("default"), RoledObject().radius);
}

TEST(ObjectRoles, mistakesAreNamed) {
  EXPECT_THAT(rolesError("{}"), HasSubstr("\"objects\""));
  EXPECT_THAT(objectError(R"({"object": 1})"), HasSubstr("\"roles\""));
  EXPECT_THAT(objectError(R"({"object": 1, "roles": ["miror"]})"), HasSubstr("mirror, refract, cast"));
  EXPECT_THAT(objectError(R"({"object": 1, "roles": ["cast", "cast"]})"), HasSubstr("twice"));
  EXPECT_THAT(objectError(R"({"object": 1, "roles": ["mirror", "refract"]})"), HasSubstr("both mirror and refract"));
  EXPECT_THAT(objectError(R"({"object": 1, "roles": ["refract", "cast"]})"), HasSubstr("cannot be cast"));
  EXPECT_THAT(objectError(R"({"object": 1, "roles": ["mirror", "billboard"]})"), HasSubstr("cannot be billboard"));
  EXPECT_EQ(objectError(R"({"object": 1, "roles": ["mirror", "cast"]})"), "");
  EXPECT_THAT(objectError(R"({"roles": ["cast"]})"), HasSubstr("must be given, and not both"));
  EXPECT_THAT(objectError(R"({"object": 1, "source": "x", "roles": ["cast"]})"), HasSubstr("not both"));
  EXPECT_THAT(objectError(R"({"object": 1, "roles": ["cast"]}, {"object": 1, "roles": ["cast"]})"),
              HasSubstr("same as that of an object before"));
  const std::string light = R"("light": {"center": [0, 1, 0], "target": [0, 0, 0], "size": [1, 1]})";
  EXPECT_EQ(objectError("{\"roles\": [\"light\"], " + light + "}"), "");
  EXPECT_EQ(objectError(R"({"object": 1, "roles": ["light"]})"), "") << "a panel of the scene";
  EXPECT_THAT(objectError("{\"roles\": [\"cast\"], " + light + "}"), HasSubstr("has the role \"light\""));
  EXPECT_THAT(objectError(R"({"object": 1, "roles": ["light", "cast"]})"), HasSubstr("cannot be anything else"));
  EXPECT_THAT(objectError(R"({"source": "x", "roles": ["light"]})"), HasSubstr("cannot be a light"));
  EXPECT_THAT(
      objectError(R"({"roles": ["light"], "light": {"center": [0, 1, 0], "target": [0, 1, 0], "size": [1, 1]}})"),
      HasSubstr("shines nowhere"));
  EXPECT_THAT(objectError(R"({"roles": ["light"], "light": {"center": [0, 1, 0], "target": [0, 0, 0]}})"),
              HasSubstr("\"size\""));
  EXPECT_NE(objectError(R"({"object": 1, "roles": ["refract"], "refractive_index": 0.9})"), "");
  EXPECT_NE(objectError(R"({"source": "x", "roles": ["cast"], "radius": 0})"), "");
  EXPECT_NE(objectError(R"({"object": 1, "roles": ["cast"], "color": 3})"), "");
  EXPECT_THAT(objectError(R"({"object": 1, "roles": ["mirror", "relief"]})"), HasSubstr("billboard or relief"));
  EXPECT_THAT(objectError(R"({"source": "x", "roles": ["cast"], "places": [{"center": [0, 0, 0]}]})"),
              HasSubstr("role \"relief\""));
  EXPECT_NE(objectError(R"({"source": "x", "roles": ["relief"], "places": []})"), "");
  EXPECT_NE(objectError(R"({"source": "x", "roles": ["relief"], "places": [{"turn_degrees": 3}]})"), "");
}

TEST(ObjectRoles, builtinScenesHaveTheirs) {
  EXPECT_TRUE(builtinRoles("builtin:teapot").empty());
  size_t cast = 0;
  for (const RoledObject& object : builtinRoles("builtin:mirror,triangles=50000")) {
    cast += object.has(kCasts);
  }
  EXPECT_EQ(cast, 5u);
  for (const char* scene : {"builtin:lamp,light=0.2", "builtin:pergola"}) {
    size_t lights = 0;
    for (const RoledObject& object : builtinRoles(scene)) {
      lights += object.has(kShines);
    }
    EXPECT_EQ(lights, 1u) << scene;
  }
}

}  // namespace
}  // namespace ocelli
