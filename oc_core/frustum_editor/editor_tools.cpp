#include "oc_core/frustum_editor/editor_tools.h"

#include "oc_core/base/error.h"
#include "oc_core/frustum_editor/drawn_edits.h"
#include "oc_core/frustum_editor/graph_tools.h"
#include "oc_core/frustum_editor/handle_kinds.h"
#include "oc_core/frustum_editor/stroke_frusta.h"

namespace ocelli {
namespace {

/// The rays of the frustum under the beginning of the stroke, or of the selected one, go to its end.
StrokeEdit aimStroke(const DrawnCamera& camera, const PlanStroke& stroke) {
  const DrawnFrustum* selected = camera.find(stroke.selected);
  const DrawnFrustum& frustum = selected != nullptr ? *selected : frustumUnder(camera, stroke.side, stroke.from);
  const HandleKind& kind = handleKind(frustum.operation == "root" ? "target" : "aim");
  for (FrustumHandle handle : kind.of(camera, frustum, stroke.side)) {
    handle.kind = &kind;
    handle.frustum = frustum.name;
    handle.side = stroke.side;
    const glm::dvec3 to = worldFromPaper(stroke.side, stroke.to, handle.at[axisOf(stroke.side)]);
    return {kind.drag(camera, handle, to), frustum.name};
  }
  throw InputError("the viewpoint of \"" + frustum.name + "\" lies in its plane", "plan", "move one of them");
}

StrokeEdit deleteStroke(const DrawnCamera& camera, const PlanStroke& stroke) {
  const DrawnFrustum& frustum = frustumUnder(camera, stroke.side, stroke.to);
  if (frustum.operation == "root") {
    throw InputError("the root stays", "plan", "delete a frustum behind a bend");
  }
  return {DrawnEdits::remove(frustum.name), ""};
}

}  // namespace

const std::vector<EditorTool>& editorTools() {
  static const std::vector<EditorTool> tools{
      {"move", 'V', "drag a handle; click a frustum to select it", true, true, nullptr},
      {"bend", 'B', "draw a line across a frustum: all its rays bend there", true, false, bendStroke},
      {"add", 'A', "draw a line across some rays of a frustum: those bend there", true, false, addStroke},
      {"split", 'S', "press where two planes shall meet, and drag to where they begin", true, false, splitStroke},
      {"merge", 'M', "drag from one frustum to another: behind the end, rays of both have one viewpoint", true, false,
       mergeStroke},
      {"limit", 'L', "draw a line across a frustum: its rays end there", true, false, limitStroke},
      {"turn", 'T', "draw from where rays shall turn about, beside them, across all rays", false, true, turnStroke},
      {"aim", 'I', "drag to where the rays of the selected frustum shall go", true, true, aimStroke},
      {"delete", 'X', "click a frustum: it goes, with all that comes from it", true, true, deleteStroke}};
  return tools;
}

const EditorTool& editorTool(const std::string& name) {
  std::string names;
  for (const EditorTool& tool : editorTools()) {
    if (tool.name == name) {
      return tool;
    }
    names += (names.empty() ? "" : ", ") + tool.name;
  }
  throw InputError("there is no tool called \"" + name + "\"", "tool", "use one of these: " + names);
}

}  // namespace ocelli
