#include "oc_core/scene/rig.h"

#include <algorithm>
#include <array>
#include <glm/gtc/quaternion.hpp>
#include <optional>

#include "oc_core/base/parallel.h"

namespace ocelli {
namespace {

constexpr size_t kSkinVerticesPerRange = 1 << 12;

glm::quat rotationOf(const float* value) {
  const glm::quat q(value[3], value[0], value[1], value[2]);
  const float length = glm::length(q);
  return length > 0 ? q / length : glm::quat(1, 0, 0, 0);
}

/// What the channels of an animation say of the place of one node.
struct NodePlace {
  std::optional<glm::vec3> position;
  std::optional<glm::quat> rotation;
  std::optional<glm::vec3> scale;

  bool moves() const { return position || rotation || scale; }
  glm::mat4 matrix() const {
    glm::mat4 place = glm::mat4_cast(rotation.value_or(glm::quat(1, 0, 0, 0)));
    const glm::vec3 factor = scale.value_or(glm::vec3(1));
    for (glm::length_t axis = 0; axis < 3; ++axis) {
      place[axis] *= factor[axis];
    }
    place[3] = glm::vec4(position.value_or(glm::vec3(0)), 1);
    return place;
  }
};

void read(const RigChannel& channel, double seconds, NodePlace& place) {
  std::array<float, 4> value{};
  switch (channel.target) {
    case RigTarget::kPosition:
      sample(channel, seconds, value.data());
      place.position = glm::vec3(value[0], value[1], value[2]);
      break;
    case RigTarget::kRotation:
      sample(channel, seconds, value.data());
      place.rotation = rotationOf(value.data());
      break;
    case RigTarget::kScale:
      sample(channel, seconds, value.data());
      place.scale = glm::vec3(value[0], value[1], value[2]);
      break;
    case RigTarget::kWeights:
      break;
  }
}

/// Between two keys of a cubic spline that are `duration` seconds apart: `share` of that after key `key`.
void sampleSpline(const RigChannel& channel, size_t key, float duration, float share, float* value) {
  const uint32_t width = channel.width;
  const float* from = channel.values.data() + key * width;
  const float* after = channel.tangents.data() + (2 * key + 1) * width;
  const float* before = channel.tangents.data() + (2 * key + 2) * width;
  const float t2 = share * share;
  const float t3 = t2 * share;
  for (uint32_t i = 0; i < width; ++i) {
    value[i] = (2 * t3 - 3 * t2 + 1) * from[i] + duration * (t3 - 2 * t2 + share) * after[i] +
               (3 * t2 - 2 * t3) * from[width + i] + duration * (t3 - t2) * before[i];
  }
}

}  // namespace

double RigAnimation::seconds() const {
  float last = 0;
  for (const RigChannel& channel : channels) {
    last = std::max(last, channel.times.empty() ? 0.0f : channel.times.back());
  }
  return static_cast<double>(last);
}

void sample(const RigChannel& channel, double seconds, float* value) {
  const std::vector<float>& times = channel.times;
  const auto after = std::upper_bound(times.begin(), times.end(), seconds,
                                      [](double a, float b) { return a < static_cast<double>(b); });
  const auto next = static_cast<size_t>(after - times.begin());
  const size_t key = next == 0 ? 0 : next - 1;
  const float* from = channel.values.data() + key * channel.width;
  if (next == 0 || next == times.size() || channel.steps) {
    std::copy_n(from, channel.width, value);
    return;
  }
  const float* to = from + channel.width;
  const double duration = static_cast<double>(times[next]) - static_cast<double>(times[key]);
  const auto share = static_cast<float>((seconds - static_cast<double>(times[key])) / duration);
  if (!channel.tangents.empty()) {
    sampleSpline(channel, key, static_cast<float>(duration), share, value);
    return;
  }
  if (channel.target == RigTarget::kRotation) {
    const glm::quat q = glm::slerp(rotationOf(from), rotationOf(to), share);
    const std::array<float, 4> numbers{q.x, q.y, q.z, q.w};
    std::copy(numbers.begin(), numbers.end(), value);
    return;
  }
  for (uint32_t i = 0; i < channel.width; ++i) {
    value[i] = from[i] + (to[i] - from[i]) * share;
  }
}

std::vector<glm::mat4> worldFromNodes(const Rig& rig, const RigAnimation& animation, double seconds) {
  std::vector<NodePlace> places(rig.nodes.size());
  for (const RigChannel& channel : animation.channels) {
    read(channel, seconds, places[channel.node]);
  }
  std::vector<glm::mat4> worldFromNode(rig.nodes.size());
  for (size_t i = 0; i < rig.nodes.size(); ++i) {
    const RigNode& node = rig.nodes[i];
    const glm::mat4 place = places[i].moves() ? places[i].matrix() : node.parentFromNode;
    worldFromNode[i] = node.parent == kNoRigParent ? place : worldFromNode[node.parent] * place;
  }
  return worldFromNode;
}

void skin(const RigPart& part, const std::vector<glm::vec3>& positions, const std::vector<glm::mat4>& worldFromNode,
          const glm::mat4& worldFromMesh, const std::vector<float>& morphWeights, std::vector<glm::vec3>& moved) {
  std::vector<glm::mat4> worldFromBone;
  for (const RigBone& bone : part.bones) {
    worldFromBone.push_back(worldFromNode[bone.node] * bone.boneFromMesh);
  }
  moved.resize(positions.size());
  parallelFor(positions.size(), kSkinVerticesPerRange, [&](size_t begin, size_t end) {
    for (size_t v = begin; v < end; ++v) {
      glm::vec3 p = positions[v];
      for (size_t i = 0; i < part.morphs.size(); ++i) {
        p += morphWeights[i] * part.morphs[i].offsets[v];
      }
      glm::vec4 sum(0);
      const uint32_t first = part.first.empty() ? 0 : part.first[v];
      const uint32_t last = part.first.empty() ? 0 : part.first[v + 1];
      for (uint32_t i = first; i < last; ++i) {
        sum += part.weights[i].weight * (worldFromBone[part.weights[i].bone] * glm::vec4(p, 1));
      }
      moved[v] = glm::vec3(first < last ? sum : worldFromMesh * glm::vec4(p, 1));
    }
  });
}

}  // namespace ocelli
