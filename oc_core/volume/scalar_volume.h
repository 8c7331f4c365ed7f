// A volume of scalars: a grid, and a value at each voxel, kept in the type that its file has.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "oc_core/volume/volume_grid.h"
#include "oc_core/volume/voxel_store.h"

namespace ocelli {

enum class VoxelType { kUint8, kInt8, kUint16, kInt16, kUint32, kInt32, kFloat32, kFloat64 };

size_t bytesOf(VoxelType type);
std::string_view nameOf(VoxelType type);  ///< "uint8"

/// What is known of a volume besides its voxels. Empty: nothing says it.
struct VolumeFacts {
  std::string modality{};   ///< how it was taken, in the words of DICOM: "CT", "MR"
  std::string valueUnit{};  ///< of what voxels mean: "HU" (Hounsfield)
  std::string format{};     ///< of the file that it came from: "NRRD"
};

class ScalarVolume {
 public:
  /// `voxels` hold as many values of `type` as the grid has voxels, i fastest, in the byte order of this machine;
  /// `owner` keeps them in memory, or mapped. What a voxel means is `scale` times what it holds, plus `offset`.
  ScalarVolume(VolumeGrid grid, VoxelType type, std::span<const std::byte> voxels, std::shared_ptr<const void> owner,
               double scale = 1, double offset = 0);
  /// Voxels that need not be in memory (voxel_store.h); the bytes of `store` are those of `voxels` above.
  ScalarVolume(VolumeGrid grid, VoxelType type, std::shared_ptr<const VoxelStore> store, double scale = 1,
               double offset = 0);
  /// The values themselves.
  ScalarVolume(VolumeGrid grid, std::vector<float> values);

  const VolumeGrid& grid() const { return grid_; }
  VoxelType type() const { return type_; }
  std::span<const std::byte> voxels() const { return voxels_; }
  double scale() const { return scale_; }
  double offset() const { return offset_; }
  /// Where voxels come from that need not be in memory; null where they are.
  const VoxelStore* store() const { return store_; }

  const VolumeFacts& facts() const { return facts_; }
  void setFacts(VolumeFacts facts) { facts_ = std::move(facts); }

  /// What a voxel means. Each index lies in the grid.
  double valueAt(const glm::ivec3& voxel) const;
  /// The field at index coordinates (volume_grid.h), which lie in the box of the volume; in double precision: the
  /// reference of what is faster.
  double fieldAt(const glm::dvec3& index) const;

 private:
  VolumeGrid grid_;
  VoxelType type_;
  std::span<const std::byte> voxels_;
  std::shared_ptr<const void> owner_;
  double scale_;
  double offset_;
  const VoxelStore* store_ = nullptr;  ///< owned by owner_
  VolumeFacts facts_;
};

/// Calls `visitor` with a pointer to the first voxel, of the type that it has.
template <class Visitor>
auto visitVoxels(const ScalarVolume& volume, Visitor&& visitor) {
  const std::byte* first = volume.voxels().data();
  switch (volume.type()) {
    case VoxelType::kUint8:
      return std::forward<Visitor>(visitor)(reinterpret_cast<const uint8_t*>(first));
    case VoxelType::kInt8:
      return std::forward<Visitor>(visitor)(reinterpret_cast<const int8_t*>(first));
    case VoxelType::kUint16:
      return std::forward<Visitor>(visitor)(reinterpret_cast<const uint16_t*>(first));
    case VoxelType::kInt16:
      return std::forward<Visitor>(visitor)(reinterpret_cast<const int16_t*>(first));
    case VoxelType::kUint32:
      return std::forward<Visitor>(visitor)(reinterpret_cast<const uint32_t*>(first));
    case VoxelType::kInt32:
      return std::forward<Visitor>(visitor)(reinterpret_cast<const int32_t*>(first));
    case VoxelType::kFloat32:
      return std::forward<Visitor>(visitor)(reinterpret_cast<const float*>(first));
    case VoxelType::kFloat64:
      break;
  }
  return std::forward<Visitor>(visitor)(reinterpret_cast<const double*>(first));
}

/// The least and the greatest value of all voxels that are finite numbers. On all threads.
struct ValueRange {
  double least = 0;
  double greatest = 0;
};
ValueRange valueRange(const ScalarVolume& volume);

}  // namespace ocelli
