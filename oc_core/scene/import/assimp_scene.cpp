#include "oc_core/scene/import/assimp_scene.h"

#include <assimp/postprocess.h>
#include <assimp/scene.h>

#include <algorithm>
#include <assimp/IOSystem.hpp>
#include <assimp/Importer.hpp>
#include <cmath>
#include <glm/gtc/type_ptr.hpp>
#include <glm/matrix.hpp>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "oc_core/base/error.h"
#include "oc_core/image/color.h"
#include "oc_core/scene/import/file_materials.h"
#include "oc_core/scene/import/file_rig.h"
#include "oc_core/scene/import/limited_files.h"

namespace ocelli {
namespace {

namespace fs = std::filesystem;

constexpr size_t kMaxInstances = 10'000'000;

/// What the standard library says of a size that a file makes up means nothing to a user.
std::string plainReason(const std::string& reason) {
  for (const std::string_view sign :
       {"vector::", "basic_string", "std::bad_", "array_new_length", "deque", "map::at"}) {
    if (reason.find(sign) != std::string::npos) {
      return "a count or size in it is impossible: " + reason;
    }
  }
  return reason.empty() ? "Assimp gives no reason" : reason;
}

[[noreturn]] void failParse(const fs::path& path, const std::string& reason) {
  throw InputError("cannot read this scene file (" + plainReason(reason) + ")", path.string(),
                   "check that it is complete and that its extension fits its format, or convert it to binary PLY");
}

/// Assimp trusts the indices of a file when it triangulates, so they are checked before.
void checkIndices(const aiScene& scene, const fs::path& path) {
  for (unsigned m = 0; m < scene.mNumMeshes; ++m) {
    const aiMesh& mesh = *scene.mMeshes[m];
    for (unsigned f = 0; f < mesh.mNumFaces; ++f) {
      const aiFace& face = mesh.mFaces[f];
      for (unsigned i = 0; i < face.mNumIndices; ++i) {
        if (face.mIndices[i] >= mesh.mNumVertices) {
          throw InputError("face " + std::to_string(f) + " names vertex " + std::to_string(face.mIndices[i]) + " of " +
                               std::to_string(mesh.mNumVertices),
                           path.string(), "repair the mesh, or export it again");
        }
      }
    }
  }
}

glm::vec3 linearVertexColor(const aiColor4D& color, bool isLinear) {
  const auto channel = [&](float value) {
    const float inRange = value > 0 ? std::min(value, 1.0f) : 0.0f;  // NaN becomes 0
    return isLinear ? inRange : linearFromSrgb(inRange);
  };
  return {channel(color.r), channel(color.g), channel(color.b)};
}

/// Vertex colours, else the material's; for glTF their product. None where that is white everywhere.
void setColors(Mesh& mesh, const aiMesh& source, const FileMaterial& material, bool isGltf) {
  const glm::vec3 factor = source.HasVertexColors(0) && !isGltf ? glm::vec3(1) : material.color;
  if (!source.HasVertexColors(0) && factor == glm::vec3(1)) {
    return;
  }
  mesh.colors.assign(mesh.positions.size(), factor);
  for (size_t i = 0; source.HasVertexColors(0) && i < mesh.colors.size(); ++i) {
    mesh.colors[i] *= linearVertexColor(source.mColors[0][i], isGltf);
  }
}

Mesh convertGeometry(const aiMesh& source) {
  Mesh mesh;
  mesh.positions.resize(source.HasPositions() ? source.mNumVertices : 0);
  for (size_t i = 0; i < mesh.positions.size(); ++i) {
    const aiVector3D& p = source.mVertices[i];
    mesh.positions[i] = {p.x, p.y, p.z};
  }
  mesh.triangles.reserve(source.mNumFaces);
  for (unsigned f = 0; f < source.mNumFaces; ++f) {
    const aiFace& face = source.mFaces[f];
    if (face.mNumIndices == 3 && !mesh.positions.empty()) {
      mesh.triangles.push_back({face.mIndices[0], face.mIndices[1], face.mIndices[2]});
    }
  }
  return mesh;
}

/// Faces of one and of two corners.
void takeLinesAndPoints(TexturedMesh& part, const aiMesh& source) {
  for (unsigned f = 0; f < source.mNumFaces && !part.mesh.positions.empty(); ++f) {
    const aiFace& face = source.mFaces[f];
    if (face.mNumIndices == 1) {
      part.points.push_back(face.mIndices[0]);
    } else if (face.mNumIndices == 2) {
      part.lines.emplace_back(face.mIndices[0], face.mIndices[1]);
    }
  }
}

/// Nothing where the mesh has not the coordinates that the material asks for.
std::optional<TextureLayer> layerOf(const aiMesh& source, const std::optional<MaterialTexture>& used) {
  if (!used || used->uvChannel >= AI_MAX_NUMBER_OF_TEXTURECOORDS || !source.HasTextureCoords(used->uvChannel)) {
    return std::nullopt;
  }
  TextureLayer layer{used->texture, std::vector<glm::vec2>(source.mNumVertices)};
  for (size_t i = 0; i < layer.uvs.size(); ++i) {
    const aiVector3D& uv = source.mTextureCoords[used->uvChannel][i];
    layer.uvs[i] = used->uvFromFile ? glm::vec2(*used->uvFromFile * glm::vec3(uv.x, uv.y, 1)) : glm::vec2(uv.x, uv.y);
  }
  return layer;
}

TexturedMesh convertMesh(const aiMesh& source, const FileMaterials& found) {
  const FileMaterial material =
      source.mMaterialIndex < found.materials.size() ? found.materials[source.mMaterialIndex] : FileMaterial{};
  TexturedMesh part;
  part.mesh = convertGeometry(source);
  takeLinesAndPoints(part, source);
  if ((part.mesh.empty() && part.lines.empty() && part.points.empty()) || material.isNothing) {
    return {};
  }
  part.isUnlit = material.isUnlit;
  setColors(part.mesh, source, material, found.isGltf);
  part.base = layerOf(source, material.base);
  part.emissive = layerOf(source, material.emissive);
  part.emission = material.emission;
  part.mask = layerOf(source, material.mask);
  part.maskCutoff = material.maskCutoff;
  return part;
}

glm::mat4 matrixOf(const aiMatrix4x4& m) {
  return glm::transpose(glm::make_mat4(&m.a1));
}

/// `nodes` get the node of each copy.
void addNode(SceneRecord& record, std::vector<const aiNode*>& nodes, const aiNode& node,
             const glm::mat4& worldFromParent, const fs::path& path) {
  const glm::mat4 worldFromNode = worldFromParent * matrixOf(node.mTransformation);
  const float* first = glm::value_ptr(worldFromNode);
  if (!std::all_of(first, first + 16, [](float x) { return std::isfinite(x); })) {
    throw InputError("a node is moved by numbers that are not finite", path.string(), "export the scene again");
  }
  for (unsigned i = 0; i < node.mNumMeshes; ++i) {
    if (node.mMeshes[i] < record.parts.size() && !record.parts[node.mMeshes[i]].mesh.positions.empty()) {
      record.instances.push_back({node.mMeshes[i], worldFromNode});
      nodes.push_back(&node);
    }
  }
  if (record.instances.size() > kMaxInstances) {
    throw InputError("the scene has more than " + std::to_string(kMaxInstances) + " copies of meshes", path.string(),
                     "reduce it");
  }
  for (unsigned i = 0; i < node.mNumChildren; ++i) {
    addNode(record, nodes, *node.mChildren[i], worldFromNode, path);
  }
}

}  // namespace

SceneRecord readWithAssimp(const fs::path& path, bool withTextures, ReadingBudget* budget) {
  Assimp::Importer importer;
  importer.SetIOHandler(makeLimitedFiles(budget).release());  // the importer owns it
  const aiScene* source = importer.ReadFile(path.string(), 0);
  if (source == nullptr || source->mRootNode == nullptr) {
    failParse(path, importer.GetErrorString());
  }
  checkIndices(*source, path);
  // uv_transform.h does it for glTF, as the extension says.
  const unsigned moved = isGltfScene(*source) ? 0U : unsigned{aiProcess_TransformUVCoords};
  source = importer.ApplyPostProcessing(aiProcess_Triangulate | moved);
  if (source == nullptr) {
    failParse(path, importer.GetErrorString());
  }
  checkIndices(*source, path);
  const MemoryNotice notice = [budget](uint64_t bytes) {
    if (budget != nullptr) {
      budget->addMemory(bytes);
    }
  };
  FileMaterials found = readMaterials(*source, path, withTextures, notice);
  SceneRecord record;
  size_t triangles = 0;
  for (unsigned m = 0; m < source->mNumMeshes; ++m) {
    record.parts.push_back(convertMesh(*source->mMeshes[m], found));
    triangles += record.parts.back().mesh.triangles.size();
  }
  if (triangles > kMaxSceneTriangles) {
    throw InputError(
        "the scene has " + std::to_string(triangles) + " triangles, more than " + std::to_string(kMaxSceneTriangles),
        path.string(), "reduce the mesh");
  }
  std::vector<const aiNode*> nodes;
  addNode(record, nodes, *source->mRootNode, glm::mat4(1), path);
  record.rig = readFileRig(*source, record, nodes, path);
  record.textures = std::move(found.textures);
  record.warnings = std::move(found.warnings);
  return record;
}

}  // namespace ocelli
