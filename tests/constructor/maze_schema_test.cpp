// constructor.schema.json says what the constructors of cameras in mazes read.
#include <gtest/gtest.h>

#include "oc_core/base/json_fields.h"
#include "oc_core/constructor/camera_constructors.h"
#include "oc_core/constructor/comprehensive_constructor.h"
#include "oc_core/constructor/maze_constructor.h"
#include "oc_core/constructor/walk_camera.h"
#include "oc_core/constructor/walk_comprehensive.h"
#include "tests/base/schema_agreement.h"
#include "tests/base/temporary_folder.h"
#include "tests/constructor/maze_plans.h"

namespace ocelli {
namespace {

nlohmann::json schemaOf(const std::string& name) {
  return readJsonFile(OCELLI_CONSTRUCTOR_SCHEMA).at("$defs").at(name);
}

std::string errorOf(const std::string& text) {
  static const test::TemporaryFolder folder;
  static const GuidedScene scene = test::sceneOf(test::crossroads());
  View view;
  view.eye = {7.5, 1.6, 9};
  view.target = {7.5, 1.6, 0};
  return test::inputErrorOf(
      [&] { constructCamera(folder.write("camera.json", text), scene, PinholeCamera(view, 90, 60)); });
}

TEST(MazeSchema, comprehensiveIsWhatItsReaderTakes) {
  nlohmann::json schema = schemaOf("comprehensive");
  schema.at("properties").at("start_point")["default"] = {7.5, 0, 9};
  test::SchemaAgreement{schema, errorOf, {{"camera", "comprehensive"}}}.check();
  const ComprehensiveOptions options;
  EXPECT_EQ(schema.at("properties").at("eye_height").at("default"), options.eyeHeight);
  EXPECT_EQ(schema.at("properties").at("nearness").at("default"), options.nearness);
  EXPECT_EQ(schema.at("properties").at("evenness").at("default"), options.evenness);
  EXPECT_EQ(schema.at("properties").at("nearness").at("default"), WalkComprehensiveOptions{}.nearness);
  EXPECT_EQ(schema.at("properties").at("evenness").at("default"), WalkComprehensiveOptions{}.evenness);
  EXPECT_EQ(schema.at("properties").at("min_pixels").at("default"), WalkComprehensiveOptions{}.minPixels);
}

TEST(MazeSchema, mazeIsWhatItsReaderTakes) {
  nlohmann::json schema = schemaOf("maze");
  nlohmann::json& properties = schema.at("properties");
  const MazeCameraOptions options;
  EXPECT_EQ(properties.at("fov_degrees").at("default"), options.fovHorizontalDegrees);
  EXPECT_EQ(properties.at("corridor_fov_degrees").at("default"), options.fovCorridorDegrees);
  EXPECT_EQ(properties.at("portals_in_rooms").at("default"), WalkCameraOptions{}.portalsInRooms);
  EXPECT_EQ(properties.at("crossing_share").at("default"), options.crossingShare);
  EXPECT_EQ(properties.at("deploy_cells").at("default"), options.deployCells);
  properties.at("position")["default"] = {7.5, 1.6, 9};  // good ones, to change one number at a time
  properties.at("split")["default"] = {0.25, 0.5, 0.25};
  test::SchemaAgreement{schema, errorOf, {{"camera", "maze"}}}.check();
}

}  // namespace
}  // namespace ocelli
