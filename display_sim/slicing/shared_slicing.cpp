#include "display_sim/slicing/shared_slicing.h"

#include <algorithm>
#include <array>

#include "display_sim/dither/diffusion.h"
#include "display_sim/slicing/exact_slicer.h"
#include "display_sim/slicing/slicer.h"
#include "oc_core/ranks/packed_bytes.h"

namespace ocelli {
namespace {

/// Bytes of a slice that are sent where one of them is lit: most of a volume is dark.
constexpr size_t kBlock = 64;

bool isDark(std::span<const uint8_t> bytes) {
  return std::ranges::all_of(bytes, [](uint8_t byte) { return byte == 0; });
}

Bytes packedSlices(const Volume& volume, const std::vector<int>& slices) {
  BytePacker packer;
  for (const int slice : slices) {
    const std::span<const uint8_t> all = volume.slice(slice);
    std::vector<uint32_t> lit;
    std::vector<uint8_t> bytes;
    for (size_t first = 0; first < all.size(); first += kBlock) {
      const std::span<const uint8_t> block = all.subspan(first, std::min(kBlock, all.size() - first));
      if (!isDark(block)) {
        lit.push_back(static_cast<uint32_t>(first));
        bytes.insert(bytes.end(), block.begin(), block.end());
      }
    }
    packer.add(lit);
    packer.add(bytes);
  }
  return packer.take();
}

void unpackSlices(std::span<const std::byte> message, const std::vector<int>& slices, Volume& volume) {
  ByteUnpacker unpacker(message);
  for (const int slice : slices) {
    const std::span<uint8_t> all = volume.slice(slice);
    const auto lit = unpacker.values<uint32_t>();
    const auto bytes = unpacker.values<uint8_t>();
    size_t next = 0;
    for (const uint32_t first : lit) {
      const size_t size = std::min<size_t>(kBlock, all.size() - first);
      std::copy_n(bytes.begin() + static_cast<std::ptrdiff_t>(next), size,
                  all.begin() + static_cast<std::ptrdiff_t>(first));
      next += size;
    }
  }
}

void gatherSlices(Volume& volume, Ranks& ranks) {
  const auto slicesOf = [&](int rank) { return slicesOfRank(volume.profile(), rank, ranks.size()); };
  const Bytes mine = ranks.isFirst() ? Bytes{} : packedSlices(volume, slicesOf(ranks.rank()));
  const std::vector<Bytes> all = ranks.gather(mine);
  for (size_t rank = 1; rank < all.size(); ++rank) {
    unpackSlices(all[rank], slicesOf(static_cast<int>(rank)), volume);
  }
}

Volume diffuseTogether(const Mesh& mesh, const DisplayProfile& profile, const SliceOptions& options, Ranks& ranks) {
  VoxelColors colors = colorsOfSlices(mesh, profile, options, slicesOfRank(profile, ranks.rank(), ranks.size()));
  BytePacker packer;
  for (const int slice : slicesOfRank(profile, ranks.rank(), ranks.size())) {
    packer.add(colors[static_cast<size_t>(slice)]);
  }
  const std::vector<Bytes> all = ranks.gather(packer.take());
  if (!ranks.isFirst()) {
    return Volume(profile);
  }
  for (size_t rank = 0; rank < all.size(); ++rank) {
    ByteUnpacker unpacker(all[rank]);
    for (const int slice : slicesOfRank(profile, static_cast<int>(rank), ranks.size())) {
      colors[static_cast<size_t>(slice)] = unpacker.values<ColoredVoxel>();
    }
  }
  return diffuse(std::move(colors), profile).volume;
}

Volume sliceShare(const Mesh& mesh, const DisplayProfile& profile, const SliceOptions& options, bool exact,
                  const std::vector<int>& slices) {
  if (exact || needsExactSlicer(options)) {
    return makeSlicesExactly(mesh, profile, options, slices);
  }
  Slicer slicer(profile, options);
  slicer.slice(SliceMesh(mesh), slices);
  return slicer.takeVolume();
}

}  // namespace

std::vector<int> slicesOfRank(const DisplayProfile& profile, int rank, int size) {
  const RankShare share = shareOfRank(static_cast<size_t>(profile.slicesPerHalfTurn), rank, size);
  std::vector<int> slices;
  for (int first = 0; first < profile.storedSlices(); first += profile.slicesPerHalfTurn) {
    for (size_t i = share.begin; i < share.end; ++i) {
      slices.push_back(first + static_cast<int>(i));
    }
  }
  return slices;
}

Volume sliceTogether(const Mesh& mesh, const DisplayProfile& profile, const SliceOptions& options, bool exact,
                     Ranks& ranks) {
  if (options.colors == ColorReduction::kDiffusion) {
    return diffuseTogether(mesh, profile, options, ranks);
  }
  Volume volume = sliceShare(mesh, profile, options, exact, slicesOfRank(profile, ranks.rank(), ranks.size()));
  gatherSlices(volume, ranks);
  return volume;
}

}  // namespace ocelli
