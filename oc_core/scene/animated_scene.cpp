#include "oc_core/scene/animated_scene.h"

#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <bit>
#include <glm/matrix.hpp>
#include <utility>

#include "oc_core/base/check.h"
#include "oc_core/base/error.h"
#include "oc_core/base/finite.h"
#include "oc_core/base/number_text.h"
#include "oc_core/base/parallel.h"
#include "oc_core/base/printable_text.h"

namespace ocelli {
namespace {

constexpr size_t kAnimatedVerticesPerRange = 1 << 14;

size_t animationNamed(const Rig& rig, const std::string& wanted, const std::string& where) {
  if (wanted.empty()) {
    return 0;
  }
  for (size_t i = 0; i < rig.animations.size(); ++i) {
    if (rig.animations[i].name == wanted) {
      return i;
    }
  }
  const size_t number = numberFromText<size_t>(wanted).value_or(0);
  if (number >= 1 && number <= rig.animations.size()) {
    return number - 1;
  }
  std::string names;
  for (size_t i = 0; i < rig.animations.size(); ++i) {
    names += fmt::format("{}{} \"{}\"", i == 0 ? "" : ", ", i + 1, printableText(rig.animations[i].name));
  }
  throw InputError("there is no animation \"" + printableText(wanted) + "\" in this file", where,
                   "--animation with a name or a number: " + names);
}

std::vector<uint32_t> usedVertices(const Mesh& mesh) {
  std::vector<char> isUsed(mesh.positions.size(), 0);
  for (const glm::uvec3& t : mesh.triangles) {
    isUsed[t.x] = isUsed[t.y] = isUsed[t.z] = 1;
  }
  std::vector<uint32_t> used;
  for (uint32_t v = 0; v < isUsed.size(); ++v) {
    if (isUsed[v] != 0) {
      used.push_back(v);
    }
  }
  return used;
}

/// Adds a copy of a mesh: its triangles between the vertices that are used, and their colours.
void addCopy(Mesh& flat, const Mesh& mesh, const std::vector<uint32_t>& used, bool colored, bool mirrored) {
  std::vector<uint32_t> place(mesh.positions.size(), 0);
  for (const uint32_t v : used) {
    place[v] = static_cast<uint32_t>(flat.positions.size());
    flat.positions.push_back(mesh.positions[v]);
    if (colored) {
      flat.colors.push_back(mesh.color(v));
    }
  }
  for (const glm::uvec3& t : mesh.triangles) {
    const glm::uvec3 placed(place[t.x], place[t.y], place[t.z]);
    flat.triangles.push_back(mirrored ? glm::uvec3(placed.x, placed.z, placed.y) : placed);
  }
}

/// The weights of a mesh's morphs, at a node.
std::vector<float> morphWeights(const RigPart& part, uint32_t node, const RigAnimation& animation, double seconds) {
  std::vector<float> weights;
  for (const RigMorph& morph : part.morphs) {
    weights.push_back(morph.weight);
  }
  for (const RigChannel& channel : animation.channels) {
    if (channel.target == RigTarget::kWeights && channel.node == node) {
      std::vector<float> now(channel.width);
      sample(channel, seconds, now.data());
      std::copy_n(now.begin(), std::min(now.size(), weights.size()), weights.begin());
    }
  }
  return weights;
}

}  // namespace

AnimatedScene::AnimatedScene(std::vector<RiggedMesh> meshes, std::vector<Instance> instances, Rig rig,
                             const std::string& animation, const std::string& where,
                             const std::optional<PointFacts>& points)
    : meshes_(std::move(meshes)),
      instances_(std::move(instances)),
      rig_(std::move(rig)),
      where_(where),
      points_(points) {
  OC_CHECK(
      !rig_.animations.empty() && rig_.parts.size() == meshes_.size() && rig_.instanceNodes.size() == instances_.size(),
      "a rig is of these meshes and copies, and moves them");
  animation_ = animationNamed(rig_, animation, where);
  for (const RiggedMesh& mesh : meshes_) {
    used_.push_back(usedVertices(mesh.mesh));
  }
  const bool colored =
      std::ranges::any_of(instances_, [&](const Instance& i) { return !meshes_[i.mesh].mesh.colors.empty(); });
  for (const Instance& instance : instances_) {
    addCopy(flat_, meshes_[instance.mesh].mesh, used_[instance.mesh], colored,
            glm::determinant(glm::mat3(instance.worldFromMesh)) < 0);
  }
  validate(flat_, where);
  if (std::ranges::any_of(meshes_, &RiggedMesh::isUnlit)) {
    for (const Instance& instance : instances_) {
      unlit_.insert(unlit_.end(), used_[instance.mesh].size(), meshes_[instance.mesh].isUnlit ? 1 : 0);
    }
  }
}

double AnimatedScene::durationSeconds() const {
  return rig_.animations[animation_].seconds();
}

MotionFacts AnimatedScene::facts() const {
  MotionFacts facts;
  for (const RigAnimation& animation : rig_.animations) {
    facts.animations.push_back({animation.name, animation.seconds()});
  }
  facts.played = animation_;
  facts.points = points_;
  return facts;
}

std::vector<double> AnimatedScene::sampleTimes() const {
  constexpr size_t kTimes = 65;
  return evenTimes(durationSeconds(), kTimes);
}

void AnimatedScene::moveTo(double seconds, MovedMesh& moved) const {
  if (moved.topology != 1) {
    moved = {.mesh = flat_, .topology = 1, .unlit = unlit_};
  }
  const double time = std::clamp(seconds, 0.0, durationSeconds());
  moved.shape = std::bit_cast<uint64_t>(time);
  const RigAnimation& animation = rig_.animations[animation_];
  const std::vector<glm::mat4> worldFromNode = worldFromNodes(rig_, animation, time);
  std::vector<glm::vec3> bound;
  std::vector<glm::vec3> placed;
  std::atomic<bool> lost = false;
  size_t first = 0;
  for (size_t i = 0; i < instances_.size(); ++i) {
    const size_t mesh = instances_[i].mesh;
    const uint32_t node = rig_.instanceNodes[i];
    const RiggedMesh& rigged = meshes_[mesh];
    const auto rigVertices = static_cast<ptrdiff_t>(rigged.mesh.positions.size() - rigged.added.size());
    bound.assign(rigged.mesh.positions.begin(), rigged.mesh.positions.begin() + rigVertices);
    skin(rig_.parts[mesh], bound, worldFromNode, worldFromNode[node],
         morphWeights(rig_.parts[mesh], node, animation, time), placed);
    for (const EdgeVertex& added : rigged.added) {
      placed.push_back(placed[added.low] * (1 - added.share) + placed[added.high] * added.share);
    }
    const std::vector<uint32_t>& used = used_[mesh];
    parallelFor(used.size(), kAnimatedVerticesPerRange, [&](size_t begin, size_t end) {
      for (size_t v = begin; v < end; ++v) {
        moved.mesh.positions[first + v] = placed[used[v]];
        if (!isFinite(placed[used[v]])) {
          lost = true;
        }
      }
    });
    first += used.size();
  }
  if (lost) {
    throw InputError(fmt::format("the animation moves a vertex to where no number is, at {:g} s", time), where_,
                     "export the scene again, or play another animation");
  }
}

}  // namespace ocelli
