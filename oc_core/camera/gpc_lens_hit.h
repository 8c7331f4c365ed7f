// What of the lenses of a general pinhole camera lies at a place of its image, and the drag of what was taken hold of
// there (gpc_lens_edit.h).
#pragma once

#include <optional>

#include "oc_core/camera/gpc_lens_edit.h"

namespace ocelli {

enum class LensPart {
  kInside,     ///< the region, or its transition: moves the lens
  kCorner,     ///< of the region: sizes it
  kOuterEdge,  ///< of the transition: widens it
};

struct LensHit {
  size_t lens = 0;
  LensPart part = LensPart::kInside;
  LensCorner corner = LensCorner::kTopLeft;  ///< for kCorner
  bool operator==(const LensHit&) const = default;
};

/// `at` and the lengths as in gpc_lens_edit.h. Corners and edges are met within `reach` pixels, but corners of a lens
/// no farther inside of it than a third of its size, so that there is a part that moves it. Corners come before edges.
std::optional<LensHit> lensHitAt(const GpcLayout& layout, const glm::dvec2& at, double reach, const glm::dvec2& size);

/// One drag, from where the pointer took hold.
class LensDrag {
 public:
  LensDrag(const GpcLayout& layout, const LensHit& hit, const glm::dvec2& at, const glm::dvec2& size);

  const LensHit& hit() const { return hit_; }
  /// The layout with the pointer at this place. The same place gives the same layout, whatever came between.
  GpcLayout layoutAt(const glm::dvec2& at) const;

 private:
  GpcLayout start_;
  LensHit hit_;
  glm::dvec2 grabbed_;  ///< from the pointer to what it holds
  glm::dvec2 size_;
};

}  // namespace ocelli
