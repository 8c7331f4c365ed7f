#include "oc_core/volume/scalar_volume.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/common.hpp>

#include "oc_core/base/check.h"

namespace ocelli {
namespace {

struct VoxelTypeRow {
  std::string_view name;
  size_t bytes;
};

constexpr std::array<VoxelTypeRow, 8> kVoxelTypes{{{"uint8", 1},
                                                   {"int8", 1},
                                                   {"uint16", 2},
                                                   {"int16", 2},
                                                   {"uint32", 4},
                                                   {"int32", 4},
                                                   {"float32", 4},
                                                   {"float64", 8}}};

}  // namespace

size_t bytesOf(VoxelType type) {
  return kVoxelTypes[static_cast<size_t>(type)].bytes;
}
std::string_view nameOf(VoxelType type) {
  return kVoxelTypes[static_cast<size_t>(type)].name;
}

ScalarVolume::ScalarVolume(VolumeGrid grid, VoxelType type, std::span<const std::byte> voxels,
                           std::shared_ptr<const void> owner, double scale, double offset)
    : grid_(std::move(grid)), type_(type), voxels_(voxels), owner_(std::move(owner)), scale_(scale), offset_(offset) {
  OC_CHECK(grid_.voxelCount() > 0, "a volume has voxels");
  OC_CHECK(std::isfinite(scale_) && scale_ != 0 && std::isfinite(offset_),
           "values have a finite scale, which is not 0");
  OC_CHECK(voxels_.size() == grid_.voxelCount() * bytesOf(type_), "a volume has as many voxels as its grid");
}

ScalarVolume::ScalarVolume(VolumeGrid grid, VoxelType type, std::shared_ptr<const VoxelStore> store, double scale,
                           double offset)
    : ScalarVolume(std::move(grid), type, store->bytes(), store, scale, offset) {
  store_ = store.get();
}

ScalarVolume::ScalarVolume(VolumeGrid grid, std::vector<float> values)
    : grid_(std::move(grid)), type_(VoxelType::kFloat32), scale_(1), offset_(0) {
  OC_CHECK(values.size() == grid_.voxelCount(), "a volume has as many values as its grid voxels");
  const auto owned = std::make_shared<const std::vector<float>>(std::move(values));
  voxels_ = std::as_bytes(std::span(*owned));
  owner_ = owned;
}

double ScalarVolume::valueAt(const glm::ivec3& voxel) const {
  const size_t at = (size_t(voxel.z) * grid_.size.y + voxel.y) * grid_.size.x + voxel.x;
  return scale_ * visitVoxels(*this, [&](const auto* first) { return static_cast<double>(first[at]); }) + offset_;
}

double ScalarVolume::fieldAt(const glm::dvec3& index) const {
  const glm::dvec3 last(grid_.size - 1);
  const glm::dvec3 inside = glm::clamp(index, glm::dvec3(0), last);
  const glm::dvec3 lower = glm::min(glm::floor(inside), glm::max(last - 1.0, glm::dvec3(0)));
  const glm::dvec3 share = inside - lower;
  const glm::ivec3 first(lower);
  const glm::ivec3 next = glm::min(first + 1, grid_.size - 1);
  const auto alongI = [&](int j, int k) {
    return glm::mix(valueAt({first.x, j, k}), valueAt({next.x, j, k}), share.x);
  };
  const auto alongJ = [&](int k) { return glm::mix(alongI(first.y, k), alongI(next.y, k), share.y); };
  return glm::mix(alongJ(first.z), alongJ(next.z), share.z);
}

}  // namespace ocelli
