// A file's animation as a moving scene: its meshes as the nodes, bones and morph targets of a rig move them.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "oc_core/scene/alpha_cut.h"
#include "oc_core/scene/moving_scene.h"
#include "oc_core/scene/rig.h"
#include "oc_core/scene/scene.h"

namespace ocelli {

/// A mesh of the file with what moves it.
struct RiggedMesh {
  Mesh mesh;
  /// Of its last vertices, each stands between two before it (bakeTextures()); the rig moves the others.
  std::vector<EdgeVertex> added{};
  bool isUnlit = false;  ///< as Instance::isLit says of copies
};

class AnimatedScene final : public MovingScene {
 public:
  /// `instances` are copies of `meshes`. `animation` is a name or a number from 1 on; empty for the first one. Throws
  /// InputError naming `where` and the animations that there are for another one. The rig must be valid, as
  /// sceneFromRecord() gives it, and have an animation that takes some time. `points`: those of facts().
  AnimatedScene(std::vector<RiggedMesh> meshes, std::vector<Instance> instances, Rig rig, const std::string& animation,
                const std::string& where, const std::optional<PointFacts>& points = {});

  double durationSeconds() const override;
  MotionFacts facts() const override;
  std::vector<double> sampleTimes() const override;
  /// Throws InputError where the numbers of the animation move a vertex out of all bounds.
  void moveTo(double seconds, MovedMesh& moved) const override;

 private:
  std::vector<RiggedMesh> meshes_;
  std::vector<Instance> instances_;
  Rig rig_;
  std::string where_;
  std::optional<PointFacts> points_;
  size_t animation_ = 0;
  std::vector<std::vector<uint32_t>> used_;  ///< of each mesh: the vertices that its triangles use
  Mesh flat_;                                ///< all copies, but for where the vertices are
  std::vector<uint8_t> unlit_;               ///< as MovedMesh::unlit
};

}  // namespace ocelli
