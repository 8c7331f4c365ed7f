// Colours and textures of the materials of a scene that Assimp has read. For scene_file.cpp alone.
#pragma once

#include <filesystem>
#include <optional>
#include <vector>

#include "oc_core/scene/texture_image.h"

struct aiScene;

namespace ocelli {

struct FileMaterial {
  glm::vec3 color{1};  ///< linear
  std::optional<size_t> texture;
  unsigned uvChannel = 0;
};

struct FileMaterials {
  std::vector<FileMaterial> materials;
  std::vector<Texture> textures;
  /// In glTF, colours are linear and those of the vertices multiply the material's. Elsewhere they are sRGB and stand
  /// in the place of the material's.
  bool isGltf = false;
};

/// Throws InputError naming the texture where one cannot be read, unless `withTextures` is false: then none is looked
/// at.
FileMaterials readMaterials(const aiScene& scene, const std::filesystem::path& sceneFile, bool withTextures);

}  // namespace ocelli
