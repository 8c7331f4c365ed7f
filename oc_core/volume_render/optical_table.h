// A transfer function integrated over values, so that a step along a ray need not look at it more than once: the
// preintegration of K. Engel, M. Kraus and T. Ertl, "High-quality pre-integrated volume rendering", 2001, in one
// dimension.
//
// Over a step of length ds at whose ends the field is a and b, and linear between, extinction and the product of
// extinction and colour are on average
//
//   (K(b) - K(a)) / (b - a),    K(v) the integral of either up to v,
//
// which does not depend on ds: the step's optical depth tau is ds times the first, exactly, and its light is
// (1 - exp(-tau)) times the quotient of both, were it not for the order of its colours (march_steps-inl.h).
//
// Both are linear between entries, which stand at equal distances of values, and constant beyond the first and last.
// Each entry is the exact mean over the values that are nearer to it than to others, so a peak that is thinner than the
// distance of two entries keeps its integral, and is spread over two of them. K is kept as the sum of two numbers: the
// difference of two large ones would lose the faint.
#pragma once

#include <array>
#include <vector>

#include "oc_core/volume/scalar_volume.h"
#include "oc_core/volume/transfer_function.h"

namespace ocelli {

class OpticalTable {
 public:
  static constexpr int kEntries = 2048;

  /// Extinction, and red, green and blue times extinction: by the unit of length of the grid's world.
  using Four = std::array<float, 4>;
  struct alignas(64) Entry {
    Four integral{};  ///< of `at`, over entries, up to this one: the greater part
    Four rest{};      ///< and what is to be added
    Four at{};
    Four halfChange{};  ///< half of what `at` of the next entry is more
  };

  /// `range` is that of the values that will be looked up.
  OpticalTable(const TransferFunction& transfer, const ValueRange& range);

  const std::vector<Entry>& entries() const { return entries_; }
  double firstValue() const { return firstValue_; }  ///< of entry 0
  double entriesByValue() const { return entriesByValue_; }
  /// Whether nothing is seen of values from `least` to `greatest`.
  bool isEmpty(double least, double greatest) const;

 private:
  double firstValue_;
  double entriesByValue_;
  std::vector<Entry> entries_;
  std::vector<int> visibleBefore_;  ///< how many entries before this one have extinction
};

}  // namespace ocelli
