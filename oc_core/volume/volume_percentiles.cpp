#include "oc_core/volume/volume_percentiles.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <functional>
#include <mutex>
#include <numeric>
#include <type_traits>

#include "oc_core/base/check.h"
#include "oc_core/volume/volume_scan.h"

namespace ocelli {
namespace {

/// Digits of keys that one reading tells apart: counts of them fit into the first cache.
constexpr unsigned kDigitBits = 11;
constexpr size_t kDigitValues = size_t{1} << kDigitBits;

/// Unsigned numbers in the order of the voxels.
template <class Voxel>
struct OrderedKey {
  static constexpr unsigned kBits = 8 * sizeof(Voxel);
  static constexpr uint64_t kSign = uint64_t{1} << (kBits - 1);
  static constexpr uint64_t kAll = kSign | (kSign - 1);
  using Bits = std::conditional_t<
      sizeof(Voxel) == 1, uint8_t,
      std::conditional_t<sizeof(Voxel) == 2, uint16_t, std::conditional_t<sizeof(Voxel) == 4, uint32_t, uint64_t>>>;

  static uint64_t of(Voxel voxel) {
    const uint64_t bits = std::bit_cast<Bits>(voxel);
    if constexpr (std::is_floating_point_v<Voxel>) {
      return (bits & kSign) != 0 ? ~bits & kAll : bits | kSign;
    } else {
      return std::is_signed_v<Voxel> ? bits ^ kSign : bits;
    }
  }

  static Voxel voxelOf(uint64_t key) {
    if constexpr (std::is_floating_point_v<Voxel>) {
      return std::bit_cast<Voxel>(static_cast<Bits>((key & kSign) != 0 ? key & ~kSign : ~key & kAll));
    } else {
      return std::bit_cast<Voxel>(static_cast<Bits>(std::is_signed_v<Voxel> ? key ^ kSign : key));
    }
  }
};

/// The digit of the keys that begin with one of some prefixes: how often each value of it stands in a volume.
template <class Voxel>
class DigitCounts {
 public:
  /// The digit is the bits from `shift` on; prefixes, distinct, are what stands above `above`, or one of 0 for all.
  DigitCounts(const std::vector<uint64_t>& prefixes, unsigned shift, unsigned above)
      : prefixes_(prefixes),
        shift_(shift),
        above_(above),
        mask_((uint64_t{1} << (above - shift)) - 1),
        counts_(prefixes.size() * kDigitValues) {}

  void add(Voxel voxel, uint64_t times = 1) {
    const uint64_t key = OrderedKey<Voxel>::of(voxel);
    // A shift by all 64 bits is undefined.
    const uint64_t prefix = above_ < OrderedKey<Voxel>::kBits ? key >> above_ : 0;
    for (size_t at = 0; at < prefixes_.size(); ++at) {
      if (prefixes_[at] == prefix) {
        counts_[at * kDigitValues + ((key >> shift_) & mask_)] += times;
      }
    }
  }

  void add(const DigitCounts& other) { std::ranges::transform(counts_, other.counts_, counts_.begin(), std::plus<>()); }

  uint64_t total() const { return std::accumulate(counts_.begin(), counts_.end(), uint64_t{0}); }

  /// The key up to this digit of the voxel of this rank, from 1, among those that begin with the prefix; the rank
  /// becomes that among those that begin with the key.
  uint64_t keyOfRank(uint64_t prefix, uint64_t& rank) const {
    const auto at = static_cast<size_t>(std::ranges::find(prefixes_, prefix) - prefixes_.begin());
    for (uint64_t digit = 0; digit <= mask_; ++digit) {
      const uint64_t count = counts_[at * kDigitValues + digit];
      if (rank <= count) {
        return prefix << (above_ - shift_) | digit;
      }
      rank -= count;
    }
    OC_CHECK(false, "a rank is one of the voxels");
    return 0;
  }

 private:
  const std::vector<uint64_t>& prefixes_;
  unsigned shift_;
  unsigned above_;
  uint64_t mask_;
  std::vector<uint64_t> counts_;
};

template <class Voxel>
DigitCounts<Voxel> countDigits(const ScalarVolume& volume, const Voxel* first, const DigitCounts<Voxel>& none) {
  DigitCounts<Voxel> all = none;
  std::mutex mutex;
  const auto width = static_cast<size_t>(volume.grid().size.x);
  scanSlices(volume, 0, static_cast<size_t>(volume.grid().size.z), [&](size_t begin, size_t end) {
    DigitCounts<Voxel> part = none;
    for (size_t slice = begin; slice < end; ++slice) {
      visitRows(
          volume, first, slice,
          [&](size_t /*j*/, const Voxel* row) {
            for (size_t i = 0; i < width; ++i) {
              if constexpr (std::is_floating_point_v<Voxel>) {
                if (!std::isfinite(row[i])) {
                  continue;
                }
              }
              part.add(row[i]);
            }
          },
          [&](size_t rows) { part.add(0, rows * width); });
    }
    const std::scoped_lock lock(mutex);
    all.add(part);
  });
  return all;
}

}  // namespace

std::vector<double> percentilesOf(const ScalarVolume& volume, std::span<const double> percents) {
  return visitVoxels(volume, [&](const auto* first) {
    using Voxel = std::remove_cv_t<std::remove_pointer_t<decltype(first)>>;
    std::vector<uint64_t> keys(percents.size(), 0);
    std::vector<uint64_t> ranks(percents.size(), 0);
    for (unsigned above = OrderedKey<Voxel>::kBits; above > 0;) {
      const bool isFirst = above == OrderedKey<Voxel>::kBits;
      const unsigned shift = above > kDigitBits ? above - kDigitBits : 0;
      std::vector<uint64_t> prefixes = keys;
      std::ranges::sort(prefixes);
      const auto repeated = std::ranges::unique(prefixes);
      prefixes.erase(repeated.begin(), repeated.end());
      const DigitCounts<Voxel> counts = countDigits(volume, first, DigitCounts<Voxel>(prefixes, shift, above));
      if (isFirst) {
        const uint64_t total = counts.total();
        if (total == 0) {
          return std::vector<double>(percents.size(), 0.0);
        }
        for (size_t at = 0; at < percents.size(); ++at) {
          OC_CHECK(percents[at] >= 0 && percents[at] <= 100, "percents are from 0 to 100");
          const auto rank = static_cast<uint64_t>(std::ceil(percents[at] * static_cast<double>(total) / 100));
          ranks[at] = std::clamp<uint64_t>(rank, 1, total);
          if (volume.scale() < 0) {
            // The least value is that of the greatest voxel.
            ranks[at] = total + 1 - ranks[at];
          }
        }
      }
      for (size_t at = 0; at < percents.size(); ++at) {
        keys[at] = counts.keyOfRank(keys[at], ranks[at]);
      }
      above = shift;
    }
    std::vector<double> values;
    for (const uint64_t key : keys) {
      values.push_back(volume.scale() * static_cast<double>(OrderedKey<Voxel>::voxelOf(key)) + volume.offset());
    }
    return values;
  });
}

}  // namespace ocelli
