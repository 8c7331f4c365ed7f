// What is seen in a trial: a maze and the objects in it, which may move.
//
// Objects are the landmarks of the maze. Each has a range of vertices of its own, so that a renderer that holds the
// mesh moves an object by moving these. Walls and floor are grey: objects are all that catches the eye.
#pragma once

#include <memory>
#include <span>
#include <vector>

#include "oc_core/scene/maze.h"
#include "oc_core/scene/mesh.h"
#include "oc_core/worlds/maze_mesh.h"

namespace ocelli {

struct VertexRange {
  size_t first = 0;
  size_t count = 0;
};

class StudyScene {
 public:
  /// `maze` must be valid. The entrance is closed by a wall, but where cameras look in through it.
  explicit StudyScene(const Maze& maze, bool closedEntrance = true)
      : StudyScene(maze, {.plain = true, .closedEntrance = closedEntrance, .coarse = false}) {}

  /// The same surfaces in fewer triangles, without the pattern of walls and floor: for whoever asks what is where and
  /// not how it looks.
  const StudyScene& bare() const { return bare_ ? *bare_ : *this; }

  /// Another for each scene that is made; a copy, which shows the same, has that of its original.
  uint64_t id() const { return id_; }
  const Maze& maze() const { return maze_; }
  size_t objectCount() const { return ranges_.size(); }
  /// Shaded, all objects where their landmarks stand.
  const Mesh& mesh() const { return mesh_; }
  /// 0 is the structure, i + 1 object i.
  const std::vector<uint32_t>& objectOfTriangle() const { return objectOfTriangle_; }
  VertexRange verticesOf(size_t object) const { return ranges_[object]; }
  /// Around object i where its landmark stands.
  const Box& boxOf(size_t object) const { return boxes_[object]; }

  /// `mesh`, which is a copy of mesh(), with each object moved by its offset from where its landmark stands. Offsets
  /// beyond the last are 0.
  void moveObjects(Mesh& mesh, std::span<const glm::vec3> offsets) const;

 private:
  StudyScene(const Maze& maze, const MazeLook& look);

  uint64_t id_;
  Maze maze_;
  Mesh mesh_;
  std::vector<uint32_t> objectOfTriangle_;
  std::vector<VertexRange> ranges_;
  std::vector<Box> boxes_;
  std::shared_ptr<const StudyScene> bare_{};
};

}  // namespace ocelli
