// What the lens pane edits, as functions of the state: the lenses of a `gpc` camera (oc_core/camera/gpc_lens_edit.h),
// which one keys edit, and which are locked. Places are shares of the camera's image.
#pragma once

#include "display_sim/viewer/viewer_state.h"
#include "oc_core/camera/gpc_lens_edit.h"

namespace ocelli {

/// Of the image that lenses are edited in: distances are measured in its pixels.
glm::dvec2 lensImageSize(const ViewerState& state);
bool isLocked(const ViewerState& state, size_t lens);
void lockLens(ViewerState& state, size_t lens, bool locked);

/// Must follow each edit of `work.camera.gpc`. The other panes wait, as what they show takes long to build.
void lensesChanged(ViewerState& state);
/// Lets them follow where no edit came for kLensRestSeconds, or at once.
void followLenses(ViewerState& state, bool atOnce);
inline constexpr double kLensRestSeconds = 0.4;

/// A new lens that shows this place, and is the chosen one then; false where there is no room. The first one has the
/// size, zoom and transition of kNewLens, later ones those of the chosen lens.
bool addLensAt(ViewerState& state, const glm::dvec2& at);
/// The same as near to the middle as there is room.
bool addLensSomewhere(ViewerState& state);
void removeLensOf(ViewerState& state, size_t lens);
inline constexpr GpcRegion kNewLens{{0.5f, 0.5f}, {0.16f, 0.2f}, 3, 0.8f};

/// Opens the lens pane, with `gpc` where the camera has no lenses.
void openLensPane(ViewerState& state);

}  // namespace ocelli
