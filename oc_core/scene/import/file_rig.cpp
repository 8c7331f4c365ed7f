#include "oc_core/scene/import/file_rig.h"

#include <assimp/anim.h>
#include <assimp/scene.h>

#include <algorithm>
#include <cmath>
#include <glm/gtc/type_ptr.hpp>
#include <glm/matrix.hpp>
#include <map>
#include <set>
#include <string>
#include <utility>

#include "oc_core/base/error.h"
#include "oc_core/base/printable_text.h"
#include "oc_core/scene/import/file_materials.h"
#include "oc_core/scene/import/gltf_interpolation.h"

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
      interpolations_ = readGltfInterpolations(path_);
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

  /// Adds a key, where it is one.
  static void addKey(RigChannel& channel, double seconds, std::initializer_list<float> values) {
    const auto time = static_cast<float>(seconds);
    const bool forward = channel.times.empty() || time > channel.times.back();
    if (std::isfinite(time) && time >= 0 && forward &&
        std::ranges::all_of(values, [](float x) { return std::isfinite(x); })) {
      channel.times.push_back(time);
      channel.values.insert(channel.values.end(), values);
    }
  }

  void addNodeChannels(RigAnimation& animation, const aiNodeAnim& source, unsigned number, double perSecond) {
    const std::optional<uint32_t> node = nodeNamed(source.mNodeName);
    if (!node) {
      return;
    }
    RigChannel position{*node, RigTarget::kPosition, isStepped(number, source.mNodeName, "translation"), 3, {}, {}};
    for (unsigned i = 0; i < source.mNumPositionKeys; ++i) {
      const aiVector3D& v = source.mPositionKeys[i].mValue;
      addKey(position, source.mPositionKeys[i].mTime / perSecond, {v.x, v.y, v.z});
    }
    RigChannel rotation{*node, RigTarget::kRotation, isStepped(number, source.mNodeName, "rotation"), 4, {}, {}};
    for (unsigned i = 0; i < source.mNumRotationKeys; ++i) {
      const aiQuaternion& q = source.mRotationKeys[i].mValue;
      addKey(rotation, source.mRotationKeys[i].mTime / perSecond, {q.x, q.y, q.z, q.w});
    }
    RigChannel scale{*node, RigTarget::kScale, isStepped(number, source.mNodeName, "scale"), 3, {}, {}};
    for (unsigned i = 0; i < source.mNumScalingKeys; ++i) {
      const aiVector3D& v = source.mScalingKeys[i].mValue;
      addKey(scale, source.mScalingKeys[i].mTime / perSecond, {v.x, v.y, v.z});
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
      addKey(position, 0, {restPosition.x, restPosition.y, restPosition.z});
    }
    if (rotation.times.empty()) {
      addKey(rotation, 0, {restRotation.x, restRotation.y, restRotation.z, restRotation.w});
    }
    if (scale.times.empty()) {
      addKey(scale, 0, {restScale.x, restScale.y, restScale.z});
    }
    for (RigChannel* channel : {&position, &rotation, &scale}) {
      if (!channel->times.empty()) {
        animation.channels.push_back(std::move(*channel));
      }
    }
  }

  void addMorphChannel(RigAnimation& animation, const aiMeshMorphAnim& source, unsigned number, double perSecond) {
    const std::optional<uint32_t> node = nodeNamed(source.mName);
    if (!node || source.mNumKeys == 0) {
      return;
    }
    RigChannel channel{*node, RigTarget::kWeights, isStepped(number, source.mName, "weights"), 0, {}, {}};
    channel.width = source.mKeys[0].mNumValuesAndWeights;
    for (unsigned i = 0; i < source.mNumKeys; ++i) {
      const aiMeshMorphKey& key = source.mKeys[i];
      const auto time = static_cast<float>(key.mTime / perSecond);
      std::vector<float> weights(channel.width, 0);
      bool valid = std::isfinite(time) && time >= 0 && (channel.times.empty() || time > channel.times.back());
      for (unsigned k = 0; k < key.mNumValuesAndWeights; ++k) {
        const auto weight = static_cast<float>(key.mWeights[k]);
        valid = valid && std::isfinite(weight);
        if (key.mValues[k] < weights.size()) {
          weights[key.mValues[k]] = weight;
        }
      }
      if (valid) {
        channel.times.push_back(time);
        channel.values.insert(channel.values.end(), weights.begin(), weights.end());
      }
    }
    if (!channel.times.empty() && channel.width > 0) {
      animation.channels.push_back(std::move(channel));
    }
  }

  bool isStepped(unsigned animation, const aiString& node, const char* path) {
    const auto found = interpolations_.find({animation, node.C_Str(), path});
    if (found != interpolations_.end() && found->second == "CUBICSPLINE") {
      cubic_ = true;
    }
    return found != interpolations_.end() && found->second == "STEP";
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
    if (cubic_) {
      rig_.warnings.push_back(
          path_.string() + ": its animations have cubic splines, which are played as straight lines from key to key");
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
  GltfInterpolations interpolations_;
  bool cubic_ = false;
};

}  // namespace

std::optional<Rig> readFileRig(const aiScene& scene, const SceneRecord& record,
                               const std::vector<const aiNode*>& instanceNodes, const fs::path& path) {
  return RigReader(scene, record, path).read(instanceNodes);
}

}  // namespace ocelli
