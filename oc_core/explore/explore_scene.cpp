#include "oc_core/explore/explore_scene.h"

#include <cmath>
#include <glm/geometric.hpp>
#include <utility>

#include "oc_core/base/error.h"
#include "oc_core/constructor/object_boxes.h"
#include "oc_core/constructor/walk_from_maze.h"
#include "oc_core/walkable/walk_options.h"

namespace ocelli {
namespace {

/// Thrown through a search whose scene is not needed any more.
struct SearchStopped {};

/// Grids know where one can walk.
GuidedScene withWays(GuidedScene scene) {
  if (boundsOf(scene.mesh).empty()) {
    throw InputError("there is nothing to walk in", "the scene is empty", "choose another scene");
  }
  if (scene.guides.maze && !scene.guides.walk) {
    scene.guides.walk = walkMapOf(*scene.guides.maze);
  }
  return scene;
}

}  // namespace

ExploreScene::ExploreScene(GuidedScene scene, ExploreSceneOptions options)
    : scene_(withWays(std::move(scene))),
      options_(std::move(options)),
      bounds_(boundsOf(scene_.mesh)),
      metre_(options_.metre ? *options_.metre : metreOf("", scene_).units),
      blocks_(scene_.mesh),
      rays_(std::make_unique<RayScene>(scene_.mesh, RayScene::Quality::kLow)),
      objects_(objectBoxes(scene_)) {
  if (!objects_.empty()) {
    objects_.front() = {};
  }
  if (scene_.guides.walk) {
    status_.state = WalkMapStatus::State::kFound;
  }
}

ExploreScene::~ExploreScene() {
  stopsSearch_ = true;
  if (searching_.joinable()) {
    searching_.join();
  }
}

const WalkMap* ExploreScene::walkMap() const {
  if (scene_.guides.walk) {
    return &*scene_.guides.walk;
  }
  const std::scoped_lock lock(mutex_);
  return found_ ? &*found_ : nullptr;
}

void ExploreScene::searchWays() {
  const std::scoped_lock lock(mutex_);
  if (status_.state != WalkMapStatus::State::kUnknown) {
    return;
  }
  if (!options_.findWays) {
    status_ = {WalkMapStatus::State::kFailed, {}, 0, "it is not known where one can walk here"};
    return;
  }
  status_.state = WalkMapStatus::State::kSearching;
  searching_ = std::thread([this] { search(); });
}

void ExploreScene::search() {
  WalkMapStatus ended{WalkMapStatus::State::kFound, {}, 1, {}};
  std::optional<WalkMap> found;
  try {
    found = options_.findWays(scene_.mesh, metre_, [this](std::string_view stage, double fraction) {
      if (stopsSearch_) {
        throw SearchStopped{};
      }
      const std::scoped_lock lock(mutex_);
      status_.stage = stage;
      status_.fraction = fraction;
    });
  } catch (const std::exception& error) {
    ended = {WalkMapStatus::State::kFailed, {}, 0, error.what()};
  } catch (...) {
    ended = {WalkMapStatus::State::kFailed, {}, 0, "the search for where one can walk has not ended"};
  }
  const std::scoped_lock lock(mutex_);
  found_ = std::move(found);
  status_ = std::move(ended);
}

void ExploreScene::waitForWays() {
  searchWays();
  if (searching_.joinable()) {
    searching_.join();
  }
}

WalkMapStatus ExploreScene::waysStatus() const {
  const std::scoped_lock lock(mutex_);
  return status_;
}

std::optional<ExploreHit> ExploreScene::cast(const glm::vec3& from, const glm::vec3& direction, float reach) const {
  return cast(RayPath{from, from + direction * reach});
}

std::optional<ExploreHit> ExploreScene::cast(const RayPath& ray) const {
  const Fragment fragment = rays_->intersect(ray);
  if (!fragment.covered()) {
    return std::nullopt;
  }
  const glm::uvec3& t = scene_.mesh.triangles[fragment.triangle];
  const glm::vec3& a = scene_.mesh.positions[t.x];
  const glm::vec3 across = glm::cross(scene_.mesh.positions[t.y] - a, scene_.mesh.positions[t.z] - a);
  const float length = glm::length(across);
  ExploreHit hit;
  hit.position = positionOf(fragment, scene_.mesh);
  hit.distance = fragment.t - ray.tMin();
  const size_t segment = ray.positionNear(hit.position).segment;
  const glm::vec3 arriving = ray[segment + 1] - ray[segment];
  hit.normal = length > 0 ? across / length : -glm::normalize(arriving);
  if (glm::dot(hit.normal, arriving) > 0) {
    hit.normal = -hit.normal;
  }
  hit.object =
      fragment.triangle < scene_.objectOfTriangle.size() ? scene_.objectOfTriangle[fragment.triangle] : uint32_t{0};
  return hit;
}

}  // namespace ocelli
