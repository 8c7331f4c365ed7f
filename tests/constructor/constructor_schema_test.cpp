// constructor.schema.json says what the constructors read.
#include <gtest/gtest.h>

#include <set>

#include "oc_core/base/error.h"
#include "oc_core/base/json_fields.h"
#include "oc_core/constructor/camera_constructors.h"
#include "oc_core/constructor/occluder_constructor.h"
#include "oc_core/constructor/path_constructor.h"
#include "oc_core/constructor/portal_constructor.h"
#include "oc_core/constructor/target_constructor.h"
#include "tests/base/schema_agreement.h"
#include "tests/base/temporary_folder.h"

namespace ocelli {
namespace {

const nlohmann::json& schema() {
  static const nlohmann::json schema = readJsonFile(OCELLI_CONSTRUCTOR_SCHEMA);
  return schema;
}

const nlohmann::json& schemaOf(const std::string& name) {
  return schema().at("$defs").at(name);
}

std::string errorOf(const std::string& text) {
  static const test::TemporaryFolder folder;
  static const GuidedScene scene = loadGuidedScene("builtin:boxes,count=4,floor=1");
  try {
    constructCamera(folder.write("camera.json", text), scene, PinholeCamera(View{}, 90, 60));
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

void expectDefaults(const std::string& name, const std::map<std::string, double>& defaults) {
  std::set<std::string> described;
  for (const auto& [field, property] : schemaOf(name).at("properties").items()) {
    if (property.contains("default")) {
      described.insert(field);
      ASSERT_TRUE(defaults.contains(field)) << field;
      EXPECT_DOUBLE_EQ(property.at("default").get<double>(), defaults.at(field)) << field;
    }
  }
  EXPECT_EQ(described.size(), defaults.size());
}

TEST(ConstructorSchema, hasABranchForEachOfItsNames) {
  std::set<std::string> branches;
  for (const nlohmann::json& rule : schema().at("allOf")) {
    const std::string name = rule.at("if").at("properties").at("camera").at("const");
    EXPECT_EQ(rule.at("then").at("$ref"), "#/$defs/" + name);
    EXPECT_EQ(schemaOf(name).at("properties").at("camera").at("enum"), nlohmann::json::array({name}));
    EXPECT_TRUE(namesConstructor(name)) << name;
    branches.insert(name);
  }
  const std::set<std::string> listed = schema().at("properties").at("camera").at("enum");
  EXPECT_EQ(branches, listed);
  for (const auto& [name, definition] : schema().at("$defs").items()) {
    EXPECT_EQ(branches.contains(name), definition.at("properties").contains("camera")) << name;
  }
}

TEST(ConstructorSchema, portalIsWhatItsReaderTakes) {
  const nlohmann::json base = nlohmann::json::parse(
      R"({"camera": "portal", "portals": [{"center": [0, 0, 1], "normal": [0.5, 0, 1], "width": 1, "height": 2}]})");
  test::SchemaAgreement{schemaOf("portal"), errorOf, base}.check();
  nlohmann::json items = schemaOf("portal").at("properties").at("portals").at("items");
  const auto errorOfItem = [&](const std::string& text) {
    nlohmann::json document = base;
    document["portals"][0] = nlohmann::json::parse(text);
    return errorOf(document.dump());
  };
  for (const char* vector : {"center", "normal", "up"}) {
    items.at("properties").at(vector)["default"] = {0.5, 0.25, 0.75};
  }
  test::SchemaAgreement{items, errorOfItem, base.at("portals").at(0)}.check();
}

/// The definition of boxes, with something for each corner that the reader takes.
nlohmann::json schemaOfBox() {
  nlohmann::json box = schemaOf("box");
  box.at("properties").at("lower")["default"] = {-1e6, -1e6, -1e6};
  box.at("properties").at("upper")["default"] = {1e6, 1e6, 1e6};
  return box;
}

TEST(ConstructorSchema, targetIsWhatItsReaderTakes) {
  const nlohmann::json box = nlohmann::json::parse(R"({"lower": [-1, -2, -3], "upper": [1, 2, 3]})");
  const nlohmann::json base{{"camera", "target"}, {"box", box}, {"occluders", {box}}};
  test::SchemaAgreement{schemaOf("target"), errorOf, base}.check();
  const auto errorOfBox = [&](const std::string& text) {
    nlohmann::json document = base;
    document["box"] = nlohmann::json::parse(text);
    return errorOf(document.dump());
  };
  test::SchemaAgreement{schemaOfBox(), errorOfBox, box}.check();
  const TargetOptions options;
  expectDefaults("target", {{"f", options.f},
                            {"most_f", options.maxF},
                            {"visible_share", options.visibleShare},
                            {"enlarged", options.enlarged},
                            {"enlarged_pixels", options.enlargedPixels},
                            {"max_change", options.maxChange}});
  std::set<std::string> sights;
  for (const TargetSight& sight : targetSights()) {
    sights.insert(sight.name);
  }
  EXPECT_EQ(sights, schemaOf("target").at("properties").at("sight").at("enum").get<std::set<std::string>>());
}

TEST(ConstructorSchema, occluderIsWhatItsReaderTakes) {
  const nlohmann::json base =
      nlohmann::json::parse(R"({"camera": "occluder", "box": {"lower": [-1, -2, -3], "upper": [1, 2, 3]}})");
  test::SchemaAgreement{schemaOf("occluder"), errorOf, base}.check();
  const OccluderOptions options;
  expectDefaults("occluder", {{"object", options.object}, {"shadow", options.shadow}, {"deployed", options.deployed}});
}

TEST(ConstructorSchema, pathIsWhatItsReaderTakes) {
  test::SchemaAgreement{schemaOf("path"), errorOf,
                        nlohmann::json::parse(R"({"camera": "path", "path": [[0, 0, 1], [1, 0, 0], [1, 0, -3]]})")}
      .check();
  const PathOptions options;
  expectDefaults("path", {{"deployed", options.deployed},
                          {"position", options.position},
                          {"preview", options.preview},
                          {"turns", options.turns},
                          {"eye_height", options.eyeHeight},
                          {"rounding", options.rounding},
                          {"deployed", options.deployed}});
}

TEST(ConstructorSchema, portalDefaultsAreTheReaders) {
  const PortalOptions options;
  expectDefaults("portal", {{"straight_within", options.straightWithin},
                            {"bent_beyond", options.bentBeyond},
                            {"farthest", options.farthest},
                            {"straight_degrees", options.straightDegrees},
                            {"bent_degrees", options.bentDegrees},
                            {"edge_degrees", options.edgeDegrees},
                            {"edge_fade_degrees", options.edgeFadeDegrees},
                            {"evenness", options.evenness},
                            {"hand_over", options.handOver}});
  std::set<std::string> curves;
  for (const PortalCurve& curve : portalCurves()) {
    curves.insert(curve.name);
  }
  EXPECT_EQ(curves, schemaOf("portal").at("properties").at("curve").at("enum").get<std::set<std::string>>());
}

}  // namespace
}  // namespace ocelli
