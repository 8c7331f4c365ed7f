#include "oc_core/scene/rig_record.h"

#include <algorithm>
#include <cmath>
#include <glm/gtc/type_ptr.hpp>

#include "oc_core/base/finite.h"

namespace ocelli {
namespace {

/// How a channel goes from key to key.
enum class Course : uint8_t { kStraight, kStepped, kCubic };

static_assert(sizeof(RigWeight) == 8, "lists of them are written as they stand");

/// Of what single precision leaves of a sum of weights.
constexpr float kWeightRounding = 1e-3f;

bool areFinite(const std::vector<float>& values) {
  return std::ranges::all_of(values, [](float x) { return std::isfinite(x); });
}

glm::mat4 finiteMatrix(RecordParser& parser) {
  const auto matrix = parser.value<glm::mat4>();
  const float* first = glm::value_ptr(matrix);
  if (!std::all_of(first, first + 16, [](float x) { return std::isfinite(x); })) {
    parser.fail("a node or a bone is placed by what is no number");
  }
  return matrix;
}

uint32_t indexBelow(RecordParser& parser, size_t size) {
  const uint32_t index = parser.number();
  if (index >= size) {
    parser.fail("a rig names what is not there");
  }
  return index;
}

void checkWeights(RecordParser& parser, const RigPart& part, size_t vertices) {
  if (part.first.size() != vertices + 1 || part.first.front() != 0 || part.first.back() != part.weights.size()) {
    parser.fail("the weights of a mesh are not those of its vertices");
  }
  for (size_t v = 0; v < vertices; ++v) {
    if (part.first[v] > part.first[v + 1]) {
      parser.fail("the weights of a vertex end before they begin");
    }
  }
  for (size_t v = 0; v < vertices; ++v) {
    float sum = 0;
    for (uint32_t i = part.first[v]; i < part.first[v + 1]; ++i) {
      const RigWeight& share = part.weights[i];
      if (share.bone >= part.bones.size() || !(share.weight > 0 && share.weight <= 1)) {
        parser.fail("a weight is out of range, or of a bone that is not there");
      }
      sum += share.weight;
    }
    if (part.first[v] < part.first[v + 1] && !(std::abs(sum - 1) <= kWeightRounding)) {
      parser.fail("the weights of a vertex do not add up to 1");
    }
  }
}

RigPart readPart(RecordParser& parser, size_t vertices, size_t nodes) {
  RigPart part;
  for (uint32_t left = parser.count(sizeof(uint32_t) + sizeof(glm::mat4)); left > 0; --left) {
    const uint32_t node = indexBelow(parser, nodes);
    part.bones.push_back({node, finiteMatrix(parser)});
  }
  if (!part.bones.empty()) {
    part.first = parser.list<uint32_t>(vertices + 1);
    part.weights = parser.list<RigWeight>(parser.count(sizeof(RigWeight)));
    checkWeights(parser, part, vertices);
  }
  for (uint32_t left = parser.count(sizeof(float)); left > 0; --left) {
    RigMorph morph{{}, parser.value<float>()};
    morph.offsets = parser.list<glm::vec3>(vertices);
    if (!std::isfinite(morph.weight) ||
        !std::ranges::all_of(morph.offsets, [](const glm::vec3& v) { return isFinite(v); })) {
      parser.fail("a morph target is no number");
    }
    part.morphs.push_back(std::move(morph));
  }
  return part;
}

RigChannel readChannel(RecordParser& parser, size_t nodes) {
  RigChannel channel;
  channel.node = indexBelow(parser, nodes);
  const auto target = parser.value<uint8_t>();
  const auto course = parser.value<uint8_t>();
  if (target > static_cast<uint8_t>(RigTarget::kWeights) || course > static_cast<uint8_t>(Course::kCubic)) {
    parser.fail("a channel moves in an unknown way");
  }
  channel.target = static_cast<RigTarget>(target);
  channel.steps = static_cast<Course>(course) == Course::kStepped;
  channel.width = parser.number();
  const uint32_t wanted = channel.target == RigTarget::kRotation ? 4 : 3;
  if (channel.target == RigTarget::kWeights ? channel.width == 0 : channel.width != wanted) {
    parser.fail("a channel has keys of another width");
  }
  const uint64_t keys = parser.count(sizeof(float));
  channel.times = parser.list<float>(keys);
  if (keys == 0 || !areFinite(channel.times) || channel.times.front() < 0 ||
      std::ranges::adjacent_find(channel.times, std::ranges::greater_equal()) != channel.times.end()) {
    parser.fail("the times of a channel are none, or do not ascend");
  }
  channel.values = parser.list<float>(keys * channel.width);
  if (static_cast<Course>(course) == Course::kCubic) {
    channel.tangents = parser.list<float>(2 * keys * channel.width);
  }
  if (!areFinite(channel.values) || !areFinite(channel.tangents)) {
    parser.fail("a key of a channel is no number");
  }
  return channel;
}

}  // namespace

void writeRig(RecordWriter& writer, const Rig& rig) {
  writer.count(rig.warnings.size());
  for (const std::string& warning : rig.warnings) {
    writer.text(warning);
  }
  writer.count(rig.nodes.size());
  for (const RigNode& node : rig.nodes) {
    writer.value(node.parent);
    writer.value(node.parentFromNode);
  }
  writer.list(rig.instanceNodes);
  for (const RigPart& part : rig.parts) {
    writer.count(part.bones.size());
    for (const RigBone& bone : part.bones) {
      writer.value(bone.node);
      writer.value(bone.boneFromMesh);
    }
    if (!part.bones.empty()) {
      writer.list(part.first);
      writer.count(part.weights.size());
      writer.list(part.weights);
    }
    writer.count(part.morphs.size());
    for (const RigMorph& morph : part.morphs) {
      writer.value(morph.weight);
      writer.list(morph.offsets);
    }
  }
  writer.count(rig.animations.size());
  for (const RigAnimation& animation : rig.animations) {
    writer.text(animation.name);
    writer.count(animation.channels.size());
    for (const RigChannel& channel : animation.channels) {
      writer.value(channel.node);
      writer.value(static_cast<uint8_t>(channel.target));
      writer.value(!channel.tangents.empty() ? Course::kCubic : channel.steps ? Course::kStepped : Course::kStraight);
      writer.value(channel.width);
      writer.count(channel.times.size());
      writer.list(channel.times);
      writer.list(channel.values);
      writer.list(channel.tangents);
    }
  }
}

Rig readRig(RecordParser& parser, const SceneRecord& record) {
  Rig rig;
  for (uint32_t left = parser.count(sizeof(uint32_t)); left > 0; --left) {
    rig.warnings.push_back(parser.text());
  }
  const uint32_t nodes = parser.count(sizeof(uint32_t) + sizeof(glm::mat4));
  for (uint32_t i = 0; i < nodes; ++i) {
    const uint32_t parent = parser.number();
    if (parent != kNoRigParent && parent >= i) {
      parser.fail("a node stands before its parent");
    }
    rig.nodes.push_back({parent, finiteMatrix(parser)});
  }
  for (size_t i = 0; i < record.instances.size(); ++i) {
    rig.instanceNodes.push_back(indexBelow(parser, nodes));
  }
  for (const TexturedMesh& part : record.parts) {
    rig.parts.push_back(readPart(parser, part.mesh.positions.size(), nodes));
  }
  for (uint32_t left = parser.count(2 * sizeof(uint32_t)); left > 0; --left) {
    RigAnimation animation;
    animation.name = parser.text();
    for (uint32_t channels = parser.count(3 * sizeof(uint32_t) + 2); channels > 0; --channels) {
      animation.channels.push_back(readChannel(parser, nodes));
    }
    if (!(animation.seconds() > 0)) {
      parser.fail("an animation takes no time");
    }
    rig.animations.push_back(std::move(animation));
  }
  return rig;
}

}  // namespace ocelli
