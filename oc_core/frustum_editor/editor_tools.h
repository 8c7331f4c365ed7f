// The tools of an editor of graph and curved ray cameras: what a stroke in a plan, from where the button is pressed to
// where it is released, does to the camera. A tool is a row of editorTools(); "move", the first, drags handles and has
// no stroke. To add a tool: a function that makes its edit, and its row in editor_tools.cpp.
#pragma once

#include <string>
#include <vector>

#include "oc_core/frustum_editor/drawn_camera.h"

namespace ocelli {

struct PlanStroke {
  PlanSide side = PlanSide::kTop;
  glm::dvec2 from{0};  ///< on the paper
  glm::dvec2 to{0};
  std::string selected{};  ///< the frustum that is selected; "" for none

  double length() const { return glm::length(to - from); }
};

/// What a stroke leads to.
struct StrokeEdit {
  std::string edit;      ///< of CameraEditor; "" where the stroke is too short to do anything yet
  std::string selected;  ///< the frustum to select then; "" for none
};

struct EditorTool {
  std::string name;  ///< in scripts and menus: "bend"
  char key = 0;      ///< a capital letter
  std::string says;  ///< how to use it, in a line
  bool ofGraph = true;
  bool ofCurved = true;
  /// Null for "move". Throws InputError where it cannot be done.
  StrokeEdit (*apply)(const DrawnCamera& camera, const PlanStroke& stroke) = nullptr;
};

/// In the order of menus; the first is "move".
const std::vector<EditorTool>& editorTools();
/// Throws InputError for a name that no tool has.
const EditorTool& editorTool(const std::string& name);

}  // namespace ocelli
