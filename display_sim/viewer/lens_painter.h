// The pictures of the lens pane, on the CPU: those of `ocelli render` with the same camera, view and size, to the byte.
// What a picture has in common with the one before is kept: the scene as the eye's pinhole sees it, while only lenses
// move, and the acceleration structure of rays.
#pragma once

#include <array>
#include <memory>
#include <optional>

#include "display_sim/viewer/background_work.h"
#include "oc_core/focus/rate_heat.h"
#include "oc_core/image/png_file.h"
#include "oc_core/render/projected_mesh.h"
#include "oc_core/render/raycast.h"

namespace ocelli {

struct LensWanted {
  bool shows = false;                             ///< whether pictures are wanted: not of a pane that is hidden
  std::shared_ptr<const LoadedScene> scene = {};  ///< null: none yet
  View view;
  glm::ivec2 size{0};  ///< of the picture, pixels
  GpcLayout layout;
  LensesShown::Method method = LensesShown::Method::kRaster;
  bool rates = false;

  bool canBePainted() const { return shows && scene != nullptr; }
  bool operator==(const LensWanted&) const = default;
};

/// From the least to the greatest rate of a layout, which may have no regions.
RateRange rateRangeOf(const GpcLayout& layout);

class LensPainter {
 public:
  static constexpr std::array kScales{1.0, 0.5, 0.25};
  static constexpr bool kStartsSmall = false;

  /// In another size than is wanted: a preview. Throws InputError for views that are none. Tells no progress.
  Image<Rgb8> paint(const LensWanted& wanted, const glm::ivec2& size, const Progress& progress = {});

 private:
  FragmentImage drawn(const LensWanted& wanted, const GpcCamera& camera);

  std::shared_ptr<const LoadedScene> scene_;  ///< that the following are of, and which they refer to
  std::optional<ProjectedMesh> projected_;
  std::unique_ptr<RayScene> rays_;
};

}  // namespace ocelli
