#include "oc_core/scene/import/file_rig.h"

#include <assimp/anim.h>
#include <assimp/scene.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/gtc/type_ptr.hpp>
#include <glm/matrix.hpp>
#include <map>
#include <set>
#include <span>
#include <string>
#include <utility>

#include "oc_core/base/error.h"
#include "oc_core/base/printable_text.h"
#include "oc_core/scene/import/file_materials.h"
#include "oc_core/scene/import/gltf_curves.h"

namespace ocelli {
namespace {

namespace fs = std::filesystem;

/// Where a file does not say; Assimp's own documentation has it.
constexpr double kUsualTicksPerSecond = 25;

glm::mat4 placeOf(const aiMatrix4x4& matrix, const fs::path& path) {
  const glm::mat4 place = glm::transpose(glm::make_mat4(&matrix.a1));
  const float* first = glm::value_ptr(place);
  if (!std::all_of(first, first + 16, [](float x) { return std::isfinite(x); })) {
    throw InputError("a node or a bone is placed by numbers that are not finite", path.string(),
                     "export the scene again");
  }
  return place;
}

class RigReader {
 public:
  RigReader(const aiScene& scene, const SceneRecord& record, const fs::path& path)
      : scene_(scene), record_(record), path_(path) {}

  std::optional<Rig> read(const std::vector<const aiNode*>& instanceNodes) {
    addNode(*scene_.mRootNode, kNoRigParent);
    if (isGltfScene(scene_)) {
      curves_ = readGltfCurves(path_);
    }
    for (unsigned i = 0; i < scene_.mNumAnimations; ++i) {
      addAnimation(*scene_.mAnimations[i], i);
    }
    if (rig_.animations.empty() && !hasPose()) {
      return std::nullopt;
    }
    for (const aiNode* node : instanceNodes) {
      rig_.instanceNodes.push_back(numbers_.at(node));
    }
    for (unsigned m = 0; m < scene_.mNumMeshes; ++m) {
      rig_.parts.push_back(record_.parts[m].mesh.positions.empty() ? RigPart{} : partOf(*scene_.mMeshes[m]));
    }
    warn();
    return std::move(rig_);
  }

 private:
  /// Whether bones or morph targets move a mesh also where nothing is played.
  bool hasPose() const {
    for (unsigned m = 0; m < scene_.mNumMeshes; ++m) {
      if (scene_.mMeshes[m]->mNumBones > 0 || scene_.mMeshes[m]->mNumAnimMeshes > 0) {
        return true;
      }
    }
    return false;
  }

  void addNode(const aiNode& node, uint32_t parent) {
    const auto number = static_cast<uint32_t>(rig_.nodes.size());
    rig_.nodes.push_back({parent, placeOf(node.mTransformation, path_)});
    nodes_.push_back(&node);
    numbers_.emplace(&node, number);
    byName_.emplace(node.mName.C_Str(), number);
    for (unsigned i = 0; i < node.mNumChildren; ++i) {
      addNode(*node.mChildren[i], number);
    }
  }

  std::optional<uint32_t> nodeNamed(const aiString& name) {
    const auto found = byName_.find(name.C_Str());
    if (found == byName_.end()) {
      missing_.insert(name.C_Str());
      return std::nullopt;
    }
    return found->second;
  }

  void addAnimation(const aiAnimation& source, unsigned number) {
    RigAnimation animation;
    animation.name = source.mName.C_Str();
    const double perSecond = source.mTicksPerSecond > 0 && std::isfinite(source.mTicksPerSecond)
                                 ? source.mTicksPerSecond
                                 : kUsualTicksPerSecond;
    for (unsigned i = 0; i < source.mNumChannels; ++i) {
      addNodeChannels(animation, *source.mChannels[i], number, perSecond);
    }
    for (unsigned i = 0; i < source.mNumMorphMeshChannels; ++i) {
      addMorphChannel(animation, *source.mMorphMeshChannels[i], number, perSecond);
    }
    if (animation.seconds() > 0) {
      rig_.animations.push_back(std::move(animation));
    }
  }

  /// Adds a key, where it is one. `tangents`: before and after it, along cubic splines.
  static void addKey(RigChannel& channel, double seconds, std::span<const float> values,
                     std::span<const float> tangents = {}) {
    const auto time = static_cast<float>(seconds);
    const bool forward = channel.times.empty() || time > channel.times.back();
    const auto areNumbers = [](std::span<const float> list) {
      return std::ranges::all_of(list, [](float x) { return std::isfinite(x); });
    };
    if (std::isfinite(time) && time >= 0 && forward && areNumbers(values) && areNumbers(tangents)) {
      channel.times.push_back(time);
      channel.values.insert(channel.values.end(), values.begin(), values.end());
      channel.tangents.insert(channel.tangents.end(), tangents.begin(), tangents.end());
    }
  }

