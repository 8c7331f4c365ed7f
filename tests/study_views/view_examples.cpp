#include "tests/study_views/view_examples.h"

#include "oc_core/base/json_fields.h"
#include "oc_core/worlds/maze_file.h"
#include "study/views/view_registry.h"

namespace ocelli::test {

const std::vector<ViewExample>& viewExamples() {
  static const std::vector<ViewExample> kExamples{
      {"pinhole", R"("pinhole")"},
      {"graph", R"({"kind": "graph"})"},
      {"panes", R"({"kind": "panes", "headings_degrees": [-60, 0, 60]})"},
      {"ocri", R"({"kind": "ocri", "camera": "ddoc", "eye_offset_meters": [0.2, 0.1, 0]})"},
      {"ocri", R"({"kind": "ocri", "camera": "eoc-h", "eye_offset_meters": [0.3, 0, 0], "image_scale": 2})"},
      {"camera", R"({"kind": "camera", "camera": "panorama"})"},
      {"camera", R"({"kind": "camera", "camera": "ddoc"})"},
      {"display", R"({"kind": "display", "profile": "test", "distance_meters": 7.5, "radius_meters": 4})"},
      {"display", R"({"kind": "display", "profile": "test", "distance_meters": 7.5, "radius_meters": 4, "camera": "di",
                      "head": {"sway_degrees": 8, "images": 5}, "made_at": "each", "mean_luminance": 0.02,
                      "image_rows": 100})"}};
  return kExamples;
}

std::shared_ptr<const SceneView> readView(const std::string& json) {
  const nlohmann::json condition{{"view", nlohmann::json::parse(json)}};
  JsonFields fields(condition, "condition");
  return readSceneView(fields, "view");
}

std::string errorOfView(const std::string& json) {
  try {
    readView(json);
  } catch (const InputError& error) {
    return error.what();
  }
  return {};
}

StudyScene viewScene() {
  Maze maze = mazeFromJsonText(R"({"plan": [
    "+-+-+-+-+-+",
    "|   |   | |",
    "+ +-+ +-+ +",
    "|         |",
    "+ + +-+ +-+",
    "| |   |   |",
    "+ +-+-+-+-+"]})",
                               "an example");
  maze.landmarks = {{{1, 2}, LandmarkShape::kSphere, LandmarkColor::kOrange, 0, -0.2f},
                    {{1, 3}, LandmarkShape::kCube, LandmarkColor::kBlue, 0, 0.2f}};
  return StudyScene(maze);
}

Vantage viewVantage(const PixelRect& place) {
  View view;
  view.eye = {1.5f, 1.6f, 4.5f};
  view.target = {2.5f, 1.6f, 4.5f};
  view.fovVerticalDegrees = 50;
  view.zNear = 0.06f;
  view.zFar = 100;
  const PinholeCamera camera(view, static_cast<int>(place.width), static_cast<int>(place.height));
  const auto graph = [place, camera] {
    std::vector<TrialLayout::View> views;
    views.emplace_back(place, GraphCamera(camera));
    return views;
  };
  return {{{place, camera}}, graph};
}

TrialLayout layoutOf(const StudyScene& scene) {
  TrialLayout layout;
  layout.scene = &scene;
  layout.objectOffsets.assign(scene.objectCount(), glm::vec3(0));
  return layout;
}

}  // namespace ocelli::test
