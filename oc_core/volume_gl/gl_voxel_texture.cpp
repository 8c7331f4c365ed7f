#include "oc_core/volume_gl/gl_voxel_texture.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <limits>
#include <string>
#include <type_traits>
#include <vector>

#include "oc_core/base/parallel.h"
#include "oc_core/gl/gl_api.h"
#include "oc_core/volume/volume_scan.h"

namespace ocelli {
namespace {

/// How voxels of a type are stored. Texels of whole numbers are without sign, 0 to 1: what a texel of -1 to 1 means
/// at the least number differs between versions of OpenGL.
struct TexelRow {
  VoxelType type;
  GLenum format;  ///< of the texture
  GLenum upload;  ///< the type of what is uploaded
  size_t bytes;   ///< of a texel
  double scale;   ///< what a voxel holds is `scale` times its texel plus `offset`
  double offset;
};

constexpr std::array<TexelRow, 8> kTexels{{
    {VoxelType::kUint8, GL_R8, GL_UNSIGNED_BYTE, 1, 255, 0},
    {VoxelType::kInt8, GL_R8, GL_UNSIGNED_BYTE, 1, 255, -128},
    {VoxelType::kUint16, GL_R16, GL_UNSIGNED_SHORT, 2, 65535, 0},
    {VoxelType::kInt16, GL_R16, GL_UNSIGNED_SHORT, 2, 65535, -32768},
    {VoxelType::kUint32, GL_R32F, GL_FLOAT, 4, 1, 0},
    {VoxelType::kInt32, GL_R32F, GL_FLOAT, 4, 1, 0},
    {VoxelType::kFloat32, GL_R32F, GL_FLOAT, 4, 1, 0},
    {VoxelType::kFloat64, GL_R32F, GL_FLOAT, 4, 1, 0},
}};

const TexelRow& texelOf(VoxelType type) {
  return *std::ranges::find(kTexels, type, &TexelRow::type);
}

/// A voxel as it is uploaded.
template <class Voxel>
auto texelFrom(Voxel voxel) {
  if constexpr (std::is_integral_v<Voxel> && sizeof(Voxel) <= 2) {
    using Unsigned = std::make_unsigned_t<Voxel>;
    constexpr int kLowest = std::numeric_limits<Voxel>::lowest();
    return static_cast<Unsigned>(voxel - kLowest);
  } else {
    return static_cast<float>(voxel);
  }
}

std::string sizeText(const glm::ivec3& size) {
  return std::to_string(size.x) + "x" + std::to_string(size.y) + "x" + std::to_string(size.z) + " voxels";
}

/// Refuses before it is tried what OpenGL says that it cannot hold.
void requireRoom(const GlContext& context, const glm::ivec3& size, const TexelRow& texel) {
  const GladGLContext& gl = context.gl();
  const char* where = nameOf(context.info().provider);
  const std::string next = "use a smaller volume";
  GLint most = 0;
  gl.GetIntegerv(GL_MAX_3D_TEXTURE_SIZE, &most);
  if (std::max({size.x, size.y, size.z}) > most) {
    throw GlError("a volume of " + sizeText(size) + " is larger than this GPU's " + sizeText(glm::ivec3(most)), where,
                  next);
  }
  gl.TexImage3D(GL_PROXY_TEXTURE_3D, 0, static_cast<GLint>(texel.format), size.x, size.y, size.z, 0, GL_RED,
                texel.upload, nullptr);
  GLint width = 0;
  gl.GetTexLevelParameteriv(GL_PROXY_TEXTURE_3D, 0, GL_TEXTURE_WIDTH, &width);
  if (width == 0) {
    const size_t bytes = texel.bytes * size_t(size.x) * size_t(size.y) * size_t(size.z);
    throw GlError("this GPU has no room for a volume of " + sizeText(size) + ", which takes " +
                      std::to_string(bytes >> 20) + " MiB",
                  where, next);
  }
}

/// Slices that go to the GPU together.
constexpr size_t kBytesAtOnce = size_t{32} << 20;

template <class Voxel>
void uploadSlices(const GladGLContext& gl, const GlObject& texture, const ScalarVolume& volume, const TexelRow& texel,
                  const Voxel* first, const Progress& progress) {
  using Texel = decltype(texelFrom(Voxel{}));
  const glm::ivec3& size = volume.grid().size;
  const size_t sliceVoxels = size_t(size.x) * size_t(size.y);
  const int slices = static_cast<int>(std::clamp<size_t>(kBytesAtOnce / (sliceVoxels * sizeof(Texel)), 1, size.z));
  std::vector<Texel> converted;
  for (int k = 0; k < size.z; k += slices) {
    report(progress, "uploading the volume", static_cast<double>(k) / size.z);
    const int count = std::min(slices, size.z - k);
    const RowsInMemory inMemory(volume, {static_cast<size_t>(k), static_cast<size_t>(k + count)});
    const Voxel* from = first + size_t(k) * sliceVoxels;
    const void* data = from;
    if constexpr (!std::is_same_v<Voxel, Texel>) {
      constexpr size_t kGrain = size_t{1} << 16;
      converted.resize(size_t(count) * sliceVoxels);
      parallelFor(converted.size(), kGrain, [&](size_t begin, size_t end) {
        std::transform(from + begin, from + end, converted.begin() + static_cast<std::ptrdiff_t>(begin),
                       texelFrom<Voxel>);
      });
      data = converted.data();
    }
    gl.TextureSubImage3D(texture.id(), 0, 0, 0, k, size.x, size.y, count, GL_RED, texel.upload, data);
  }
}

}  // namespace

GlVoxelTexture::GlVoxelTexture(GlContext& context, const ScalarVolume& volume, const Progress& progress)
    : size_(volume.grid().size) {
  const GladGLContext& gl = context.gl();
  const TexelRow& texel = texelOf(volume.type());
  requireRoom(context, size_, texel);
  uint32_t id = 0;
  gl.CreateTextures(GL_TEXTURE_3D, 1, &id);
  texture_ = GlObject(context, GlObjectKind::kTexture, id);
  for (const GLenum filter : {GL_TEXTURE_MIN_FILTER, GL_TEXTURE_MAG_FILTER}) {
    gl.TextureParameteri(id, filter, GL_LINEAR);
  }
  for (const GLenum wrap : {GL_TEXTURE_WRAP_S, GL_TEXTURE_WRAP_T, GL_TEXTURE_WRAP_R}) {
    gl.TextureParameteri(id, wrap, GL_CLAMP_TO_EDGE);
  }
  gl.TextureStorage3D(id, 1, texel.format, size_.x, size_.y, size_.z);
  context.check("making room for a volume of " + sizeText(size_));
  gl.PixelStorei(GL_UNPACK_ALIGNMENT, 1);
  visitVoxels(volume, [&](const auto* first) { uploadSlices(gl, texture_, volume, texel, first, progress); });
  context.check("uploading a volume of " + sizeText(size_));
  scale_ = volume.scale() * texel.scale;
  offset_ = volume.scale() * texel.offset + volume.offset();
  bytes_ = texel.bytes * volume.grid().voxelCount();
}

}  // namespace ocelli
