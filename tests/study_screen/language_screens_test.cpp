// What a session says by itself, in every language and size: it fits, nothing lies over another, all of it has glyphs.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdlib>

#include "study/screen/drawable_text.h"
#include "study/screen/study_painter.h"
#include "tests/gl/gl_test_context.h"
#include "tests/study_screen/sample_screens.h"

namespace ocelli {
namespace {

constexpr std::array<TrialScreen, 3> kSizes{{{1024, 640, 60}, {1280, 800, 60}, {1920, 1200, 60}}};

class LanguageScreens : public testing::TestWithParam<std::string> {
 protected:
  std::unique_ptr<GlContext> context_ = openOffscreenContext();
  test::SampleStudy study_;
  SubjectTexts texts_{GetParam()};

  /// In the folder that OCELLI_TEST_IMAGES names, for people to look at.
  static void keepImage(const std::string& name, const StudyPainter& painter) {
    if (const char* folder = std::getenv("OCELLI_TEST_IMAGES")) {
      writePng(std::string(folder) + "/" + GetParam() + "_" + name + ".png", painter.image());
    }
  }
};

TEST_P(LanguageScreens, fitAndLieApart) {
  for (const TrialScreen& screen : kSizes) {
    StudyPainter painter(*context_, screen, Controls{}, {}, texts_);
    const GlScope scope(*context_);
    for (const auto& [name, shown] : study_.ofLanguage(texts_, screen)) {
      painter.draw(shown);
      keepImage(name + "_" + std::to_string(screen.width), painter);
      const std::vector<TextBox>& boxes = painter.textBoxes();
      EXPECT_FALSE(boxes.empty()) << name;
      for (size_t i = 0; i < boxes.size(); ++i) {
        const PixelRect& a = boxes[i].place;
        const std::string where = name + ", " + std::to_string(screen.width) + ": \"" + boxes[i].text + "\"";
        EXPECT_GE(a.left, 0) << where;
        EXPECT_GE(a.top, 0) << where;
        EXPECT_LE(a.right(), screen.width) << where;
        EXPECT_LE(a.bottom(), screen.height) << where;
        for (size_t j = 0; j < i; ++j) {
          const PixelRect& b = boxes[j].place;
          const bool apart = a.left >= b.right() || b.left >= a.right() || a.top >= b.bottom() || b.top >= a.bottom();
          EXPECT_TRUE(apart) << where << " and \"" << boxes[j].text << "\"";
        }
      }
    }
  }
}

TEST_P(LanguageScreens, everyTextHasItsGlyphs) {
  const StudyPainter painter(*context_, kSizes[0], Controls{}, {}, texts_);
  for (const auto& [id, text] : texts_.catalogue().texts) {
    EXPECT_TRUE(painter.canShow(text)) << id << ": " << text;
  }
  EXPECT_TRUE(painter.canShow(texts_.catalogue().letters));
}

/// The button to go on stands at the end of a line: at the left where lines run to the left.
TEST_P(LanguageScreens, areMirroredWhereLinesRunToTheLeft) {
  StudyPainter painter(*context_, kSizes[1], Controls{}, {}, texts_);
  const GlScope scope(*context_);
  painter.draw(study_.kindsScreen(false, 0));
  const auto placeOf = [&](const std::string& text) {
    const auto box = std::ranges::find(painter.textBoxes(), text, &TextBox::text);
    EXPECT_NE(box, painter.textBoxes().end()) << text;
    return box == painter.textBoxes().end() ? 0 : box->place.center().x;
  };
  EXPECT_EQ(placeOf("F10") > kSizes[1].width / 2, texts_.rightToLeft());
  EXPECT_EQ(placeOf("1") > placeOf("5"), texts_.rightToLeft()) << "the first option is where one begins to read";
}

INSTANTIATE_TEST_SUITE_P(Languages, LanguageScreens, testing::Values("en", "de", "fr", "ja", "ar"),
                         [](const auto& test) { return test.param; });

TEST(LanguageScreenList, hasAllLanguages) {
  EXPECT_EQ(subjectCatalogues().size(), 5u) << "add the new one to the tests above";
}

}  // namespace
}  // namespace ocelli
