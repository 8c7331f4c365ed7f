#include "oc_core/feeds/known_places.h"

#include <gtest/gtest.h>

#include <glm/geometric.hpp>

#include "oc_core/base/error.h"
#include "oc_core/base/json_fields.h"

namespace ocelli {
namespace {

std::string placesError(const std::string& text) {
  try {
    knownPlacesFromJsonText(text, "places.json");
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

TEST(KnownPlaces, haveCornersFromTheTopLeft) {
  const KnownPlaces places = knownPlacesFromJsonText(
      R"({"tag_size": 0.2, "tags": [{"id": 3, "center": [1, 2, -3], "normal": [0, 0, 2]}]})", "places");
  EXPECT_LT(glm::distance(places.tags[0].corners[0], {0.9, 2.1, -3}), 1e-12);
  EXPECT_LT(glm::distance(places.tags[0].corners[2], {1.1, 1.9, -3}), 1e-12);
  EXPECT_LT(glm::distance(frontOf(places.tags[0]), {0, 0, 1}), 1e-12);
}

TEST(KnownPlaces, refuseBrokenTables) {
  for (
      const char* text :
      {"", "[]", "{}", R"({"tags": [{"id": 1, "center": [0, 0, 0], "normal": [0, 0, 1]}]})",
       R"({"tag_size": 1e400, "tags": []})",
       R"({"tag_size": 1, "tags": [{"id": 587, "center": [0,0,0], "normal": [0,0,1]}]})",
       R"({"tag_size": 1, "tags": [{"id": 1, "center": [0,0], "normal": [0,0,1]}]})",
       R"({"tag_size": 1, "tags": [{"id": 1, "center": [0,0,0], "normal": [0,0,0]}]})",
       R"({"tag_size": 1, "tags": [{"id": 1, "center": [0,0,0], "normal": [0,1,0]}]})",
       R"({"tags": [{"id": 1, "corners": [[0,1,0], [1,1,0], [1,0,0], [0,0,0.5]]}]})",
       R"({"tags": [{"id": 1, "corners": [[0,1,0], [1,1,0], [1,0,0]]}]})",
       R"({"tag_size": 1, "tags": [{"id": 1, "center": [0,0,0], "normal": [0,0,1]}, {"id": 1, "center": [2,0,0], "normal": [0,0,1]}]})",
       R"({"corners": [{"feed": "", "pixel": [1, 2], "point": [0, 0, 0]}]})",
       R"({"corners": [{"feed": "a", "pixel": ["x", 2], "point": [0, 0, 0]}]})"}) {
    EXPECT_NE(placesError(text).find("places.json"), std::string::npos) << text;
  }
}

/// Each property of the schema is read, and each limit of it is one of the reader.
TEST(KnownPlaces, schemaAgreesWithTheReader) {
  using Json = nlohmann::json;
  const Json properties = readJsonFile(OCELLI_PLACES_SCHEMA).at("properties");
  const Json byCorners =
      Json::parse(R"({"id": 1, "corners": [[0,1,0], [1,1,0], [1,0,0], [0,0,0]], "seen_by": ["a"], "comment": ""})");
  const Json byCenter =
      Json::parse(R"({"id": 2, "size": 0.2, "center": [0,0,0], "normal": [0,0,1], "up": [0,1,0], "seen_by": ["a"]})");
  const Json corner = Json::parse(R"({"feed": "a", "pixel": [1, 2], "point": [0, 0, 0], "comment": ""})");
  const Json whole{{"$schema", ""},
                   {"comment", ""},
                   {"tag_size", 0.1},
                   {"tags", Json::array({byCorners, byCenter})},
                   {"corners", Json::array({corner})}};
  EXPECT_EQ(placesError(whole.dump()), "");
  const auto namesOf = [](const Json& object) {
    std::set<std::string> names;
    for (const auto& [name, value] : object.items()) {
      names.insert(name);
    }
    return names;
  };
  EXPECT_EQ(namesOf(properties), namesOf(whole));
  Json tag = byCorners;
  tag.update(byCenter);
  const Json tagProperties = properties.at("tags").at("items").at("properties");
  EXPECT_EQ(namesOf(tagProperties), namesOf(tag));
  EXPECT_EQ(namesOf(properties.at("corners").at("items").at("properties")), namesOf(corner));
  const auto checkLimits = [&](const Json& property, const std::function<Json(const Json&)>& with) {
    for (const char* limit : {"minimum", "maximum"}) {
      const double value = property.at(limit);
      EXPECT_EQ(placesError(with(property.at(limit)).dump()), "") << property;
      EXPECT_NE(placesError(with(value + (limit[1] == 'i' ? -1 : 1)).dump()), "") << property;
    }
  };
  const auto withTag = [&](const char* name) {
    return [&, name](const Json& value) {
      Json document = whole;
      document["tags"][1][name] = value;
      return document;
    };
  };
  checkLimits(tagProperties.at("id"), withTag("id"));
  checkLimits(tagProperties.at("size"), withTag("size"));
  checkLimits(properties.at("tag_size"), [&](const Json& value) {
    Json document = whole;
    document["tag_size"] = value;
    return document;
  });
}

}  // namespace
}  // namespace ocelli
