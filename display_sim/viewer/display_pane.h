// The simulated display: what an eye sees of the volume while the screen turns, in real time or slow motion, and the
// screen itself.
#pragma once

#include <string>

#include "display_sim/observer.h"
#include "display_sim/viewer/pane_target.h"
#include "display_sim/viewer/scene_draw.h"
#include "display_sim/viewer/viewer_data.h"

namespace ocelli {

/// What the eye holds on to, in seconds of a display that turns as fast as it does: persistence times speed, but at
/// least one slice and at most one refresh of those that stand.
double shownExposure(const DisplayShown& shown, const DisplayProfile& profile);

/// A display that turns slower shows a slice for longer: the light of a shorter exposure is raised in proportion, up to
/// this.
inline constexpr double kMostSlowMotionGain = 6;

class DisplayPane {
 public:
  explicit DisplayPane(GlContext& context);

  /// Hold a GlScope.
  void draw(const ViewerState& state, const ViewerData& data, const glm::ivec2& size, float lineScale);

  const PaneTarget& target() const { return target_; }
  /// Why there is nothing to see; empty where there is.
  const std::string& problem() const { return problem_; }

 private:
  void showLight(const Image<glm::vec3>& light, double gain);
  std::vector<ColoredLine> lines(const DisplayShown& shown, const DisplayProfile& profile, float lineScale) const;

  GlContext* context_;
  PaneTarget target_;
  LineDraw lineDraw_;
  GlObject program_;
  GlObject vertexArray_;
  GlObject light_;
  glm::ivec2 lightSize_{0};
  double gain_ = 0;  ///< automatic, of one whole refresh
  uint64_t gainVersion_ = 0;
  std::string problem_;
};

}  // namespace ocelli
