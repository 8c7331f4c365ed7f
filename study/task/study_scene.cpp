#include "study/task/study_scene.h"

#include <algorithm>
#include <atomic>

#include "oc_core/base/check.h"
#include "oc_core/scene/scene.h"
#include "oc_core/scene/shading.h"

namespace ocelli {
namespace {

uint64_t nextId() {
  static std::atomic<uint64_t> last{0};
  return ++last;
}

}  // namespace

StudyScene::StudyScene(const Maze& maze, const MazeLook& look)
    : id_(nextId()), maze_(maze), ranges_(maze.landmarks.size()), boxes_(maze.landmarks.size()) {
  Scene scene = makeMazeScene(maze, look);
  // Shaded one by one: shading a mesh puts new vertices at its end, and objects must keep theirs together.
  for (Mesh& mesh : scene.meshes) {
    bakeLambert(mesh);
  }
  mesh_ = flatten(scene);
  objectOfTriangle_ = objectOfTriangles(scene);
  size_t first = 0;
  for (const Instance& instance : scene.instances) {
    const size_t count = scene.meshes[instance.mesh].positions.size();
    if (instance.object > 0) {
      ranges_[instance.object - 1] = {first, count};
      boxes_[instance.object - 1] = boundsOf(scene.meshes[instance.mesh]);
    }
    first += count;
  }
  OC_CHECK(first == mesh_.positions.size(), "instances of a maze follow one another");
  if (!look.coarse) {
    MazeLook coarse = look;
    coarse.coarse = true;
    bare_.reset(new StudyScene(maze, coarse));
  }
}

void StudyScene::moveObjects(Mesh& mesh, std::span<const glm::vec3> offsets) const {
  for (size_t i = 0; i < std::min(ranges_.size(), offsets.size()); ++i) {
    for (size_t v = ranges_[i].first; v < ranges_[i].first + ranges_[i].count; ++v) {
      mesh.positions[v] = mesh_.positions[v] + offsets[i];
    }
  }
}

}  // namespace ocelli