  /// The keys that a glTF file itself has for a channel of this width; of any, where that is 0. False where they cannot
  /// be read.
  bool addOwnKeys(RigChannel& channel, unsigned animation, const aiString& node, const char* path) {
    const auto found = curves_.find({animation, node.C_Str(), path});
    if (found == curves_.end()) {
      return false;
    }
    const GltfCurve& curve = found->second;
    const bool isCubic = curve.interpolation == "CUBICSPLINE";
    channel.steps = curve.interpolation == "STEP";
    if (curve.width == 0 || (channel.width != 0 && channel.width != curve.width)) {
      hasLostSplines_ = hasLostSplines_ || isCubic;
      return false;
    }
    const size_t width = channel.width = curve.width;
    std::vector<float> tangents;
    for (size_t i = 0; i < curve.times.size(); ++i) {
      const std::span<const float> lists = std::span(curve.keys).subspan(i * width * (isCubic ? 3 : 1));
      if (isCubic) {
        tangents.assign(lists.begin(), lists.begin() + static_cast<ptrdiff_t>(width));
        tangents.insert(tangents.end(), lists.begin() + static_cast<ptrdiff_t>(2 * width),
                        lists.begin() + static_cast<ptrdiff_t>(3 * width));
      }
      addKey(channel, static_cast<double>(curve.times[i]), lists.subspan(isCubic ? width : 0, width), tangents);
    }
    return true;
  }

  void addNodeChannels(RigAnimation& animation, const aiNodeAnim& source, unsigned number, double perSecond) {
    const std::optional<uint32_t> node = nodeNamed(source.mNodeName);
    if (!node) {
      return;
    }
    const auto addVectors = [&](RigChannel& channel, const aiVectorKey* keys, unsigned count) {
      for (unsigned i = 0; i < count; ++i) {
        const aiVector3D& v = keys[i].mValue;
        addKey(channel, keys[i].mTime / perSecond, std::array{v.x, v.y, v.z});
      }
    };
    RigChannel position{*node, RigTarget::kPosition, false, 3, {}, {}};
    if (!addOwnKeys(position, number, source.mNodeName, "translation")) {
      addVectors(position, source.mPositionKeys, source.mNumPositionKeys);
    }
    RigChannel rotation{*node, RigTarget::kRotation, false, 4, {}, {}};
    if (!addOwnKeys(rotation, number, source.mNodeName, "rotation")) {
      for (unsigned i = 0; i < source.mNumRotationKeys; ++i) {
        const aiQuaternion& q = source.mRotationKeys[i].mValue;
        addKey(rotation, source.mRotationKeys[i].mTime / perSecond, std::array{q.x, q.y, q.z, q.w});
      }
    }
    RigChannel scale{*node, RigTarget::kScale, false, 3, {}, {}};
    if (!addOwnKeys(scale, number, source.mNodeName, "scale")) {
      addVectors(scale, source.mScalingKeys, source.mNumScalingKeys);
    }
    if (position.times.empty() && rotation.times.empty() && scale.times.empty()) {
      return;
    }
    // What has no keys stays as it is at rest.
    aiVector3D restScale;
    aiQuaternion restRotation;
    aiVector3D restPosition;
    nodes_[*node]->mTransformation.Decompose(restScale, restRotation, restPosition);
    if (position.times.empty()) {
      setKey(position, std::array{restPosition.x, restPosition.y, restPosition.z});
    }
    if (rotation.times.empty()) {
      setKey(rotation, std::array{restRotation.x, restRotation.y, restRotation.z, restRotation.w});
    }
    if (scale.times.empty()) {
      setKey(scale, std::array{restScale.x, restScale.y, restScale.z});
    }
    for (RigChannel* channel : {&position, &rotation, &scale}) {
      if (!channel->times.empty()) {
        animation.channels.push_back(std::move(*channel));
      }
    }
  }

  /// One key alone.
  static void setKey(RigChannel& channel, std::span<const float> values) {
    channel.steps = false;
    addKey(channel, 0, values);
  }

