#include "oc_core/scene/import/file_materials.h"

#include <assimp/GltfMaterial.h>
#include <assimp/material.h>
#include <assimp/scene.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <span>
#include <string>
#include <string_view>
#include <tuple>
#include <utility>

#include "oc_core/base/error.h"
#include "oc_core/base/printable_text.h"
#include "oc_core/image/color.h"
#include "oc_core/scene/import/texture_search.h"
#include "oc_core/scene/import/uv_transform.h"

namespace ocelli {
namespace {

namespace fs = std::filesystem;

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

/// The factor of glTF times its strength (KHR_materials_emissive_strength); the emissive colour of other formats.
glm::vec3 emissiveColor(const aiMaterial& material, bool isGltf) {
  aiColor4D color(0, 0, 0, 1);
  material.Get(AI_MATKEY_COLOR_EMISSIVE, color);
  if (!isGltf) {
    return linearFromSrgb(clamped(color));
  }
  float strength = 1;
  material.Get(AI_MATKEY_EMISSIVE_INTENSITY, strength);
  return clamped(color) * (std::isfinite(strength) ? std::max(strength, 0.0f) : 1.0f);
}

/// `mode` is an aiTextureMapMode, or whatever number an importer took from its file.
TextureWrap wrapOf(int mode) {
  if (mode == aiTextureMapMode_Clamp || mode == aiTextureMapMode_Decal) {
    return TextureWrap::kClamp;
  }
  return mode == aiTextureMapMode_Mirror ? TextureWrap::kMirror : TextureWrap::kRepeat;
}

/// Of glTF alone: Assimp itself moves the coordinates of other formats.
std::optional<glm::mat3> gltfTransform(const aiMaterial& material, aiTextureType type) {
  aiUVTransform found;
  if (material.Get(AI_MATKEY_UVTRANSFORM(type, 0), found) != aiReturn_SUCCESS) {
    return std::nullopt;
  }
  return matrixOf(textureTransform(
      {{found.mTranslation.x, found.mTranslation.y}, found.mRotation, {found.mScaling.x, found.mScaling.y}}));
}

class MaterialReader {
 public:
  MaterialReader(const aiScene& scene, const fs::path& sceneFile, const MemoryNotice& notice)
      : scene_(scene), sceneFile_(sceneFile), notice_(notice) {
    found_.isGltf = isGltfScene(scene);
  }

  void add(const aiMaterial& source, bool withTextures) {
    FileMaterial& material = found_.materials.emplace_back();
    material.color = diffuseColor(source, found_.isGltf);
    material.emission = emissiveColor(source, found_.isGltf);
    int shading = 0;
    material.isUnlit = found_.isGltf && source.Get(AI_MATKEY_SHADING_MODEL, shading) == aiReturn_SUCCESS &&
                       shading == aiShadingMode_Unlit;
    addMask(material, source, withTextures);
    if (!withTextures) {
      return;
    }
    const glm::vec3 black(0);
    for (const aiTextureType type : {aiTextureType_BASE_COLOR, aiTextureType_DIFFUSE}) {
      if (names(source, type)) {
        material.base = texture(source, type);
        if (material.color == black) {
          material.color = glm::vec3(1);  // exporters that write a texture often leave the colour at black
        }
        break;
      }
    }
    if (names(source, aiTextureType_EMISSIVE)) {
      material.emissive = texture(source, aiTextureType_EMISSIVE);
      if (material.emissive && material.emission == black && !found_.isGltf) {
        material.emission = glm::vec3(1);
      }
    }
  }

  /// Call it once, when all are added.
  FileMaterials result() {
    if (warned_.size() > kMaxWarnings) {
      found_.warnings.push_back(sceneFile_.string() + ": " + std::to_string(warned_.size() - kMaxWarnings) +
                                " more textures are missing, or are no images");
    }
    return std::move(found_);
  }

 private:
  static constexpr size_t kMaxWarnings = 20;

  /// What an image is taken for.
  enum class Use : uint8_t { kColor, kAlpha, kOpacity };

  using Key = std::tuple<std::string, TextureWrap, TextureWrap, Use>;

  static bool names(const aiMaterial& source, aiTextureType type) { return source.GetTextureCount(type) > 0; }

  /// glTF says how alpha is meant. Elsewhere a map of opacity is a mask, as of leaves and fences.
  void addMask(FileMaterial& material, const aiMaterial& source, bool withTextures) {
    if (!found_.isGltf) {
      if (withTextures && names(source, aiTextureType_OPACITY)) {
        material.mask = texture(source, aiTextureType_OPACITY, Use::kOpacity);
      }
      return;
    }
    aiString mode;
    source.Get(AI_MATKEY_GLTF_ALPHAMODE, mode);
    const bool isMask = std::string_view(mode.C_Str()) == "MASK";
    if (!isMask && std::string_view(mode.C_Str()) != "BLEND") {
      return;
    }
    if (isMask) {
      aiColor4D factor(1, 1, 1, 1);
      source.Get(AI_MATKEY_BASE_COLOR, factor);
      float cutoff = 0.5f;
      source.Get(AI_MATKEY_GLTF_ALPHACUTOFF, cutoff);
      if (!std::isfinite(cutoff) || !std::isfinite(factor.a) || cutoff <= 0) {
        return;  // all is there
      }
      material.isNothing = factor.a < cutoff;  // also where the texture has full alpha
      material.maskCutoff = material.isNothing ? 1.0f : cutoff / factor.a;
    }
    if (withTextures && !material.isNothing && names(source, aiTextureType_BASE_COLOR)) {
      material.mask = texture(source, aiTextureType_BASE_COLOR, Use::kAlpha);
    }
    if (!isMask) {
      warn(sceneFile_.string() +
               ": it has translucent materials, which are opaque here; where the alpha of a texture is less than a "
               "half, nothing is drawn",
           "");
    }
  }

