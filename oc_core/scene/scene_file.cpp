#include "oc_core/scene/scene_file.h"

#include <assimp/postprocess.h>
#include <assimp/scene.h>

#include <assimp/Importer.hpp>
#include <exception>
#include <glm/gtc/type_ptr.hpp>
#include <glm/matrix.hpp>
#include <string>
#include <utility>

#include "oc_core/base/error.h"
#include "oc_core/scene/share_vertices.h"

namespace ocelli {
namespace {

namespace fs = std::filesystem;

constexpr uintmax_t kMostFileBytes = 8ull << 30;

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
    throw InputError("the file is larger than 8 GiB", path.string(), "reduce the mesh, or export it as binary PLY");
  }
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

Mesh convert(const aiMesh& source) {
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
  if (mesh.positions.size() >= mesh.triangles.size() * 3) {
    shareVertices(mesh);
  } else {
    dropUnusedVertices(mesh);
  }
  return mesh;
}

glm::mat4 matrixOf(const aiMatrix4x4& m) {
  return glm::transpose(glm::make_mat4(&m.a1));
}

void addNode(Scene& scene, const aiNode& node, const glm::mat4& worldFromParent) {
  const glm::mat4 worldFromNode = worldFromParent * matrixOf(node.mTransformation);
  for (unsigned i = 0; i < node.mNumMeshes; ++i) {
    if (node.mMeshes[i] < scene.meshes.size() && !scene.meshes[node.mMeshes[i]].empty()) {
      scene.instances.push_back({node.mMeshes[i], worldFromNode});
    }
  }
  for (unsigned i = 0; i < node.mNumChildren; ++i) {
    addNode(scene, *node.mChildren[i], worldFromNode);
  }
}

}  // namespace

Scene readSceneFile(const fs::path& path) {
  checkFile(path);
  Assimp::Importer importer;
  const aiScene* source = importer.ReadFile(path.string(), 0);
  if (source == nullptr || source->mRootNode == nullptr) {
    failParse(path, importer.GetErrorString());
  }
  checkIndices(*source, path);
  source = importer.ApplyPostProcessing(aiProcess_Triangulate);
  if (source == nullptr) {
    failParse(path, importer.GetErrorString());
  }
  Scene scene;
  scene.name = path.string();
  for (unsigned m = 0; m < source->mNumMeshes; ++m) {
    scene.meshes.push_back(convert(*source->mMeshes[m]));
  }
  addNode(scene, *source->mRootNode, glm::mat4(1));
  if (triangleCount(scene) > kMostSceneTriangles) {
    throw InputError("the scene has " + std::to_string(triangleCount(scene)) + " triangles, more than " +
                         std::to_string(kMostSceneTriangles),
                     path.string(), "reduce the mesh");
  }
  return scene;
}

}  // namespace ocelli
