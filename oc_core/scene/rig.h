// What moves the meshes of a file: a tree of nodes, bones with weights (skins), morph targets, and animations whose
// channels move them. As a file has it; animated_scene.h plays it.
//
// Based on the Khronos Group's glTF 2.0 specification, sections 3.7.2 (skins, morph targets) and 3.11 (animations).
#pragma once

#include <cstdint>
#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>
#include <string>
#include <vector>

namespace ocelli {

inline constexpr uint32_t kNoRigParent = 0xffffffff;

struct RigNode {
  uint32_t parent = kNoRigParent;  ///< stands before it in the list
  glm::mat4 parentFromNode{1};     ///< at rest
};

struct RigBone {
  uint32_t node = 0;
  glm::mat4 boneFromMesh{1};  ///< when the mesh was bound to it
};

/// A share of a vertex that a bone moves.
struct RigWeight {
  uint32_t bone = 0;
  float weight = 0;  ///< in (0, 1]
};

/// A shape that a mesh takes on as far as its weight says.
struct RigMorph {
  std::vector<glm::vec3> offsets;  ///< of each vertex
  float weight = 0;                ///< at rest
};

/// How a mesh is moved other than by its node.
struct RigPart {
  std::vector<RigBone> bones;
  std::vector<uint32_t> first;     ///< vertices + 1 offsets into `weights`; empty where there are no bones
  std::vector<RigWeight> weights;  ///< of a vertex: none, which leaves it to the node, or some whose sum is 1
  std::vector<RigMorph> morphs;
};

enum class RigTarget : uint8_t {
  kPosition,  ///< three values: of the node in its parent
  kRotation,  ///< four: a quaternion, x y z w
  kScale,     ///< three
  kWeights,   ///< one for each of the morphs of the node's meshes
};

/// Moves one property of a node. Between two keys values lie on a straight line, those of rotations on the shorter arc
/// (spherical linear interpolation), stay as they were (`steps`), or run along a cubic Hermite spline (`tangents`; glTF
/// 2.0, appendix C.5).
struct RigChannel {
  uint32_t node = 0;
  RigTarget target = RigTarget::kPosition;
  bool steps = false;
  uint32_t width = 0;         ///< values of a key; 3 or 4 as the target has them
  std::vector<float> times;   ///< of one key or more, seconds, ascending, not negative
  std::vector<float> values;  ///< `width` of each key
  /// Of a cubic spline, of each key: how fast its `width` values change before it and after it, per second. Empty of
  /// all else.
  std::vector<float> tangents{};
};

struct RigAnimation {
  std::string name;
  std::vector<RigChannel> channels;  ///< of a target of a node one; nodes with a channel stand where these say alone

  /// The time of the last key.
  double seconds() const;
};

struct Rig {
  std::vector<RigNode> nodes;
  std::vector<uint32_t> instanceNodes;   ///< of each copy of a mesh: its node
  std::vector<RigPart> parts;            ///< of each mesh
  std::vector<RigAnimation> animations;  ///< none in a file that only poses its meshes
  std::vector<std::string> warnings;     ///< what is not played as the file says
};

/// The value of a channel at that time: `width` numbers. Before the first key and after the last one it stays.
void sample(const RigChannel& channel, double seconds, float* value);

/// World from node, for each node, at that time of the animation. Nodes with a channel for their place stand by
/// position, rotation and scale, those that have no channel being 0, no rotation, and 1.
std::vector<glm::mat4> worldFromNodes(const Rig& rig, const RigAnimation& animation, double seconds);

/// The mesh `positions`, as it is bound, moved by bones: the weighted sum of what each of its bones makes of a vertex
/// (linear blend skinning). What has no weights is moved by `worldFromMesh`. `morphWeights`: one a morph. Writes as
/// many vertices to `moved`. On all threads.
void skin(const RigPart& part, const std::vector<glm::vec3>& positions, const std::vector<glm::mat4>& worldFromNode,
          const glm::mat4& worldFromMesh, const std::vector<float>& morphWeights, std::vector<glm::vec3>& moved);

}  // namespace ocelli
