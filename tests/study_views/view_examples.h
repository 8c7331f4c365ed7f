// Views of each kind, and a scene to look at.
#pragma once

#include <memory>
#include <ostream>
#include <string>
#include <vector>

#include "study/task/scene_view.h"

namespace ocelli::test {

struct ViewExample {
  std::string kind;
  std::string json;  ///< the field "view"

  friend void PrintTo(const ViewExample& example, std::ostream* out) { *out << example.json; }
};
/// One of each kind at least.
const std::vector<ViewExample>& viewExamples();

std::shared_ptr<const SceneView> readView(const std::string& json);
/// What reading it throws; empty where it throws nothing.
std::string errorOfView(const std::string& json);

/// A hall with an orange ball ahead and a blue cube beside it.
StudyScene viewScene();
/// One looks east along it. The pinhole covers `place`; the graph camera is of one frustum.
Vantage viewVantage(const PixelRect& place = {8, 4, 240, 150});
/// With both objects where they stand, and no view.
TrialLayout layoutOf(const StudyScene& scene);

}  // namespace ocelli::test
