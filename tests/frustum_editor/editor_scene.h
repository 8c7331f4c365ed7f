// A scene and a camera to draw in: a floor of 20 by 20 with a wall, 4 high, at its far end, around the origin. The
// camera stands 1.5 above the floor, 8 before the middle, and looks along -z; its image is 16 by 9, and as wide as tan
// 45/2 * 16/9 on each side.
#pragma once

#include <cmath>

#include "oc_core/frustum_editor/frustum_editor.h"

namespace ocelli::test {

inline Mesh editorMesh() {
  Mesh mesh;
  mesh.positions = {{-10, 0, 10}, {10, 0, 10}, {10, 0, -10}, {-10, 0, -10}, {-10, 4, -10}, {10, 4, -10}};
  mesh.colors = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {1, 1, 0}, {0, 1, 1}, {1, 0, 1}};
  mesh.triangles = {{0, 1, 2}, {0, 2, 3}, {3, 2, 5}, {3, 5, 4}};
  return mesh;
}

inline View editorView() {
  View view;
  view.eye = {0, 1.5f, 8};
  view.target = {0, 1.5f, 0};
  view.fovVerticalDegrees = 45;
  view.zNear = 0.1f;
  view.zFar = 100;
  return view;
}

inline PinholeCamera editorRoot(int width = 64, int height = 36) {
  return {editorView(), width, height};
}

/// Half the width of the image at a distance of 1.
inline double editorHalfWidth() {
  return std::tan(22.5 * 3.14159265358979 / 180) * 16 / 9;
}

struct EditorFixture {
  Mesh mesh = editorMesh();
  SceneGuides guides{};
  FrustumEditor editor{FrustumEditor::newGraphCamera(editorRoot()), "new camera", editorRoot(), mesh, guides};

  static PlanPointer at(double x, double y, PlanSide side = PlanSide::kTop) { return {side, {x, y}, 0.2, false}; }
  void stroke(const std::string& tool, const glm::dvec2& from, const glm::dvec2& to, PlanSide side = PlanSide::kTop) {
    editor.chooseTool(tool);
    editor.press(at(from.x, from.y, side));
    editor.dragTo(at(to.x, to.y, side));
    editor.release();
  }
  /// Drags a handle of the plan from above.
  void drag(const std::string& frustum, const std::string& kind, int index, const glm::dvec2& to,
            PlanSide side = PlanSide::kTop) {
    editor.chooseTool("move");
    editor.selectHandle(side, frustum, kind, index);
    const glm::dvec2 from = paperFromWorld(side, editor.selectedHandle(side)->at);
    editor.press(at(from.x, from.y, side));
    editor.dragTo(at(to.x, to.y, side));
    editor.release();
  }
  const DrawnFrustum& frustum(const std::string& name) const { return *editor.drawn().find(name); }
};

struct CurvedEditorFixture : EditorFixture {
  CurvedEditorFixture() { editor.open(FrustumEditor::newCurvedCamera(editorRoot()), "new camera"); }
};

}  // namespace ocelli::test
