#include "oc_core/sea_measure/remembered_source.h"

#include <gtest/gtest.h>

#include "tests/sea/made_sea.h"

namespace ocelli {
namespace {

class CountedImages final : public SeaSource {
 public:
  std::string description() const override { return "counted"; }
  const SeaProjection& projection() const override { return images_.projection(); }
  const std::vector<SeaPose>& poses() const override { return images_.poses(); }
  const std::vector<std::string>& names() const override { return images_.names(); }
  Image<Rgb8> image(uint32_t index) const override {
    ++made;
    return images_.image(index);
  }

  mutable int made = 0;

 private:
  test::RoomImages images_{test::gridPoses(2, 2, 0.15), {.width = 32, .height = 16}};
};

TEST(RememberedSource, makesEachImageOnce) {
  const CountedImages images;
  const RememberedSource remembered(images);
  for (int round = 0; round < 3; ++round) {
    for (uint32_t i = 0; i < 4; ++i) {
      const Image<Rgb8> image = remembered.image(i);
      EXPECT_TRUE(std::equal(image.begin(), image.end(), images.image(i).begin()));
    }
  }
  EXPECT_EQ(images.made, 4 + 12) << "four of its own, and those that the test asked for";
}

}  // namespace
}  // namespace ocelli
