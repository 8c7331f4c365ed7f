// That compilers round where the code says so: rasterisers snap points to a grid, and a point that two triangles share
// must come to the same place however each of them is compiled.
#include <gtest/gtest.h>

namespace ocelli {
namespace {

struct Place {
  double x = 0;
  double y = 0;
};

__attribute__((noinline)) Place scaledInSingle(const Place& p) {
  const auto x = static_cast<float>(p.x);
  const auto y = static_cast<float>(p.y);
  return {static_cast<double>(x) * 256 + 3, static_cast<double>(y) * 256 + 3};
}

TEST(SinglePrecision, isRoundedTo) {
  volatile double x = 132.71289215526519;  // for compilers that would work it out themselves
  volatile double y = 67.9133301234567;
  const Place place = scaledInSingle({x, y});
  EXPECT_EQ(place.x, 132.712890625 * 256 + 3);
  EXPECT_EQ(place.y, 67.91333007812500 * 256 + 3);
}

}  // namespace
}  // namespace ocelli
