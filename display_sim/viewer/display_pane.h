// The simulated display: what an eye sees of the volume while the screen turns, in real time or slow motion, and the
// screen itself.
#pragma once

#include <string>

#include "display_sim/gl/gl_observer.h"
#include "display_sim/viewer/pane_target.h"
#include "display_sim/viewer/scene_draw.h"
#include "display_sim/viewer/viewer_data.h"

namespace ocelli {

/// What the eye still sees of the sweep, and how much brighter that is than what the display shows at its own speed.
struct ShownSweep {
  SweepWindow window;
  double gain = 1;
};

/// The light of a slice fades over the persistence: over `persistence x speed` of sweep, but over one slice at least.
/// Where that is a whole refresh or more, the eye sees a steady image. A display that turns slower shows each slice for
/// longer: the part of the sweep that is still shown is as much brighter, up to
/// kMaxSlowMotionGain.
ShownSweep shownSweep(const DisplayShown& shown, const DisplayProfile& profile);
inline constexpr double kMaxSlowMotionGain = 6;

/// Whether it looks the same wherever the screen stands: at full speed it is a blur, and its light does not flicker.
bool looksSteady(const DisplayShown& shown, const DisplayProfile& profile);

class DisplayPane {
 public:
  explicit DisplayPane(GlContext& context);

  /// Returns whether it drew: not where nothing has
  /// changed since the last call. Hold a GlScope.
  bool draw(const ViewerState& state, const ViewerData& data, const glm::ivec2& size, float lineScale);

  const PaneTarget& target() const { return target_; }
  /// Why there is nothing to see; empty where there is.
  const std::string& problem() const { return problem_; }

 private:
  void look(const SlicedVolume& volume);
  void showLight(double gain);

  GlContext* context_;
  PaneTarget target_;
  LineDraw lineDraw_;
  GlObject program_;
  GlObject vertexArray_;
  GlObserver observer_;
  std::shared_ptr<const SlicedVolume> volume_;  ///< that the observer looks at
  std::optional<GlVolume> glVolume_;
  double gain_ = 0;  ///< automatic, for one refresh, times the square of the focal length in pixels
  /// What the image was drawn for.
  struct Key {
    std::shared_ptr<const SlicedVolume> volume;
    DisplayShown shown;
    View view;
    glm::ivec2 size{0};
    float lineScale = 0;
    bool operator==(const Key&) const = default;
  };
  std::optional<Key> drawn_;
  std::string problem_;
};

}  // namespace ocelli
