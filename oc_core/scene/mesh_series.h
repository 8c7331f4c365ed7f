// A numbered series of meshes as a moving scene: an animation by its frames.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "oc_core/base/progress.h"
#include "oc_core/scene/moving_scene.h"

namespace ocelli {

/// What is shown between the times of two meshes.
enum class BetweenMeshes {
  kHold,    ///< the earlier one
  kLinear,  ///< where both have the same topology: positions and colours on straight lines from one to the other
};

/// Files of a folder whose names hold a number before their ending, which they share, in the order of the numbers:
/// walk_1.ply, walk_2.ply, ..., walk_10.ply. Throws InputError where there is none, or two have the same number.
std::vector<std::filesystem::path> numberedFiles(const std::filesystem::path& folder, const std::string& ending);

/// The ending of the numbered meshes of a folder: the one of .ply, .obj, .stl, .off, .gltf, .glb, .fbx, .dae, .3ds,
/// .xyz, .pts and .pcd that is there. Throws InputError where there is none, or more than one.
std::string meshEndingIn(const std::filesystem::path& folder);

struct SeriesOptions {
  double meshesPerSecond = 24;
  BetweenMeshes between = BetweenMeshes::kHold;
};

class MeshSeries final : public MovingScene {
 public:
  /// One mesh or more, each validated. Mesh i stands for the times from i / rate on; the last one for as long as the
  /// others. Meshes with the same triangles, as many vertices, and colours both or neither, have one topology.
  MeshSeries(std::vector<Mesh> meshes, const SeriesOptions& options);

  double durationSeconds() const override;
  MotionFacts facts() const override;
  std::vector<double> sampleTimes() const override;
  void moveTo(double seconds, MovedMesh& moved) const override;

 private:
  struct Frame {
    std::vector<glm::vec3> positions;
    std::vector<glm::vec3> colors;
    size_t topology = 0;
  };

  SeriesOptions options_;
  std::vector<Frame> frames_;
  std::vector<std::vector<glm::uvec3>> topologies_;  ///< their triangles
};

}  // namespace ocelli
