#include "oc_core/remote_measure/virtual_link.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "oc_core/base/error.h"

namespace ocelli {
namespace {

using testing::HasSubstr;

TEST(VirtualLink, takesItsRateAndHalfOfTheRoundTrip) {
  VirtualLink link({1000, 0.4});
  // 500 bytes take half a second, and 0.2 s to arrive.
  EXPECT_DOUBLE_EQ(link.arrival(1, 500), 1.7);
  EXPECT_DOUBLE_EQ(link.freeAt(), 1.5);
  // What is given meanwhile waits for them.
  EXPECT_DOUBLE_EQ(link.arrival(1.1, 100), 1.8);
  // What is given later does not.
  EXPECT_DOUBLE_EQ(link.arrival(5, 1000), 6.2);
  EXPECT_EQ(link.sentBytes(), 1600u);
}

TEST(VirtualLink, sendsNothingAtOnce) {
  VirtualLink link({1000, 0});
  EXPECT_DOUBLE_EQ(link.arrival(3, 0), 3);
}

TEST(LinkSpeed, isReadAndNamed) {
  EXPECT_EQ(linkSpeedFromText("300KB/s:200ms"), (LinkSpeed{300e3, 0.2}));
  EXPECT_EQ(linkSpeedFromText("12.5MB/s:20ms"), (LinkSpeed{12.5e6, 0.02}));
  EXPECT_EQ(linkSpeedFromText("1GB/s:0ms"), (LinkSpeed{1e9, 0}));
  EXPECT_EQ(linkSpeedFromText("300KB/s:200ms").name(), "300 KB/s, 200 ms");
  EXPECT_EQ(linkSpeedFromText("12.5MB/s:20ms").name(), "12.5 MB/s, 20 ms");
  EXPECT_EQ(linkSpeedFromText("1GB/s:0.5ms").name(), "1 GB/s, 0.5 ms");
}

TEST(LinkSpeed, refusesOtherTexts) {
  for (const char* text : {"", "300", "300KB/s", "300KB/s:", "300KB/s:200", "300KB/s:200s", "300KB/s200ms", "KB/s:20ms",
                           "300KB/s:ms", "-300KB/s:20ms", "300KB/s:-1ms", "nanKB/s:20ms", "300KB/s:nanms", "0KB/s:20ms",
                           "11GB/s:20ms", "300KB/s:10001ms", "300KB/s:20ms ", "300B/s:20ms"}) {
    EXPECT_THROW(linkSpeedFromText(text), InputError) << text;
  }
  try {
    linkSpeedFromText("fast");
    FAIL();
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(), HasSubstr("--link 300KB/s:200ms"));
  }
}

TEST(LinkSpeed, hasTheTextsLinksByDefault) {
  const std::vector<LinkSpeed> links = defaultLinks();
  ASSERT_EQ(links.size(), 6u);
  EXPECT_EQ(links[1], (LinkSpeed{300e3, 0.2}));
  EXPECT_EQ(links[4], (LinkSpeed{12.5e6, 0.02}));
}

}  // namespace
}  // namespace ocelli
