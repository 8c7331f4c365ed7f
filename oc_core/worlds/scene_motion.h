// A moving SCENE as everything downstream takes it: fitted once for all of its motion, and shaded at each time.
#pragma once

#include <map>
#include <memory>
#include <string>
#include <vector>

#include "oc_core/base/progress.h"
#include "oc_core/scene/moving_scene.h"
#include "oc_core/scene/vertex_shading.h"
#include "oc_core/worlds/scene_source.h"

namespace ocelli {

class SceneMotion {
 public:
  /// `where` is the scene, for errors. Throws InputError where it has no extent to fit.
  ///
  /// One scale and one translation fit the whole motion (unitFromMotion()). Creases are those that a topology has when
  /// it is seen first, at the earliest of the sampleTimes(); what is smooth then stays so. Normals follow the motion.
  SceneMotion(std::unique_ptr<MovingScene> scene, const SceneOptions& options, const std::string& where);

  double durationSeconds() const { return scene_->durationSeconds(); }
  MotionFacts facts() const { return scene_->facts(); }
  std::vector<double> sampleTimes() const { return scene_->sampleTimes(); }
  const glm::mat4& worldFromScene() const { return worldFromScene_; }

  /// The mesh at that time, until the next call. The same object each time, whose triangles change with topology()
  /// alone.
  const Mesh& at(double seconds);
  /// The mesh that at() gave last. Not before the first call.
  const Mesh& mesh() const { return mesh_; }
  /// Of that mesh: the same number stands for the same triangles and as many vertices. 0 before the first call.
  uint64_t topology() const { return topology_; }
  /// The same number stands for the same mesh, where the topology is the same, too.
  uint64_t shape() const { return raw_.shape; }

 private:
  struct Topology {
    std::vector<uint32_t> sources;  ///< of each vertex: which one of the moving scene it is
    std::vector<glm::uvec3> triangles;
    std::vector<uint8_t> unlit;              ///< as MovedMesh::unlit
    std::unique_ptr<VertexShading> shading;  ///< nullptr: colours stay as they are
  };
  Topology& prepare();

  std::unique_ptr<MovingScene> scene_;
  Shading shadingKind_;
  glm::mat4 worldFromScene_{1};
  MovedMesh raw_;
  std::map<uint64_t, Topology> topologies_;
  Mesh mesh_;
  std::vector<glm::vec3> unshaded_;
  uint64_t coloring_ = 0;  ///< of the unshaded colours
  uint64_t topology_ = 0;
};

/// Whether SCENE may move: a folder, a built-in scene that does, or a file of a format that has animations. Only
/// loadMotion() tells whether such a file has one.
bool mayMove(const std::string& source);

/// Nothing where the scene stands still. Throws InputError for a spec, a file or an animation that is wrong.
std::unique_ptr<SceneMotion> loadMotion(const std::string& source, const SceneOptions& options,
                                        const Progress& progress = {});

}  // namespace ocelli
