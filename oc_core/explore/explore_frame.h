// What the explorer shows at a moment: cameras, and what a window draws over and beside their images.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "oc_core/constructor/maze_display.h"
#include "oc_core/constructor/multiperspective_camera.h"
#include "oc_core/explore/explore_walker.h"
#include "oc_core/scene/portal.h"

namespace ocelli {

/// A part of the image whose rays bend, as a polygon.
struct ExploreOutline {
  std::vector<glm::dvec2> corners;  ///< pixels of the whole picture
  int part = 0;                     ///< the same number in the plan: a window gives each a tint
  std::string name;
};

/// What a frustum, or a segment of curved rays, covers in the plan.
struct ExploreFootprint {
  std::vector<glm::vec2> corners;  ///< convex, on the paper: (x, z) of the world
  glm::vec2 viewpoint{0};
  int part = 0;
  std::string name;
  bool bends = false;   ///< whether rays have turned before they come here
  bool behind = false;  ///< of the backward camera
};

/// A state in words, for the status line.
struct ExploreNote {
  enum class Kind { kState, kProblem };
  Kind kind = Kind::kState;
  std::string text;

  bool operator==(const ExploreNote&) const = default;
};

struct ExploreFrame {
  explicit ExploreFrame(const PinholeCamera& view) : pinhole(view), camera(GraphCamera(view)) {}

  WalkerView walker;
  PinholeCamera pinhole;          ///< of the walker, as large as the picture
  MultiperspectiveCamera camera;  ///< of the picture, or of its right part where there is one behind
  /// The same pointer as in other frames: their `camera` is the same. Null: it may differ.
  std::shared_ptr<const void> still;
  /// The display surface of section 4.3.1.4: the image of this camera stands at the left. Both are as tall as the
  /// picture, and together as wide.
  std::optional<MultiperspectiveCamera> behind;
  std::vector<SplitLine> splits;  ///< pixels of the whole picture, those behind with it
  double deployed = 0;            ///< 0: the picture is the pinhole's; 1: the camera is as its constructor makes it
  /// Where a change cannot pass through the pinhole, the picture dissolves from what it was at `dissolveFrom`: its
  /// share, from 1 to 0.
  double dissolve = 0;
  int dissolveFrom = 0;  ///< the number of the frame that it dissolves from
  int number = 0;        ///< counts the frames of a session

  std::vector<ExploreOutline> outlines;
  std::vector<ExploreFootprint> footprints;
  std::vector<ExploreNote> notes;
};

}  // namespace ocelli