  /// Nothing where there is no such image, which is a warning, or none of that use.
  std::optional<MaterialTexture> texture(const aiMaterial& source, aiTextureType type, Use use = Use::kColor) {
    aiString name;
    MaterialTexture used;
    if (source.GetTexture(type, 0, &name, nullptr, &used.uvChannel) != aiReturn_SUCCESS) {
      return std::nullopt;
    }
    int modeU = aiTextureMapMode_Wrap;
    int modeV = aiTextureMapMode_Wrap;
    source.Get(AI_MATKEY_MAPPINGMODE_U(type, 0), modeU);
    source.Get(AI_MATKEY_MAPPINGMODE_V(type, 0), modeV);
    const Key key{name.C_Str(), wrapOf(modeU), wrapOf(modeV), use};
    const auto [slot, isNew] = known_.insert({key, std::nullopt});
    if (isNew) {
      if (std::optional<Image<Rgb8>> image = load(name.C_Str(), use)) {
        slot->second = found_.textures.size();
        found_.textures.push_back({std::move(*image), std::get<1>(key), std::get<2>(key)});
      }
    }
    if (!slot->second) {
      return std::nullopt;
    }
    used.texture = *slot->second;
    if (found_.isGltf) {
      used.uvFromFile = gltfTransform(source, type);
    }
    return used;
  }

  std::optional<Image<Rgb8>> load(const std::string& name, Use use) {
    try {
      if (const aiTexture* embedded = scene_.GetEmbeddedTexture(name.c_str())) {
        return embeddedImage(*embedded, sceneFile_.string() + ", texture " + printableText(name), use);
      }
      if (const std::optional<fs::path> file = findTextureFile(sceneFile_, name)) {
        const std::string bytes = readImageBytes(*file, notice_);
        return decoded({reinterpret_cast<const unsigned char*>(bytes.data()), bytes.size()}, file->string(), use);
      }
      warn("texture " + printableText(name) + " is missing: its materials have their plain colours",
           "put the image beside the scene, or load it with --no-textures");
    } catch (const InputError& error) {
      warn(std::string(error.what()), "");
    }
    return std::nullopt;
  }

  std::optional<Image<Rgb8>> decoded(std::span<const unsigned char> bytes, const std::string& where, Use use) const {
    if (use == Use::kColor) {
      return decodeImage(bytes, where, notice_);
    }
    return decodeOpacity(bytes, use == Use::kOpacity, where, notice_);
  }

  std::optional<Image<Rgb8>> embeddedImage(const aiTexture& source, const std::string& where, Use use) const {
    if (source.mHeight == 0) {
      const auto* bytes = reinterpret_cast<const unsigned char*>(source.pcData);
      return decoded({bytes, source.mWidth}, where, use);
    }
    const uint64_t pixelCount = uint64_t{source.mWidth} * source.mHeight;
    if (source.mWidth == 0 || pixelCount > kMaxTexturePixels) {
      throw InputError("this texture has no pixels, or more than 2^28", where, "load the scene with --no-textures");
    }
    Image<Rgb8> image(static_cast<int>(source.mWidth), static_cast<int>(source.mHeight));
    for (size_t i = 0; i < image.size(); ++i) {
      const aiTexel& texel = source.pcData[i];
      image[i] = use == Use::kColor ? Rgb8(texel.r, texel.g, texel.b) : Rgb8(texel.a);
    }
    return image;
  }

  /// One warning a texture, though it is loaded once for each way it wraps.
  void warn(const std::string& what, const std::string& next) {
    const std::string text = next.empty() ? what : InputError(what, sceneFile_.string(), next).what();
    if (warned_.insert(text).second && warned_.size() <= kMaxWarnings) {
      found_.warnings.push_back(text);
    }
  }

  const aiScene& scene_;
  const fs::path& sceneFile_;
  const MemoryNotice& notice_;
  FileMaterials found_;
  std::map<Key, std::optional<size_t>> known_;
  std::set<std::string> warned_;
};

}  // namespace

bool isGltfScene(const aiScene& scene) {
  aiString format;
  return scene.mMetaData != nullptr && scene.mMetaData->Get("SourceAsset_Format", format) &&
         std::string(format.C_Str()).find("glTF") != std::string::npos;
}

FileMaterials readMaterials(const aiScene& scene, const fs::path& sceneFile, bool withTextures,
                            const MemoryNotice& notice) {
  MaterialReader reader(scene, sceneFile, notice);
  for (unsigned m = 0; m < scene.mNumMaterials; ++m) {
    reader.add(*scene.mMaterials[m], withTextures);
  }
  return reader.result();
}

}  // namespace ocelli
