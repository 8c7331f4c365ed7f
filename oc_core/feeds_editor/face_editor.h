// Near faces of feeds drawn by hand, without a window: upright rectangles, which are segments in the plan of the place
// with a bottom and a top. One presses, drags and releases; each drag and each command is one step of undo.
//
// What is drawn need not be a graph camera: faces may cross, or lie before that of their parent. problem() says so, and
// graph() is the last one that was none of that.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "oc_core/feeds/feed_graph.h"
#include "oc_core/frustum_editor/editor_snaps.h"

namespace ocelli {

/// A near face in the plan: (x, z).
struct PlanFace {
  std::string feed;
  std::string parent;
  glm::dvec2 from{0};
  glm::dvec2 to{0};
  double bottom = 0;  ///< y
  double top = 0;
};

/// Faces are no narrower and no lower than that: metres.
inline constexpr double kMinFaceSize = 0.05;

class FaceEditor {
 public:
  /// `corners` are what ends of faces snap to, besides each other. Throws InputError where orderFrusta() does.
  FaceEditor(const FeedSetup& setup, std::vector<SnapPoint> corners = {});

  /// As it is drawn.
  const FeedSetup& setup() const { return setup_; }
  std::vector<PlanFace> faces() const;
  /// Why it is no graph camera, and what to do; empty where it is one.
  const std::string& problem() const { return problem_; }
  /// The last that is one; null where there was none.
  const std::shared_ptr<const FeedGraph>& graph() const { return graph_; }
  /// Changes whenever the setup does.
  int revision() const { return revision_; }

  /// A feed by its name; the first one to begin with.
  const std::string& selected() const { return selected_; }
  void select(const std::string& feed);
  void selectNext(int step);

  /// Takes hold of the end or the middle of a face within `reach` metres, and selects it; where there is none, and the
  /// selected feed has no face and is not the root, begins to draw one, a child of the root.
  void press(const glm::dvec2& paper, double reach);
  void dragTo(const glm::dvec2& paper, double reach, double grid, bool snaps);
  void release();
  void cancel();
  bool isDragging() const { return drag_.has_value(); }
  /// What the pointer snapped to while a drag goes on.
  const std::optional<SnapPoint>& snap() const { return snap_; }

  // Of the selected face; without one they do nothing.

  /// The next feed that may be its parent.
  void changeParent();
  void moveTop(double metres);
  void moveBottom(double metres);
  void remove();

  bool canUndo() const { return !undo_.empty(); }
  bool canRedo() const { return !redo_.empty(); }
  void undo();
  void redo();

 private:
  enum class Held { kFrom, kTo, kMiddle };
  struct Drag {
    std::string feed;
    Held held = Held::kTo;
    glm::dvec2 begin{0};
    PlanFace face;
    std::vector<FeedFrustum> before;
  };

  FeedFrustum* frustumOf(const std::string& feed);
  const FeedFrustum* frustumOf(const std::string& feed) const;
  bool isBelow(const std::string& feed, const std::string& ancestor) const;
  void setFace(const PlanFace& face);
  void change(std::vector<FeedFrustum> before);
  void check();

  FeedSetup setup_;
  std::vector<SnapPoint> corners_;
  std::string selected_;
  std::string problem_;
  std::shared_ptr<const FeedGraph> graph_;
  int revision_ = 0;
  std::optional<Drag> drag_;
  std::optional<SnapPoint> snap_;
  std::vector<std::vector<FeedFrustum>> undo_;
  std::vector<std::vector<FeedFrustum>> redo_;
};

/// A face as the plan shows it: of one that is no upright rectangle, the rectangle around it.
PlanFace planFaceOf(const FeedFrustum& frustum);

}  // namespace ocelli
