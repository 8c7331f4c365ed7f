#include "oc_core/compositing/composite.h"

#include <gtest/gtest.h>

#include <mutex>

#include "oc_core/base/error.h"
#include "oc_core/base/random.h"
#include "oc_core/compositing/shared_renderer.h"
#include "tests/ranks/thread_ranks.h"

namespace ocelli::test {
namespace {

constexpr int kColumns = 37;
constexpr int kRows = 23;

/// What a rank holds: pixels of depths that several ranks share, so that triangles decide.
FragmentImage imageOfRank(int rank, double coverage) {
  Random random(static_cast<uint64_t>(rank) + 17);
  FragmentImage image(kColumns, kRows);
  for (size_t i = 0; i < image.size(); ++i) {
    if (random.inRange(0, 1) < coverage) {
      const auto depth = static_cast<float>(1 + random.below(3));
      image[i] = {depth, static_cast<uint32_t>(rank * 1000) + static_cast<uint32_t>(i % 7), 0.25f,
                  static_cast<float>(rank)};
    }
  }
  return image;
}

/// One after the other, the last rank first.
FragmentImage mergedInOneProcess(int size, double coverage) {
  FragmentImage merged(kColumns, kRows);
  for (int rank = size - 1; rank >= 0; --rank) {
    const FragmentImage image = imageOfRank(rank, coverage);
    for (size_t i = 0; i < image.size(); ++i) {
      const Fragment& a = image[i];
      const Fragment& b = merged[i];
      if (a.covered() && (!b.covered() || std::pair(a.t, a.triangle) < std::pair(b.t, b.triangle))) {
        merged[i] = a;
      }
    }
  }
  return merged;
}

class CompositeOfRanks : public testing::TestWithParam<std::tuple<int, double>> {};

TEST_P(CompositeOfRanks, IsThePlainMergeInEveryRank) {
  const auto [size, coverage] = GetParam();
  const FragmentImage expected = mergedInOneProcess(size, coverage);
  for (const Compositing how : {Compositing::kDirectSend, Compositing::kBinarySwap}) {
    runInRanks(size, [&](Ranks& ranks) {
      FragmentImage image = imageOfRank(ranks.rank(), coverage);
      compositeNearest(image, ranks, how);
      EXPECT_EQ(image, expected);
    });
  }
}

INSTANTIATE_TEST_SUITE_P(Sizes, CompositeOfRanks,
                         testing::Combine(testing::Values(1, 2, 3, 4, 5, 6, 7, 8, 9, 13, 16),
                                          testing::Values(0.0, 0.02, 0.6, 1.0)));

TEST(Composite, SendsNothingOfEmptyImages) {
  for (const Compositing how : {Compositing::kDirectSend, Compositing::kBinarySwap}) {
    runInRanks(4, [&](Ranks& ranks) {
      FragmentImage image(kColumns, kRows);
      compositeNearest(image, ranks, how);
      EXPECT_EQ(ranks.bytesSent(), 0u);
    });
  }
}

TEST(Composite, KeepsFewerPixelsThanRanks) {
  for (const Compositing how : {Compositing::kDirectSend, Compositing::kBinarySwap}) {
    runInRanks(8, [&](Ranks& ranks) {
      FragmentImage image(3, 1);
      image[1] = {2, static_cast<uint32_t>(10 - ranks.rank()), 0, 0};
      compositeNearest(image, ranks, how);
      EXPECT_EQ(image[1].triangle, 3u);
      EXPECT_FALSE(image[0].covered());
    });
  }
}

TEST(Compositing, HasTwoNames) {
  EXPECT_EQ(compositingFromText("direct", "--compositing"), Compositing::kDirectSend);
  EXPECT_EQ(compositingFromText("swap", "--compositing"), Compositing::kBinarySwap);
  EXPECT_THROW(compositingFromText("tree", "--compositing"), InputError);
}

TEST(Agreement, IsMissedWhereOneRankDiffers) {
  runInRanks(3, [](Ranks& ranks) { EXPECT_NO_THROW(requireAgreement(ranks, 5)); });
  for (const int different : {0, 1, 2}) {
    std::mutex mutex;
    int failed = 0;
    runInRanks(3, [&](Ranks& ranks) {
      try {
        requireAgreement(ranks, ranks.rank() == different ? 4 : 5);
      } catch (const WorkError&) {
        const std::scoped_lock lock(mutex);
        ++failed;
      }
    });
    EXPECT_GT(failed, 0);
  }
}

}  // namespace
}  // namespace ocelli::test