  void addMorphChannel(RigAnimation& animation, const aiMeshMorphAnim& source, unsigned number, double perSecond) {
    const std::optional<uint32_t> node = nodeNamed(source.mName);
    if (!node || source.mNumKeys == 0) {
      return;
    }
    RigChannel channel{*node, RigTarget::kWeights, false, 0, {}, {}};
    if (!addOwnKeys(channel, number, source.mName, "weights")) {
      channel.width = source.mKeys[0].mNumValuesAndWeights;
      for (unsigned i = 0; i < source.mNumKeys; ++i) {
        const aiMeshMorphKey& key = source.mKeys[i];
        std::vector<float> weights(channel.width, 0);
        for (unsigned k = 0; k < key.mNumValuesAndWeights; ++k) {
          if (key.mValues[k] < weights.size()) {
            weights[key.mValues[k]] = static_cast<float>(key.mWeights[k]);
          }
        }
        addKey(channel, key.mTime / perSecond, weights);
      }
    }
    if (!channel.times.empty() && channel.width > 0) {
      animation.channels.push_back(std::move(channel));
    }
  }

  RigPart partOf(const aiMesh& source) {
    RigPart part;
    std::vector<std::vector<RigWeight>> ofVertex(source.mNumBones > 0 ? source.mNumVertices : 0);
    for (unsigned b = 0; b < source.mNumBones; ++b) {
      const aiBone& bone = *source.mBones[b];
      const std::optional<uint32_t> node = nodeNamed(bone.mName);
      if (!node) {
        continue;
      }
      const auto number = static_cast<uint32_t>(part.bones.size());
      part.bones.push_back({*node, placeOf(bone.mOffsetMatrix, path_)});
      for (unsigned i = 0; i < bone.mNumWeights; ++i) {
        const aiVertexWeight& share = bone.mWeights[i];
        if (share.mVertexId < source.mNumVertices && std::isfinite(share.mWeight) && share.mWeight > 0) {
          ofVertex[share.mVertexId].push_back({number, share.mWeight});
        }
      }
    }
    if (!part.bones.empty()) {
      part.first.push_back(0);
      for (const std::vector<RigWeight>& weights : ofVertex) {
        addWeights(part, weights);
      }
    }
    for (unsigned i = 0; i < source.mNumAnimMeshes; ++i) {
      part.morphs.push_back(morphOf(source, *source.mAnimMeshes[i]));
    }
    return part;
  }

  static void addWeights(RigPart& part, const std::vector<RigWeight>& weights) {
    double sum = 0;
    for (const RigWeight& share : weights) {
      sum += static_cast<double>(share.weight);
    }
    for (const RigWeight& share : weights) {
      const auto scaled = static_cast<float>(static_cast<double>(share.weight) / sum);
      if (scaled > 0) {
        part.weights.push_back({share.bone, std::min(scaled, 1.0f)});
      }
    }
    part.first.push_back(static_cast<uint32_t>(part.weights.size()));
  }

  /// What is no number moves nothing.
  static RigMorph morphOf(const aiMesh& mesh, const aiAnimMesh& target) {
    RigMorph morph;
    morph.weight = std::isfinite(target.mWeight) ? target.mWeight : 0;
    morph.offsets.resize(mesh.mNumVertices, glm::vec3(0));
    for (unsigned v = 0; v < std::min(mesh.mNumVertices, target.mVertices != nullptr ? target.mNumVertices : 0); ++v) {
      const aiVector3D offset = target.mVertices[v] - mesh.mVertices[v];
      if (std::isfinite(offset.x) && std::isfinite(offset.y) && std::isfinite(offset.z)) {
        morph.offsets[v] = {offset.x, offset.y, offset.z};
      }
    }
    return morph;
  }

  void warn() {
    if (hasLostSplines_) {
      rig_.warnings.push_back(path_.string() +
                              ": some of its cubic splines cannot be read, and are played as straight lines from key "
                              "to key");
    }
    if (!missing_.empty()) {
      rig_.warnings.push_back(path_.string() + ": its animations or skins name " + std::to_string(missing_.size()) +
                              " nodes that are not there, such as \"" + printableText(*missing_.begin()) + "\"");
    }
  }

  const aiScene& scene_;
  const SceneRecord& record_;
  const fs::path& path_;
  Rig rig_;
  std::vector<const aiNode*> nodes_;
  std::map<const aiNode*, uint32_t> numbers_;
  std::map<std::string, uint32_t> byName_;
  std::set<std::string> missing_;
  GltfCurves curves_;
  bool hasLostSplines_ = false;
};

}  // namespace

std::optional<Rig> readFileRig(const aiScene& scene, const SceneRecord& record,
                               const std::vector<const aiNode*>& instanceNodes, const fs::path& path) {
  return RigReader(scene, record, path).read(instanceNodes);
}

}  // namespace ocelli
