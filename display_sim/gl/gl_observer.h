// collectLight() on the GPU, for a display that is looked at while it moves.
//
// The lit voxels of a volume, few of all, are listed once. Each frame adds the light of every one of them to the pixels
// that its parts cover, as observer.cpp does, with the same whole numbers in any order: the same bits on every run. The
// parts are placed in single precision.
#pragma once

#include <optional>

#include "display_sim/gl/gl_volume.h"
#include "display_sim/gl/sweep_window.h"
#include "display_sim/observing/observer.h"

namespace ocelli {

/// How the parts of voxels, about a pixel large, appear in the image.
enum class GlSplat {
  kBoxes,   ///< spread over the pixels that they cover, as collectLight() does
  kPoints,  ///< in the pixel of their centre: the same light, grainier, and less work
};

struct GlObserverOptions {
  ObserverOptions view;                              ///< without lens and ambient light; its tone is for applyTone()
  std::optional<SweepWindow> window = std::nullopt;  ///< where given, this part of the sweep counts, not the exposure
  GlSplat splat = GlSplat::kBoxes;
};

class GlObserver {
 public:
  /// Throws GlError where the driver refuses a shader.
  explicit GlObserver(GlContext& context);

  /// Lists the lit voxels of `volume`, of this context, which must live and stay as it is while it is looked at.
  /// Waits for the GPU. Throws GlError where there are more than its buffers hold.
  void look(const GlVolume& volume);
  size_t litVoxels() const { return litVoxels_; }

  /// Draws the light that reaches each pixel. Throws as checkObserverOptions() and windowArcs() do, InputError for
  /// a lens and light of the room too, and GlError for an image that the GPU has no room for.
  void draw(const GlObserverOptions& options);

  /// RGBA32F, row 0 at the top, alpha 1: what draw() drew.
  const GlObject& light() const { return light_; }
  Image<glm::vec3> readLight() const;

 private:
  void resize(int width, int height);
  void drawLarge();
  double bindArcs(const std::vector<ExposedArc>& arcs, const ObserverOptions& view);

  GlContext* context_;
  GlObject list_;
  GlObject small_;
  GlObject large_;
  GlObject resolve_;

  const GlVolume* volume_ = nullptr;
  GlObject lit_;    ///< their count, then their indices
  GlObject queue_;  ///< likewise, of those that cover many pixels
  size_t litRoom_ = 0;
  size_t litVoxels_ = 0;

  int width_ = 0;
  int height_ = 0;
  GlObject low_;
  GlObject high_;
  GlObject light_;
  GlObject arcs_;
  GlObject arcsOfSlices_;
};

}  // namespace ocelli
