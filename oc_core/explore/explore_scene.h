// A scene to walk in (section 4.3.1): the mesh with what is known of its ways, prepared for images at the rate of a
// screen, for steps that end at walls, and for clicks.
//
// Frame and units are those of the scene; y is up. Lengths that people know in metres, such as the height of eyes, are
// multiplied by metre().
#pragma once

#include <atomic>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <vector>

#include "oc_core/base/progress.h"
#include "oc_core/render/mesh_blocks.h"
#include "oc_core/render/raycast.h"
#include "oc_core/worlds/scene_source.h"

namespace ocelli {

struct ExploreSceneOptions {
  /// Units of the scene in a metre. Nothing: as metreOf() of oc_core/walkable/walk_options.h guesses from its size.
  std::optional<double> metre{};
  /// Finds where one can walk, where the guides of the scene do not tell it. Empty: nothing finds it. Throws InputError
  /// where there is no floor.
  std::function<WalkMap(const Mesh& mesh, double metre, const Progress& progress)> findWays{};
};

/// Whether it is known where one can walk.
struct WalkMapStatus {
  enum class State { kUnknown, kSearching, kFound, kFailed };
  State state = State::kUnknown;
  std::string stage;    ///< of the search
  double fraction = 0;  ///< of that stage, 0 to 1
  std::string problem;  ///< why there is none
};

/// What a ray meets.
struct ExploreHit {
  glm::vec3 position{0};
  glm::vec3 normal{0, 1, 0};  ///< unit, towards where the ray came from
  float distance = 0;         ///< along the ray
  uint32_t object = 0;        ///< identity; 0 is structure
};

class ExploreScene {
 public:
  /// Throws InputError where the scene is empty.
  explicit ExploreScene(GuidedScene scene, ExploreSceneOptions options = {});
  /// Ends the search for ways at its next step.
  ~ExploreScene();
  ExploreScene(const ExploreScene&) = delete;
  ExploreScene& operator=(const ExploreScene&) = delete;

  const GuidedScene& scene() const { return scene_; }
  const Mesh& mesh() const { return scene_.mesh; }
  const SceneGuides& guides() const { return scene_.guides; }
  const MeshBlocks& blocks() const { return blocks_; }
  const RayScene& rays() const { return *rays_; }
  const Box& bounds() const { return bounds_; }
  double metre() const { return metre_; }
  /// Boxes of the objects by identity; empty for structure.
  const std::vector<Box>& objects() const { return objects_; }

  /// Where one can walk: null while that is not known. It stays valid as long as the scene.
  const WalkMap* walkMap() const;
  /// Begins the search, on a thread of its own, where it has not begun. Returns at once.
  void searchWays();
  /// Until the search has ended, which begins where it has not.
  void waitForWays();
  WalkMapStatus waysStatus() const;

  /// The first surface from a point along a unit direction, within `reach`. Safe to call from many threads.
  std::optional<ExploreHit> cast(const glm::vec3& from, const glm::vec3& direction, float reach) const;
  /// The same along the ray of a camera.
  std::optional<ExploreHit> cast(const RayPath& ray) const;

 private:
  void search();

  GuidedScene scene_;
  ExploreSceneOptions options_;
  Box bounds_;
  double metre_ = 1;
  MeshBlocks blocks_;
  std::unique_ptr<RayScene> rays_;
  std::vector<Box> objects_;

  mutable std::mutex mutex_;  ///< guards what follows
  WalkMapStatus status_;
  std::optional<WalkMap> found_;
  std::atomic<bool> stopsSearch_{false};
  std::thread searching_;
};

}  // namespace ocelli
