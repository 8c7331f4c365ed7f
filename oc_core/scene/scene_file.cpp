#include "oc_core/scene/scene_file.h"

#include <assimp/postprocess.h>
#include <assimp/scene.h>

#include <algorithm>
#include <array>
#include <assimp/Importer.hpp>
#include <cctype>
#include <fstream>
#include <glm/gtc/type_ptr.hpp>
#include <glm/matrix.hpp>
#include <string>
#include <string_view>
#include <utility>

#include "oc_core/base/color.h"
#include "oc_core/base/error.h"
#include "oc_core/scene/file_materials.h"
#include "oc_core/scene/ply_file.h"
#include "oc_core/scene/share_vertices.h"
#include "oc_core/scene/texture_bake.h"

namespace ocelli {
namespace {

namespace fs = std::filesystem;

constexpr uintmax_t kMostFileBytes = 8ull << 30;
constexpr size_t kMostInstances = 10'000'000;

void checkFile(const fs::path& path) {
  std::error_code error;
  const fs::file_status status = fs::status(path, error);
  if (!fs::exists(status)) {
    throw InputError("there is no such file", path.string(),
                     "check the path; built-in scenes are written builtin:NAME (see `ocelli scene list`)");
  }
  if (!fs::is_regular_file(status)) {
    throw InputError("this is not a file", path.string(), "name one scene file, for example a PLY, OBJ or glTF");
  }
  const uintmax_t bytes = fs::file_size(path, error);
  if (error || bytes == 0) {
    throw InputError("the file is empty", path.string(), "copy or export it again");
  }
  if (bytes > kMostFileBytes) {
    throw InputError("the file is larger than 8 GiB", path.string(), "reduce the mesh");
  }
  if (!std::ifstream(path, std::ios::binary)) {
    throw InputError("this file cannot be opened", path.string(), "check its permissions");
  }
}

/// By its name or its first bytes: what claims to be PLY never reaches Assimp.
bool isPly(const fs::path& path) {
  std::string extension = path.extension().string();
  std::transform(extension.begin(), extension.end(), extension.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  std::array<char, 4> start{};
  std::ifstream(path, std::ios::binary).read(start.data(), start.size());
  return extension == ".ply" || (std::string_view(start.data(), 3) == "ply" && (start[3] == '\n' || start[3] == '\r'));
}

[[noreturn]] void failParse(const fs::path& path, const std::string& reason) {
  throw InputError("cannot read this scene file (" + reason + ")", path.string(),
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
  mesh.positions.resize(source.mNumVertices);
  for (unsigned i = 0; i < source.mNumVertices; ++i) {
    const aiVector3D& p = source.mVertices[i];
    mesh.positions[i] = {p.x, p.y, p.z};
  }
  mesh.triangles.reserve(source.mNumFaces);
  for (unsigned f = 0; f < source.mNumFaces; ++f) {
    const aiFace& face = source.mFaces[f];
    if (face.mNumIndices == 3) {
      mesh.triangles.push_back({face.mIndices[0], face.mIndices[1], face.mIndices[2]});
    }
  }
  return mesh;
}

std::vector<glm::vec2> textureCoordinates(const aiMesh& source, unsigned channel) {
  std::vector<glm::vec2> uvs(source.mNumVertices);
  for (unsigned i = 0; i < source.mNumVertices; ++i) {
    uvs[i] = {source.mTextureCoords[channel][i].x, source.mTextureCoords[channel][i].y};
  }
  return uvs;
}

std::vector<Mesh> convertMeshes(const aiScene& source, FileMaterials&& found, const SceneFileOptions& options) {
  std::vector<Mesh> meshes(source.mNumMeshes);
  std::vector<TexturedMesh> textured;
  std::vector<size_t> meshOfTextured;
  for (unsigned m = 0; m < source.mNumMeshes; ++m) {
    const aiMesh& from = *source.mMeshes[m];
    const FileMaterial material =
        from.mMaterialIndex < found.materials.size() ? found.materials[from.mMaterialIndex] : FileMaterial{};
    meshes[m] = convertGeometry(from);
    setColors(meshes[m], from, material, found.isGltf);
    const bool hasUvs =
        material.uvChannel < AI_MAX_NUMBER_OF_TEXTURECOORDS && from.HasTextureCoords(material.uvChannel);
    if (material.texture && hasUvs && !meshes[m].empty()) {
      textured.push_back({std::move(meshes[m]), textureCoordinates(from, material.uvChannel), *material.texture});
      meshOfTextured.push_back(m);
    }
  }
  bakeTextures(textured, std::move(found.textures), options.textureTriangles);
  for (size_t i = 0; i < textured.size(); ++i) {
    meshes[meshOfTextured[i]] = std::move(textured[i].mesh);
  }
  for (Mesh& mesh : meshes) {
    // A mesh that shares its vertices has half as many of them as triangles; one that repeats them, twice to three
    // times.
    if (mesh.positions.size() > mesh.triangles.size()) {
      shareVertices(mesh);
    } else {
      dropUnusedVertices(mesh);
    }
  }
  return meshes;
}

glm::mat4 matrixOf(const aiMatrix4x4& m) {
  return glm::transpose(glm::make_mat4(&m.a1));
}

void addNode(Scene& scene, const aiNode& node, const glm::mat4& worldFromParent, const fs::path& path) {
  const glm::mat4 worldFromNode = worldFromParent * matrixOf(node.mTransformation);
  for (unsigned i = 0; i < node.mNumMeshes; ++i) {
    if (node.mMeshes[i] < scene.meshes.size() && !scene.meshes[node.mMeshes[i]].empty()) {
      scene.instances.push_back({node.mMeshes[i], worldFromNode});
    }
  }
  if (scene.instances.size() > kMostInstances) {
    throw InputError("the scene has more than " + std::to_string(kMostInstances) + " copies of meshes", path.string(),
                     "reduce it");
  }
  for (unsigned i = 0; i < node.mNumChildren; ++i) {
    addNode(scene, *node.mChildren[i], worldFromNode, path);
  }
}

Scene readWithAssimp(const fs::path& path, const SceneFileOptions& options) {
  Assimp::Importer importer;
  const aiScene* source = importer.ReadFile(path.string(), 0);
  if (source == nullptr || source->mRootNode == nullptr) {
    failParse(path, importer.GetErrorString());
  }
  checkIndices(*source, path);
  source = importer.ApplyPostProcessing(aiProcess_Triangulate | aiProcess_TransformUVCoords);
  if (source == nullptr) {
    failParse(path, importer.GetErrorString());
  }
  Scene scene;
  scene.meshes = convertMeshes(*source, readMaterials(*source, path, options.textures), options);
  addNode(scene, *source->mRootNode, glm::mat4(1), path);
  return scene;
}

}  // namespace

Scene readSceneFile(const fs::path& path, const SceneFileOptions& options) {
  checkFile(path);
  Scene scene;
  if (isPly(path)) {
    scene.add(readPly(path));
    dropUnusedVertices(scene.meshes.back());
  } else {
    scene = readWithAssimp(path, options);
  }
  scene.name = path.string();
  if (triangleCount(scene) > kMostSceneTriangles) {
    throw InputError("the scene has " + std::to_string(triangleCount(scene)) + " triangles, more than " +
                         std::to_string(kMostSceneTriangles),
                     path.string(), "reduce the mesh");
  }
  return scene;
}

}  // namespace ocelli
