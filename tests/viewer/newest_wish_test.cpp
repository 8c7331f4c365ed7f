// The thread that makes the newest wish, and pictures of what moves made on it.
#include "display_sim/viewer/newest_wish.h"

#include <gmock/gmock.h>

#include <atomic>
#include <future>
#include <stdexcept>

#include "display_sim/viewer/moving_pictures.h"

namespace ocelli {
namespace {

struct WishStatus {
  bool busy = false;
  std::vector<int> made{};
};

class NewestWishTest : public testing::Test {
 protected:
  /// Makes the number 1 last until let go.
  void make(int wanted) {
    if (wanted == 1) {
      begun_.set_value();
      letGo_.get_future().wait();
    }
    wishes_.change([&](WishStatus& status) { status.made.push_back(wanted); });
  }

  std::promise<void> begun_;
  std::promise<void> letGo_;
  NewestWish<int, WishStatus> wishes_{[this](int wanted) { make(wanted); }};
};

TEST_F(NewestWishTest, thoseThatANewerOneHasOvertakenAreLeftOut) {
  EXPECT_FALSE(wishes_.status().busy);
  wishes_.want(1);
  begun_.get_future().wait();
  EXPECT_TRUE(wishes_.status().busy);
  EXPECT_TRUE(wishes_.isNewest(1));
  for (int wish = 2; wish <= 9; ++wish) {
    wishes_.want(wish);
  }
  EXPECT_FALSE(wishes_.isNewest(1));
  letGo_.set_value();
  wishes_.waitUntilIdle();
  EXPECT_THAT(wishes_.status().made, testing::ElementsAre(1, 9));
  EXPECT_FALSE(wishes_.status().busy);
}

TEST_F(NewestWishTest, theSameIsMadeOnceUnlessItIsAskedForAgain) {
  wishes_.want(5);
  wishes_.want(5);
  wishes_.waitUntilIdle();
  wishes_.want(5);
  wishes_.waitUntilIdle();
  EXPECT_THAT(wishes_.status().made, testing::ElementsAre(5));
  wishes_.waitUntilIdle([](int wanted, const WishStatus& status) { return wanted == 5 && status.made.size() == 1; });
  EXPECT_THAT(wishes_.status().made, testing::ElementsAre(5, 5));
}

TEST_F(NewestWishTest, changesOfWhatIsOfNoUseAreRefused) {
  wishes_.want(3);
  wishes_.waitUntilIdle();
  const auto add = [](WishStatus& status) { status.made.push_back(0); };
  EXPECT_FALSE(wishes_.changeWhere([](int newest) { return newest == 4; }, add));
  EXPECT_TRUE(wishes_.changeWhere([](int newest) { return newest == 3; }, add));
  EXPECT_THAT(wishes_.status().made, testing::ElementsAre(3, 0));
}

TEST_F(NewestWishTest, stillnessEndsWithTheNextWish) {
  wishes_.want(3);
  wishes_.waitUntilIdle();
  EXPECT_TRUE(wishes_.standsStill(3, 0.001));
  EXPECT_FALSE(wishes_.standsStill(4, 60)) << "it is another one already";
}

struct PictureWanted {
  int number = 0;  ///< 0: none
  glm::ivec2 size{64, 32};
  bool canBePainted() const { return number != 0; }
  bool operator==(const PictureWanted&) const = default;
};

/// Tells its progress a hundred times a picture.
class SlowPainter {
 public:
  static constexpr std::array kScales{1.0, 0.5, 0.25, 0.125};
  static constexpr bool kStartsSmall = true;
  static constexpr int kBroken = 13;
  static inline std::atomic<int> begun = 0;
  static inline std::atomic<int> whole = 0;

  Image<Rgb8> paint(const PictureWanted& wanted, const glm::ivec2& size, const Progress& progress) {
    ++begun;
    if (wanted.number == kBroken) {
      throw std::runtime_error("broken");
    }
    for (int i = 0; i < 100 && size == wanted.size; ++i) {
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
      report(progress, "painting", i / 100.0);
    }
    whole += size == wanted.size;
    return {size.x, size.y, Rgb8(static_cast<uint8_t>(wanted.number))};
  }
};
using SlowPictures = MovingPictures<PictureWanted, SlowPainter>;

TEST(MovingPictures, theFirstOneIsSmallAndThenItIsWhole) {
  SlowPictures pictures;
  pictures.want({7});
  while (!pictures.status().picture) {
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
  // The small one stands for kStillSeconds at least.
  EXPECT_EQ(pictures.status().picture->image.width(), 8);
  EXPECT_FALSE(pictures.status().picture->isWhole);
  pictures.waitUntilIdle();
  EXPECT_EQ(pictures.status().picture->image, Image<Rgb8>(64, 32, Rgb8(7)));
  EXPECT_TRUE(pictures.status().picture->isWhole);
}

TEST(MovingPictures, aWholePictureIsBrokenOffWhereSomethingElseIsWanted) {
  SlowPictures pictures;
  SlowPainter::begun = SlowPainter::whole = 0;
  pictures.want({1});
  while (SlowPainter::begun < 2) {  // the small one, then the whole one
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
  pictures.want({2});
  pictures.waitUntilIdle();
  EXPECT_EQ(pictures.status().picture->image(0, 0), Rgb8(2));
  EXPECT_TRUE(pictures.status().picture->isWhole);
  EXPECT_EQ(SlowPainter::whole, 1) << "the first was left";
}

TEST(MovingPictures, errorsAreTold) {
  SlowPictures pictures;
  pictures.want({SlowPainter::kBroken});
  pictures.waitUntilIdle();
  EXPECT_EQ(pictures.status().error, "broken");
  EXPECT_FALSE(pictures.status().picture);
  pictures.want({1});
  pictures.waitUntilIdle();
  EXPECT_EQ(pictures.status().error, "");
  EXPECT_TRUE(pictures.status().picture);
  pictures.want({});
  pictures.waitUntilIdle();
  EXPECT_FALSE(pictures.status().picture);
}

TEST(MovingPictures, areAsLargeAsTheyAreFast) {
  const auto sizeOf = [](const std::array<double, 3>& seconds) { return movingPictureSize(seconds, 0.1); };
  EXPECT_EQ(sizeOf({0, 0, 0}), 0U) << "nothing is known";
  EXPECT_EQ(sizeOf({0.05, 0, 0}), 0U);
  EXPECT_EQ(sizeOf({0.3, 0, 0}), 1U) << "a quarter of the pixels, likely 0.075 s";
  EXPECT_EQ(sizeOf({0.3, 0.2, 0}), 2U);
  EXPECT_EQ(sizeOf({0.3, 0.28, 0.25}), 0U) << "the scene costs, not the pixels: small ones are hardly faster";
  EXPECT_EQ(sizeOf({0.8, 0.28, 0.25}), 1U);
}

}  // namespace
}  // namespace ocelli
