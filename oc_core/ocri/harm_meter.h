// "Do no harm": which splats of a DDOC cost samples that the reference view sees. Its construction shrinks those.
#pragma once

#include <vector>

#include "oc_core/camera/ddoc_camera.h"
#include "oc_core/ocri/coverage.h"
#include "oc_core/ocri/distortion_splats.h"
#include "oc_core/ocri/reference_image.h"
#include "oc_core/render/rasterize_subdivided.h"

namespace ocelli {

struct Harm {
  size_t missing = 0;         ///< samples that the reference view sees, and the occlusion camera's image lacks
  std::vector<int> ofSplats;  ///< how many of them each splat is to blame for; several may be for the same
};

class HarmMeter {
 public:
  /// `seen` is what `reference` sees of `mesh`, `part` what the first camera to be measured may displace. All are kept
  /// by reference. With `renderer` that draws the first image, and `part` may be empty.
  HarmMeter(const PinholeCamera& reference, const Mesh& mesh, const FragmentImage& seen, const TrianglePart& part,
            const SubdivisionOptions& subdivision, const SceneRenderer* renderer = nullptr)
      : reference_(reference), mesh_(mesh), seen_(seen), part_(part), subdivision_(subdivision), renderer_(renderer) {}

  /// Each camera may displace less than the one before, but nothing that this one did not. `splats` and `owners` are
  /// those that its map was made from.
  Harm measure(const DdocCamera& camera, const std::vector<DistortionSplat>& splats, const SplatOwners& owners);
  /// The same of an image that has been drawn.
  Harm measureIn(const ReferenceImage& image, const DdocCamera& camera, const std::vector<DistortionSplat>& splats,
                 const SplatOwners& owners) const;

 private:
  ReferenceImage draw(const DdocCamera& camera);
  void gatherSurfaces(const DdocCamera& camera, const ReferenceImage& image);
  Image<SampleState> compare(const DdocCamera& camera, const ReferenceImage& image) const;
  ImagePoint seenAt(int x, int y) const {
    return {static_cast<float>(x) + 0.5f, static_cast<float>(y) + 0.5f, seen_(x, y).t};
  }

  const PinholeCamera& reference_;
  const Mesh& mesh_;
  const FragmentImage& seen_;
  const TrianglePart& part_;
  SubdivisionOptions subdivision_;
  const SceneRenderer* renderer_;
  Mesh surfaces_;              ///< what the reference view and the first image show of what is displaced
  TrianglePart surfacesPart_;  ///< all of it
};

}  // namespace ocelli
