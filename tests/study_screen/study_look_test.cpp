#include "study/screen/study_look.h"

#include <gtest/gtest.h>

namespace ocelli {
namespace {

TEST(StudyLook, contrastIsThatOfTheStandard) {
  // WCAG 2.1: black on white is 21; #767676 is the darkest grey that has 4.54 on white.
  EXPECT_NEAR(contrastRatio({0, 0, 0}, {255, 255, 255}), 21, 1e-4);
  EXPECT_NEAR(contrastRatio({255, 255, 255}, {118, 118, 118}), 4.54, 0.005);
  EXPECT_EQ(contrastRatio(kStudyText, kStudyText), 1);
}

TEST(StudyLook, eachTextCanBeReadOnEachBackground) {
  for (const GuiColor text : {kStudyText, kStudyTextDim}) {
    for (const GuiColor background : {kStudyBackground, kStudyCard, kStudyField, kStudyFieldHovered}) {
      EXPECT_GE(contrastRatio(text, background), kMinContrast);
    }
  }
  EXPECT_GE(contrastRatio(kStudyText, kStudyAccentDeep), kMinContrast);
  for (const GuiColor meaning : {kStudyGood, kStudyBad, kStudyAccent}) {
    EXPECT_GE(contrastRatio(kStudyInk, meaning), kMinContrast);
    // WCAG 2.1, 1.4.11: shapes that one must see.
    EXPECT_GE(contrastRatio(kStudyBackground, meaning), 3);
    EXPECT_GE(contrastRatio(kStudyCard, meaning), 3);
  }
}

TEST(StudyLook, textGrowsWithTheScreenAndIsNeverSmall) {
  for (const StudyText text : kStudyTexts) {
    EXPECT_GE(StudyLook(640, 480).textPixels(text), 21);
    EXPECT_GE(StudyLook(1280, 800).textPixels(text), 21);
    EXPECT_EQ(StudyLook(2560, 1600).textPixels(text), 2 * StudyLook(1280, 800).textPixels(text));
  }
  EXPECT_EQ(StudyLook(2560, 800).length(10), 10) << "the smaller side decides";
}

}  // namespace
}  // namespace ocelli
