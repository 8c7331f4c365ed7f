// How far quilts are from the scene's own views: missing samples, and how visible the difference is.
#pragma once

#include <vector>

#include "display_sim/quilt/quilt_picture.h"
#include "oc_core/base/progress.h"
#include "oc_core/evaluation/frame_errors.h"

namespace ocelli {

/// One for each quilt, summed over its views; wrong fronts and false skins are not counted. The quilts keep their
/// depths. `scene` is in the stretched world. Images are compared as they are written, with what was filled in.
std::vector<FrameErrors> quiltErrors(const QuiltViews& views, const Mesh& scene,
                                     const std::vector<const QuiltPicture*>& quilts, const Progress& progress = {});

/// A tile of a quilt as an image, with points in space where samples are known.
ViewFrame tileFrame(const QuiltViews& views, const QuiltPicture& quilt, int view);

}  // namespace ocelli
