// Drawing a graph or curved ray camera by hand (section 4.3.2.1), without a window: plans in which one presses, drags
// and releases, tools, handles with numbers, snapping, undo and redo. A window shows plans and the camera's image; a
// script (editor_script.h) does the same.
//
// A drag is one step of undo. While it goes on, the camera follows as far as it is one: a drag into what is no camera,
// or in which frusta overlap, keeps the last camera that is one, and message() says why. Overlaps are shown: drawn() is
// what is being drawn, with the witness of each overlap, also where camera() stayed behind.
#pragma once

#include <array>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "oc_core/constructor/camera_editor.h"
#include "oc_core/frustum_editor/editor_snaps.h"
#include "oc_core/frustum_editor/editor_tools.h"
#include "oc_core/frustum_editor/handle_kinds.h"

namespace ocelli {

/// How far away from a handle one may press it, and how far drawing snaps: pixels of a plan.
inline constexpr double kPlanReachPixels = 8;

/// Where and how one points into a plan.
struct PlanPointer {
  PlanSide side = PlanSide::kTop;
  glm::dvec2 paper{0};
  double reach = 0;   ///< kPlanReachPixels of them, on the paper
  bool snaps = true;  ///< Shift turns it off

  static PlanPointer at(const PlanWindow& window, const glm::dvec2& pixel, bool snaps = true) {
    return {window.side, window.paperFromPixel(pixel), kPlanReachPixels * window.unitsPerPixel, snaps};
  }
};

class FrustumEditor {
 public:
  /// Camera files to begin with: the root alone, seen as a pinhole sees.
  static std::string newGraphCamera(const PinholeCamera& root);
  static std::string newCurvedCamera(const PinholeCamera& root);

  /// `mesh` must live as long as the editor. `reference` is the view of a camera that has none, and the size of images
  /// where the file does not say it.
  /// Throws InputError where CameraEditor does, and for a scene without triangles.
  FrustumEditor(const std::string& text, const std::string& where, const PinholeCamera& reference, const Mesh& mesh,
                const SceneGuides& guides);

  /// Another file; undo does not lead back. Where the file is wrong the editor stays as it was, and message() says why.
  bool open(const std::string& text, const std::string& where);

  /// The camera, also while a drag goes on; `text()` is its file, as `--camera` takes it.
  const MultiperspectiveCamera& camera() const { return camera_; }
  const std::string& text() const { return text_; }
  /// The same for images of another width and the same shape, such as small ones while a drag goes on.
  MultiperspectiveCamera cameraOfWidth(int width) const;
  /// Changes whenever camera() does.
  int revision() const { return revision_; }
  /// What to draw in plans. Its frusta may overlap, which camera() does not.
  const DrawnCamera& drawn() const { return *drawn_; }
  /// What went wrong, or what should be known; "" for nothing. Sentences for the user.
  const std::string& message() const { return message_; }
  bool canUndo() const { return editor_.canUndo(); }
  bool canRedo() const { return editor_.canRedo(); }

  const EditorTool& tool() const { return *tool_; }
  /// Throws InputError for an unknown name; message() refuses a tool that is not for this kind of camera.
  void chooseTool(const std::string& name);

  /// With the tool "move" a handle, the selected one before others: a click on it selects the next one that lies there.
  void press(const PlanPointer& pointer);
  void dragTo(const PlanPointer& pointer);
  /// The camera is what it was when the drag last led to one.
  void release();
  /// The camera is as before the drag.
  void cancel();
  bool isDragging() const { return drag_.has_value(); }
  /// The stroke of a tool that is being drawn.
  std::optional<PlanStroke> stroke() const;
  /// What the pointer snapped to, while a drag goes on.
  const std::optional<SnapPoint>& snap() const { return snap_; }

  /// "" for none.
  const std::string& selectedFrustum() const { return selectedFrustum_; }
  /// As it is now; nothing where none is selected, or the plan does not show it.
  std::optional<FrustumHandle> selectedHandle(PlanSide side) const;
  /// Throws InputError where there is no such frustum.
  void select(const std::string& frustum);
  /// Throws InputError where the plan has no such handle.
  void selectHandle(PlanSide side, const std::string& frustum, const std::string& kind, int index);
  /// The next handle of the plan, or with a step of -1 the one before it.
  void selectNextHandle(PlanSide side, int step = 1);
  /// Of the selected handle; empty where there is none.
  std::vector<HandleNumber> numbers(PlanSide side) const;

  // Each of these is one step of undo. False, and message(), where it cannot be done: the camera is as before then.
  bool moveHandle(PlanSide side, const glm::dvec2& paper);
  bool nudge(PlanSide side, const glm::dvec2& paper);
  /// One of numbers(), by its name.
  bool typeNumber(PlanSide side, const std::string& number, double value);
  bool renameSelected(const std::string& to);
  bool removeSelected();
  bool allowOverlap(bool allowed);
  /// Any edit of CameraEditor, "undo" and "redo" among them.
  bool apply(const std::string& edit);
  bool undo();
  bool redo();

 private:
  struct Drag {
    PlanPointer from;
    PlanPointer to;
    std::optional<FrustumHandle> handle;  ///< else it is a stroke of the tool
    std::shared_ptr<const DrawnCamera> before;
    std::string lastEdit;  ///< that led to camera_; "" for none yet
    std::string selects;   ///< the frustum to select then
    std::optional<FrustumHandle>
        ifClicked;  ///< to select where the pointer does not move: another one on the same spot
  };

  void showDocument();
  void show(const std::string& text, MultiperspectiveCamera camera);
  StrokeEdit editOfDrag() const;
  void followDrag();
  PlanPointer snappedPointer(const PlanPointer& pointer);
  const std::vector<SnapPoint>& sceneSnapsOf(PlanSide side);
  void keepSelection();
  std::vector<FrustumHandle> handlesNear(const PlanPointer& pointer) const;

  const Mesh* mesh_;
  SceneGuides guides_;
  Box world_;
  CameraEditor editor_;
  std::string text_;
  MultiperspectiveCamera camera_;
  std::shared_ptr<const DrawnCamera> drawn_;
  int revision_ = 0;
  std::string message_;
  const EditorTool* tool_;
  std::string selectedFrustum_;
  std::optional<FrustumHandle> selectedHandle_;
  std::optional<Drag> drag_;
  std::optional<SnapPoint> snap_;
  std::array<std::optional<std::vector<SnapPoint>>, 3> sceneSnaps_;  ///< by PlanSide
};

}  // namespace ocelli
