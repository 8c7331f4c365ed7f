// Colours and textures of the materials of a scene that Assimp has read. For assimp_scene.cpp alone.
#pragma once

#include <filesystem>
#include <glm/mat3x3.hpp>
#include <optional>
#include <string>
#include <vector>

#include "oc_core/scene/import/image_decode.h"
#include "oc_core/scene/texture_image.h"

struct aiScene;

namespace ocelli {

/// A texture as a material uses it.
struct MaterialTexture {
  size_t texture = 0;  ///< index into FileMaterials::textures
  unsigned uvChannel = 0;
  std::optional<glm::mat3> uvFromFile;  ///< what moves the coordinates first
};

struct FileMaterial {
  glm::vec3 color{1};  ///< linear
  std::optional<MaterialTexture> base;
  glm::vec3 emission{0};  ///< linear, may exceed 1
  std::optional<MaterialTexture> emissive;
  /// What is there of a surface: where this is `maskCutoff` or more. A texture of values (Texture::value()).
  std::optional<MaterialTexture> mask{};
  float maskCutoff = 0.5f;  ///< positive
  bool isNothing = false;   ///< nothing of its surfaces is there
  bool isUnlit = false;     ///< its colours are light already
};

struct FileMaterials {
  std::vector<FileMaterial> materials;
  std::vector<Texture> textures;
  std::vector<std::string> warnings;
  /// In glTF, colours are linear and those of the vertices multiply the material's. Elsewhere they are sRGB and stand
  /// in the place of the material's.
  bool isGltf = false;
};

/// Whether a scene comes from a glTF file.
bool isGltfScene(const aiScene& scene);

/// A texture that is missing, or no image, is a warning that names it, and its material has its plain colour. None is
/// looked at where `withTextures` is false.
FileMaterials readMaterials(const aiScene& scene, const std::filesystem::path& sceneFile, bool withTextures,
                            const MemoryNotice& notice = {});

}  // namespace ocelli
