#include "oc_core/base/disjoint_sets.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>
#include <vector>

#include "oc_core/base/random.h"

namespace ocelli {
namespace {

// Against relabelling all numbers at each step.
TEST(DisjointSets, areToldByTheirLeastNumber) {
  constexpr uint32_t kCount = 60;
  Random random(7);
  DisjointSets sets(kCount);
  std::vector<uint32_t> label(kCount);
  std::iota(label.begin(), label.end(), 0u);
  for (int step = 0; step < 50; ++step) {
    const auto a = static_cast<uint32_t>(random.below(kCount));
    const auto b = static_cast<uint32_t>(random.below(kCount));
    sets.join(a, b);
    const uint32_t joined = std::min(label[a], label[b]);
    const uint32_t gone = std::max(label[a], label[b]);
    std::replace(label.begin(), label.end(), gone, joined);
    if (step % 10 == 9) {
      sets.flatten();
    }
    for (uint32_t i = 0; i < kCount; ++i) {
      ASSERT_EQ(sets.least(i), label[i]);
    }
  }
}

}  // namespace
}  // namespace ocelli
