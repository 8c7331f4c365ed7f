// The views of a trial's layout as pixels, by any renderer: what simulated subjects see, and what replays compare.
#pragma once

#include <functional>

#include "oc_core/base/png_file.h"
#include "oc_core/render/fragment_image.h"
#include "study/task/trial_layout.h"

namespace ocelli {

/// Draws what a camera sees of a mesh.
using StudyRenderer = std::function<FragmentImage(const StudyCamera& camera, const Mesh& mesh)>;

/// By rasterisation on the CPU.
FragmentImage rasterizeStudy(const StudyCamera& camera, const Mesh& mesh);

/// The mesh of the scene with its objects where the layout has them. There must be a scene.
Mesh meshOf(const TrialLayout& layout);

/// The screen with the views of the layout in their places, black elsewhere; nothing but the views is drawn.
Image<Rgb8> viewsOf(const TrialLayout& layout, const TrialScreen& screen, const StudyRenderer& renderer);

/// Makes such an image, however.
using ViewPainter = std::function<Image<Rgb8>(const TrialLayout& layout, const TrialScreen& screen)>;

/// A number that differs, but for one chance in 2^64, where two images do. It depends on the renderer.
uint64_t pixelHashOf(const Image<Rgb8>& image);

}  // namespace ocelli
