#include "oc_core/scene/file_materials.h"

#include <assimp/material.h>
#include <assimp/scene.h>

#include <algorithm>
#include <map>
#include <string>
#include <utility>

#include "oc_core/base/color.h"
#include "oc_core/base/error.h"

namespace ocelli {
namespace {

namespace fs = std::filesystem;

bool isGltfScene(const aiScene& scene) {
  aiString format;
  return scene.mMetaData != nullptr && scene.mMetaData->Get("SourceAsset_Format", format) &&
         std::string(format.C_Str()).find("glTF") != std::string::npos;
}

glm::vec3 clamped(const aiColor4D& color) {
  const auto channel = [](float value) { return value > 0 ? std::min(value, 1.0f) : 0.0f; };  // NaN becomes 0
  return {channel(color.r), channel(color.g), channel(color.b)};
}

/// White where the file itself says nothing: the importers' default material is grey.
glm::vec3 diffuseColor(const aiMaterial& material, bool isGltf) {
  aiString name;
  if (material.Get(AI_MATKEY_NAME, name) == aiReturn_SUCCESS && std::string(name.C_Str()) == AI_DEFAULT_MATERIAL_NAME) {
    return glm::vec3(1);
  }
  aiColor4D color(1, 1, 1, 1);
  if (material.Get(AI_MATKEY_BASE_COLOR, color) != aiReturn_SUCCESS) {
    material.Get(AI_MATKEY_COLOR_DIFFUSE, color);
  }
  return isGltf ? clamped(color) : linearFromSrgb(clamped(color));
}

TextureWrap wrapOf(aiTextureMapMode mode) {
  if (mode == aiTextureMapMode_Clamp || mode == aiTextureMapMode_Decal) {
    return TextureWrap::kClamp;
  }
  return mode == aiTextureMapMode_Mirror ? TextureWrap::kMirror : TextureWrap::kRepeat;
}

Image<Rgb8> embeddedImage(const aiTexture& source, const std::string& where) {
  if (source.mHeight == 0) {
    const auto* bytes = reinterpret_cast<const unsigned char*>(source.pcData);
    return decodeImage({bytes, bytes + source.mWidth}, where);
  }
  Image<Rgb8> image(static_cast<int>(source.mWidth), static_cast<int>(source.mHeight));
  for (size_t i = 0; i < image.size(); ++i) {
    image[i] = {source.pcData[i].r, source.pcData[i].g, source.pcData[i].b};
  }
  return image;
}

Image<Rgb8> loadImage(const aiScene& scene, const fs::path& sceneFile, std::string name) {
  if (const aiTexture* embedded = scene.GetEmbeddedTexture(name.c_str())) {
    return embeddedImage(*embedded, sceneFile.string() + ", texture " + name);
  }
  std::replace(name.begin(), name.end(), '\\', '/');
  return readImage(sceneFile.parent_path() / name);
}

}  // namespace

FileMaterials readMaterials(const aiScene& scene, const fs::path& sceneFile, bool withTextures) {
  FileMaterials found;
  found.isGltf = isGltfScene(scene);
  std::map<std::pair<std::string, std::pair<int, int>>, size_t> known;
  for (unsigned m = 0; m < scene.mNumMaterials; ++m) {
    const aiMaterial& source = *scene.mMaterials[m];
    FileMaterial& material = found.materials.emplace_back();
    material.color = diffuseColor(source, found.isGltf);
    aiString name;
    aiTextureMapMode modes[3] = {aiTextureMapMode_Wrap, aiTextureMapMode_Wrap, aiTextureMapMode_Wrap};
    const auto findTexture = [&](aiTextureType type) {
      return source.GetTexture(type, 0, &name, nullptr, &material.uvChannel, nullptr, nullptr, modes) ==
             aiReturn_SUCCESS;
    };
    if (!withTextures || !(findTexture(aiTextureType_BASE_COLOR) || findTexture(aiTextureType_DIFFUSE))) {
      continue;
    }
    const auto [slot, isNew] =
        known.insert({{name.C_Str(), {static_cast<int>(modes[0]), static_cast<int>(modes[1])}}, found.textures.size()});
    if (isNew) {
      found.textures.push_back({loadImage(scene, sceneFile, name.C_Str()), wrapOf(modes[0]), wrapOf(modes[1])});
    }
    material.texture = slot->second;
    if (material.color == glm::vec3(0)) {
      material.color = glm::vec3(1);  // exporters that write a texture often leave the colour at black
    }
  }
  return found;
}

}  // namespace ocelli
