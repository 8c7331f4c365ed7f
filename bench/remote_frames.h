// Frames of remote visualisation to measure by: what a client looks at while it holds one image, and what it should
// see.
#pragma once

#include <vector>

#include "oc_core/camera/view.h"
#include "oc_core/image/png_file.h"
#include "oc_core/remote/remote_scene.h"

namespace ocelli {

/// How far the client goes from the view that it asked an image for.
struct RemoteRange {
  double pan = 0.2;           ///< widths and heights of the screen, to each side
  double zoom = 2;            ///< at most
  double translation = 0.03;  ///< of the eye, times the distance of the nearest surface
};

/// Views of a smooth path that begins at `view`: it pans and zooms in all combinations within the range, from the same
/// eye, or (`moves`) from eyes within the translation.
std::vector<View> remotePath(const View& view, const glm::ivec2& screen, const RemoteRange& range, bool moves,
                             double nearest, size_t frames);

/// What a pinhole sees, with the mean of `samples` x `samples` rays a pixel, sRGB-encoded; black where nothing is.
Image<Rgb8> directFrame(const RemoteScene& scene, const View& view, const glm::ivec2& screen, int samples);

}  // namespace ocelli
