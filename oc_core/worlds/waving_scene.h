// A mesh that waves like a plant in a current: every horizontal layer goes round in a circle, each a little later than
// the one below. All triangles move at all times, and its motion repeats without a jump.
#pragma once

#include <glm/vec2.hpp>
#include <vector>

#include "oc_core/scene/moving_scene.h"

namespace ocelli {

class WavingScene final : public MovingScene {
 public:
  /// `rest` is validated. A vertex at the height h, from 0 at the bottom of the mesh to 1 at its top, stands at time t
  /// at
  ///   rest + sway (cos a, 0, sin a),  a = 2 pi (t / seconds - h).
  /// `sway` is in the lengths of the mesh; `seconds`, one round, is positive.
  WavingScene(Mesh rest, double seconds, float sway);

  double durationSeconds() const override { return seconds_; }
  MotionFacts facts() const override { return {}; }
  std::vector<double> sampleTimes() const override;
  void moveTo(double seconds, MovedMesh& moved) const override;

 private:
  Mesh rest_;
  double seconds_;
  std::vector<glm::vec2> circles_;  ///< of each vertex: sway (cos b, sin b), b = -2 pi h
};

}  // namespace ocelli
