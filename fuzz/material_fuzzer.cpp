// libFuzzer target: materials as any importer of Assimp may leave them, and images as any file may hold them. Assimp
// itself reads nothing here: it runs in a process of its own, since it does not stand this.
#include <assimp/material.h>
#include <assimp/scene.h>
#include <fuzzer/FuzzedDataProvider.h>
#include <unistd.h>

#include <array>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <memory>
#include <string>
#include <vector>

#include "oc_core/base/error.h"
#include "oc_core/image/png_file.h"
#include "oc_core/scene/import/file_materials.h"

namespace {

namespace fs = std::filesystem;

/// A folder with some images, made once.
const fs::path& sceneFile() {
  static const fs::path file = [] {
    const fs::path folder = fs::temp_directory_path() / ("ocelli_material_fuzzer_" + std::to_string(getpid()));
    fs::create_directories(folder / "scene" / "textures");
    ocelli::writePng(folder / "scene" / "a.png", ocelli::Image<ocelli::Rgb8>(2, 2));
    ocelli::writePng(folder / "scene" / "textures" / "B.PNG", ocelli::Image<ocelli::Rgb8>(1, 1));
    std::ofstream(folder / "scene" / "c.png") << "no image";
    return folder / "scene" / "x.gltf";
  }();
  return file;
}

aiString nameFrom(FuzzedDataProvider& data) {
  static constexpr std::array<const char*, 8> kNames{"a.png", "Q:\\t\\A.png", "//b.png", "c.png",
                                                     "*0",    "*1",           "../",     "%61.png"};
  return aiString(data.ConsumeBool() ? kNames[data.ConsumeIntegralInRange<size_t>(0, kNames.size() - 1)]
                                     : data.ConsumeRandomLengthString(40));
}

void fill(aiMaterial& material, FuzzedDataProvider& data) {
  for (const auto type : {aiTextureType_BASE_COLOR, aiTextureType_DIFFUSE, aiTextureType_EMISSIVE}) {
    if (!data.ConsumeBool()) {
      continue;
    }
    const aiString name = nameFrom(data);
    material.AddProperty(&name, AI_MATKEY_TEXTURE(type, 0));
    const int channel = data.ConsumeIntegral<int>();
    material.AddProperty(&channel, 1, AI_MATKEY_UVWSRC(type, 0));
    const int mode = data.ConsumeIntegral<int>();
    material.AddProperty(&mode, 1, AI_MATKEY_MAPPINGMODE_U(type, 0));
    std::array<float, 5> transform{};
    for (float& number : transform) {
      number = data.ConsumeFloatingPoint<float>();
    }
    // Some importers leave fewer numbers than there should be.
    material.AddProperty(transform.data(), data.ConsumeIntegralInRange<unsigned>(1, 5), AI_MATKEY_UVTRANSFORM(type, 0));
  }
  const std::array<float, 4> color{data.ConsumeFloatingPoint<float>(), data.ConsumeFloatingPoint<float>(),
                                   data.ConsumeFloatingPoint<float>(), 1};
  const unsigned count = data.ConsumeIntegralInRange<unsigned>(1, 4);
  material.AddProperty(color.data(), count, AI_MATKEY_COLOR_DIFFUSE);
  material.AddProperty(color.data(), count, AI_MATKEY_COLOR_EMISSIVE);
  material.AddProperty(color.data(), 1, AI_MATKEY_EMISSIVE_INTENSITY);
}

/// An embedded image: a file, or pixels.
void addTexture(aiScene& scene, FuzzedDataProvider& data) {
  auto texture = std::make_unique<aiTexture>();
  const bool isFile = data.ConsumeBool();
  const unsigned side = data.ConsumeIntegralInRange<unsigned>(0, 8);
  const std::vector<uint8_t> bytes = data.ConsumeRemainingBytes<uint8_t>();
  texture->mWidth = isFile ? static_cast<unsigned>(bytes.size()) : side;
  texture->mHeight = isFile ? 0 : side;
  const size_t texels = isFile ? bytes.size() / sizeof(aiTexel) + 1 : size_t{side} * side;
  texture->pcData = new aiTexel[texels]{};
  std::copy_n(bytes.begin(), std::min(bytes.size(), texels * sizeof(aiTexel)),
              reinterpret_cast<uint8_t*>(texture->pcData));
  scene.mTextures = new aiTexture* [1] { texture.release() };
  scene.mNumTextures = 1;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* bytes, size_t size) {
  FuzzedDataProvider data(bytes, size);
  aiScene scene;
  scene.mNumMaterials = data.ConsumeIntegralInRange<unsigned>(1, 3);
  scene.mMaterials = new aiMaterial* [scene.mNumMaterials] {};
  if (data.ConsumeBool()) {
    scene.mMetaData = aiMetadata::Alloc(1);
    scene.mMetaData->Set(0, "SourceAsset_Format", aiString("glTF2 Importer"));
  }
  for (unsigned i = 0; i < scene.mNumMaterials; ++i) {
    scene.mMaterials[i] = new aiMaterial;
    fill(*scene.mMaterials[i], data);
  }
  addTexture(scene, data);
  try {
    const ocelli::FileMaterials found = ocelli::readMaterials(scene, sceneFile(), true);
    for (const ocelli::FileMaterial& material : found.materials) {
      const bool isBad = (material.base && material.base->texture >= found.textures.size()) ||
                         !(material.color.x >= 0 && material.color.x <= 1) || !(material.emission.x >= 0);
      if (isBad) {
        std::abort();
      }
    }
  } catch (const ocelli::InputError&) {
    // Any other exception is a finding.
  }
  return 0;
}
