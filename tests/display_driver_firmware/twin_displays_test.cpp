// The firmware against the slow display of the page, under random hosts.
#include "tests/display_driver_firmware/twin_displays.h"

#include <gtest/gtest.h>

#include "oc_core/base/random.h"

namespace ocelli::test {
namespace {

struct Case {
  int buffers;
  uint32_t capabilities;
  size_t wildness;
};

class TwinDisplaysTest : public testing::TestWithParam<Case> {};

TEST_P(TwinDisplaysTest, theFirmwareDoesWhatThePageSays) {
  const Case& parameters = GetParam();
  size_t arrived = 0;
  for (uint64_t seed = 0; seed < 15; ++seed) {
    const FirmwareOptions options{.profile = tinyProfile(seed % 2 == 0 ? 5 : 9, 1 + static_cast<int>(seed % 3)),
                                  .frameBuffers = parameters.buffers,
                                  .capabilities = parameters.capabilities};
    TwinDisplays displays(options);
    Random random(seed);
    WildHost host(
        displays, slowOptions(options, 200), [&](size_t below) { return random.below(below); }, parameters.wildness);
    for (int i = 0; i < 400; ++i) {
      SCOPED_TRACE(testing::Message() << "seed " << seed << ", operation " << i);
      ASSERT_NO_THROW(host.doSomething());
    }
    // No deadlock: what waits is taken in the end. (Damage may turn a PRESENT into one of a far future.)
    for (int i = 0; i < 100 && !displays.idle(); ++i) {
      ASSERT_NO_THROW(displays.step());
    }
    EXPECT_TRUE(displays.idle() || parameters.wildness > 0) << "seed " << seed;
    arrived += displays.slow().arrived;
    EXPECT_GT(displays.refreshes, 0u);
  }
  EXPECT_GT(arrived, parameters.wildness < 100 ? 50u : 5u);
}

constexpr uint32_t kAll = 31;

INSTANTIATE_TEST_SUITE_P(Displays, TwinDisplaysTest,
                         testing::Values(Case{2, kAll, 0}, Case{3, kAll, 0}, Case{4, kAll, 0}, Case{2, kAll, 30},
                                         Case{3, kAll, 30}, Case{4, kAll, 30}, Case{3, 0, 10}, Case{3, 1 + 16, 10},
                                         Case{2, 2 + 4 + 8, 10}, Case{3, kAll, 100}));

}  // namespace
}  // namespace ocelli::test
