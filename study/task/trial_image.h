// The views of a trial's layout as pixels, by any renderer: what simulated subjects see, and what replays compare.
#pragma once

#include <functional>
#include <memory>
#include <optional>

#include "oc_core/image/png_file.h"
#include "oc_core/render/fragment_image.h"
#include "study/task/trial_layout.h"

namespace ocelli {

/// Draws what a camera sees of a mesh.
using StudyRenderer = std::function<FragmentImage(const StudyCamera& camera, const Mesh& mesh)>;

/// By rasterisation on the CPU.
FragmentImage rasterizeStudy(const StudyCamera& camera, const Mesh& mesh);

/// The mesh of the scene with its objects where the layout has them. There must be a scene.
Mesh meshOf(const TrialLayout& layout);

/// What shows in a view is that mesh, and its triangles are of those objects; pointers into `scene`, into `mesh`, or
/// into `shown`, which holds what the view shows in place of them.
struct ViewMesh {
  const Mesh* mesh;
  const std::vector<uint32_t>* objectOfTriangle;
};
/// `mesh` is that of `scene`, with the objects of a layout moved. Nothing where the view shows an image.
std::optional<ViewMesh> viewMesh(const ShownContent* shown, const StudyScene& scene, const Mesh& mesh);
/// What the view shows in place of the scene of the layout; null where it shows the scene.
std::shared_ptr<const ShownContent> shownIn(const TrialLayout& layout, const TrialLayout::View& view);

/// Which object is at each pixel of a view (identity_image.h).
Image<uint32_t> objectsIn(const TrialLayout& layout, const TrialLayout::View& view,
                          const StudyRenderer& renderer = rasterizeStudy);

/// The screen with the views of the layout in their places, black elsewhere; nothing but the views is drawn.
Image<Rgb8> viewsOf(const TrialLayout& layout, const TrialScreen& screen, const StudyRenderer& renderer);

/// Makes such an image, however.
using ViewPainter = std::function<Image<Rgb8>(const TrialLayout& layout, const TrialScreen& screen)>;

/// A number that differs, but for one chance in 2^64, where two images do. It depends on the renderer.
uint64_t pixelHashOf(const Image<Rgb8>& image);

}  // namespace ocelli
