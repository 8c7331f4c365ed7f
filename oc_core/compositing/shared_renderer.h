// A scene that ranks draw together: each draws its share of the triangles, and every image is composited by depth
// (composite.h), so that each rank gets the same fragments as it would from drawing the whole scene: byte for byte
// those of the rasterisers of oc_core/render.
//
// What is constructed from images (oc_core/ocri) runs in every rank alike, with this as its renderer. So each rank has
// the whole mesh, where it looks up what fragments show.
#pragma once

#include <memory>

#include "oc_core/compositing/composite.h"
#include "oc_core/render/scene_renderer.h"

namespace ocelli {

/// What drawing together has cost this rank so far.
struct SharedDrawing {
  int images = 0;           ///< composited
  double drawSeconds = 0;   ///< this rank's share
  double waitSeconds = 0;   ///< for the slowest rank, before compositing
  double mergeSeconds = 0;  ///< compositing
};

/// Draws from one thread, and its calls are made in the same order in all ranks.
class SharedRenderer final : public SceneRenderer {
 public:
  /// `mesh` is the same in all ranks. Both must outlive it.
  SharedRenderer(const Mesh& mesh, Ranks& ranks, Compositing how);
  ~SharedRenderer() override;

  FragmentImage draw(const PinholeCamera& camera) const override;
  FragmentImage draw(const SpocCamera& camera) const override;
  FragmentImage draw(const ReversePinholeCamera& camera) const override;
  FragmentImage draw(const GpcCamera& camera) const override;
  FragmentImage draw(const DdocCamera& camera, const FragmentImage& seen,
                     const SubdivisionOptions& subdivision) const override;
  FragmentImage drawLines(const PinholeCamera& base, const EpipolarLines& lines) const override;
  FragmentImage draw(const EpipolarCamera& camera, const FragmentImage& baseImage) const override;
  FragmentImage drawTrimmed(const EpipolarCamera& camera, const FragmentImage& baseImage) const override;
  FragmentImage draw(const GraphCamera& camera) const override;
  FragmentImage draw(const CurvedRayCamera& camera) const override;

  /// To be called in every rank after the last image. Throws WorkError where some go on drawing, as requireAgreement()
  /// does before each image.
  void finish() const;

  const SharedDrawing& cost() const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

/// Triangles [begin, end) of a mesh with the vertices that they use, and perhaps some between these; without colours.
Mesh trianglesOf(const Mesh& mesh, size_t begin, size_t end);

/// Throws WorkError where ranks come here with different numbers: they have not computed the same, and would wait for
/// each other in vain, or mix what does not belong together.
void requireAgreement(Ranks& ranks, uint64_t number);

}  // namespace ocelli
