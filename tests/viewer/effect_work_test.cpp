#include "display_sim/viewer/effect_work.h"

#include <gmock/gmock.h>
#include <malloc.h>

#include <chrono>

#include "oc_core/base/error.h"
#include "tests/base/temporary_folder.h"
#include "tests/viewer/small_effect.h"

namespace ocelli {
namespace {

using testing::HasSubstr;
using Content = EffectShown::Content;

class EffectWorkTest : public testing::Test {
 protected:
  EffectWanted wanted() const {
    EffectWanted wanted;
    wanted.on = wanted.shows = true;
    wanted.source = test::kSmallScene;
    wanted.sceneRevision = 1;
    wanted.rolesFile = roles_.string();
    wanted.effect = "reflection";
    wanted.way = "di";
    wanted.referenceSize = {60, 40};
    wanted.environmentHeight = 32;
    wanted.size = {48, 32};
    return wanted;
  }

  test::TemporaryFolder folder_;
  std::filesystem::path roles_ = folder_.write("mirror.roles.json", test::kMirrorRoles);
};

EffectStatus statusOf(EffectWork& work, const EffectWanted& wanted) {
  work.want(wanted);
  work.waitUntilIdle();
  return work.status();
}

TEST_F(EffectWorkTest, drawsWhatShadeDraws) {
  EffectWork work;
  EXPECT_FALSE(work.status().busy);
  for (const char* way : {"di", "environment", "traced"}) {
    EffectWanted wanted = this->wanted();
    wanted.way = way;
    const EffectStatus status = statusOf(work, wanted);
    ASSERT_TRUE(status.picture) << status.error;
    EXPECT_TRUE(status.picture->isWhole);
    EXPECT_EQ(status.picture->byWay.image, test::shadedPicture(wanted, way)) << way;
    EXPECT_EQ(status.picture->traced.image, test::shadedPicture(wanted, "traced")) << way;
    ASSERT_TRUE(status.picture->difference) << way;
    EXPECT_EQ(status.picture->difference->different == 0, way == std::string("traced")) << way;
    EXPECT_EQ(status.effect, "reflection");
    EXPECT_FALSE(status.busy);
  }
}

TEST_F(EffectWorkTest, findsOutWhichEffectTheSceneHas) {
  EffectWork work;
  EffectWanted wanted = this->wanted();
  wanted.effect = wanted.way = "";
  const EffectStatus status = statusOf(work, wanted);
  EXPECT_EQ(status.effect, "reflection");
  ASSERT_TRUE(status.home);
  EXPECT_NE(*status.home, View{});
  EXPECT_FALSE(status.picture);
}

TEST_F(EffectWorkTest, theNewestOfManyWishesIsTheOneThatStays) {
  EffectWork work;
  EffectWanted wanted = this->wanted();
  for (const char* way : {"spoc", "ddoc", "environment", "di"}) {
    wanted.way = way;
    for (int step = 0; step < 20; ++step) {
      wanted.view.eye.x += 0.01f;
      wanted.content = kEffectContents[static_cast<size_t>(step % 3)];
      work.want(wanted);
    }
  }
  const EffectStatus status = statusOf(work, wanted);
  ASSERT_TRUE(status.picture);
  EXPECT_EQ(status.picture->wanted, wanted);
  EXPECT_EQ(status.picture->byWay.image, test::shadedPicture(wanted, "di"));
}

TEST_F(EffectWorkTest, whatIsDrawnOnceIsNotDrawnAgain) {
  EffectWork work;
  EffectWanted wanted = this->wanted();
  const EffectStatus first = statusOf(work, wanted);
  wanted.content = Content::kDifference;
  const EffectStatus second = statusOf(work, wanted);
  EXPECT_EQ(first.picture->byWay.milliseconds, second.picture->byWay.milliseconds);
  EXPECT_EQ(first.picture->traced.milliseconds, second.picture->traced.milliseconds);
  wanted.way = "environment";  // the traced picture stays
  const EffectStatus third = statusOf(work, wanted);
  EXPECT_EQ(first.picture->traced.milliseconds, third.picture->traced.milliseconds);
}

TEST(EffectWork, firstPicturesAreAsSmallAsTheyMustBe) {
  EXPECT_EQ(previewScale(0), 0.125);  // nothing is known
  EXPECT_EQ(previewScale(EffectWork::kPreviewSeconds), 1);
  EXPECT_EQ(previewScale(1.01 * EffectWork::kPreviewSeconds), 0.5);
  EXPECT_EQ(previewScale(4 * EffectWork::kPreviewSeconds), 0.5);
  EXPECT_EQ(previewScale(4.01 * EffectWork::kPreviewSeconds), 0.25);
  EXPECT_EQ(previewScale(1e9), 0.125);
}

TEST_F(EffectWorkTest, aSmallPictureComesBeforeTheWholeOne) {
  // It stands for kStillSeconds; a machine so busy that it is overlooked four times is none to test on.
  bool seen = false;
  for (int attempt = 0; attempt < 5 && !seen; ++attempt) {
    EffectWork work;
    work.want(wanted());
    while (work.status().busy) {
      const std::shared_ptr<const EffectPicture> picture = work.status().picture;
      if (picture && !picture->isWhole) {
        EXPECT_LT(picture->byWay.image.width(), wanted().size.x);
        EXPECT_TRUE(picture->traced.image.empty());  // which nobody looks at
        seen = true;
      }
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
    EXPECT_TRUE(work.status().picture->isWhole);
  }
  EXPECT_TRUE(seen);
}

TEST_F(EffectWorkTest, aSceneWithoutRolesSaysWhatToDo) {
  EffectWork work;
  EffectWanted wanted = this->wanted();
  wanted.rolesFile.clear();
  const EffectStatus without = statusOf(work, wanted);
  EXPECT_FALSE(without.picture);
  EXPECT_THAT(without.error, HasSubstr("--roles"));
  EXPECT_THAT(without.error, HasSubstr("builtin:mirror"));
  wanted.rolesFile = roles_.string();
  const EffectStatus with = statusOf(work, wanted);
  EXPECT_TRUE(with.picture);
  EXPECT_EQ(with.error, "");
}

TEST_F(EffectWorkTest, whatFailsLeavesTheRestAsItIs) {
  EffectWork work;
  EffectWanted wanted = this->wanted();
  wanted.effect = "refraction";
  EXPECT_THAT(statusOf(work, wanted).error, HasSubstr("\"refract\""));
  EXPECT_FALSE(work.status().picture);
  wanted.effect = "reflection";
  EXPECT_TRUE(statusOf(work, wanted).picture);
  wanted.source = "no-such-file.obj";
  wanted.sceneRevision = 2;
  EXPECT_THAT(statusOf(work, wanted).error, HasSubstr("no-such-file.obj"));
  EXPECT_FALSE(work.status().picture);
  EXPECT_TRUE(statusOf(work, this->wanted()).picture);
}

TEST_F(EffectWorkTest, aFileOfRolesThatIsGivenAgainIsReadAgain) {
  EffectWork work;
  EffectWanted wanted = this->wanted();
  EXPECT_EQ(statusOf(work, wanted).error, "");
  folder_.write("mirror.roles.json", "{}");
  EXPECT_EQ(statusOf(work, wanted).error, "");
  ++wanted.rolesRead;
  EXPECT_THAT(statusOf(work, wanted).error, HasSubstr("objects"));
}

TEST_F(EffectWorkTest, whatIsOffIsForgottenAndWhatIsHiddenIsNotDrawn) {
  EffectWork work;
  EffectWanted wanted = this->wanted();
  wanted.shows = false;
  EXPECT_FALSE(statusOf(work, wanted).picture);
  EXPECT_EQ(work.status().effect, "reflection");
  wanted.shows = true;
  EXPECT_TRUE(statusOf(work, wanted).picture);
  wanted.on = false;
  const EffectStatus off = statusOf(work, wanted);
  EXPECT_FALSE(off.picture);
  EXPECT_EQ(off.effect, "");
  EXPECT_FALSE(off.home);
}

TEST_F(EffectWorkTest, switchingTakesNoMoreAndMoreMemory) {
  EffectWork work;
  EffectWanted wanted = this->wanted();
  wanted.environmentHeight = 256;  // 1.5 MB, which would show
  const auto round = [&] {
    for (const char* way : {"environment", "di", "spoc", "traced"}) {
      wanted.way = way;
      wanted.view.eye.x += 0.001f;
      statusOf(work, wanted);
    }
    return mallinfo2().uordblks;
  };
  round();
  const size_t before = round();
  size_t after = 0;
  for (int i = 0; i < 8; ++i) {
    after = round();
  }
  // What threads keep for later is far below one map for each round.
  EXPECT_LT(after, before + 4 * 1'500'000);
}

TEST_F(EffectWorkTest, canBeLeftInTheMiddle) {
  for (int milliseconds = 0; milliseconds < 12; ++milliseconds) {
    EffectWork work;
    EffectWanted wanted = this->wanted();
    wanted.way = "cell";
    wanted.content = Content::kDifference;
    work.want(wanted);
    std::this_thread::sleep_for(std::chrono::milliseconds(3 * milliseconds));
  }
}

}  // namespace
}  // namespace ocelli
