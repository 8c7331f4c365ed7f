// What a plan of an editor looks like, as a drawing in the pixels of its pane: a window paints it, and scripts and
// tests write it as a figure.
#pragma once

#include "oc_core/drawing/figure.h"
#include "oc_core/frustum_editor/frustum_editor.h"
#include "oc_core/image/png_file.h"
#include "oc_core/multiperspective/plan_section.h"

namespace ocelli {

/// The scene under a plan: it stays the same while one draws.
struct PlanBackdrop {
  PlanSide side = PlanSide::kTop;
  glm::vec2 lower{0};  ///< corners of `ground` on the paper
  glm::vec2 upper{0};
  Image<Rgb8> ground;  ///< pale
  std::vector<SectionLine> section;
};

/// Pixels of the longer side of the image of the ground.
PlanBackdrop planBackdrop(const Mesh& mesh, PlanSide side, const glm::dvec3& eye, int groundPixels = 1200);

/// Frusta, planes, handles, the selected handle's numbers, the stroke, what snaps, and overlaps in red with their
/// witnesses. `backdrop` may be null, and is of the same side as the window.
Drawing planDrawing(const FrustumEditor& editor, const PlanWindow& window, const PlanBackdrop* backdrop);

/// The same as a figure of the window's size, with the message of the editor below it.
Figure editorFigure(const FrustumEditor& editor, const PlanWindow& window, const PlanBackdrop* backdrop);

/// "12.3 m" and the like: a number beside a handle.
std::string numberText(const HandleNumber& number);

}  // namespace ocelli
