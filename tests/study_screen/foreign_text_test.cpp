// Texts of ideographs and kana are drawn, each with a glyph of its own.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "study/screen/drawable_text.h"
#include "study/screen/study_painter.h"
#include "tests/gl/gl_test_context.h"

namespace ocelli {
namespace {

constexpr TrialScreen kScreen{1024, 640, 60};

PageScreen pageOf(const std::string& text) {
  return {text, {text}, {}, {}, {}, 0, "Enter: go on"};
}

TEST(ForeignText, everyCharacterHasAGlyphOfItsOwn) {
  const auto context = openOffscreenContext();
  StudyPainter painter(*context, kScreen, Controls{}, glyphsOf("你好かハ≈"));
  const GlScope scope(*context);
  std::vector<Image<Rgb8>> images;
  // Questions marks, which a missing character is drawn as, are among them.
  for (const char* text : {"你", "好", "か", "ハ", "≈", "?", "A"}) {
    EXPECT_TRUE(painter.canShow(text)) << text << ": install fonts-droid-fallback";
    painter.draw(pageOf(text));
    images.push_back(painter.image());
    for (size_t i = 0; i + 1 < images.size(); ++i) {
      EXPECT_FALSE(std::equal(images[i].begin(), images[i].end(), images.back().begin())) << i << " and " << text;
    }
  }
  // As large as the letters beside them: at half the width of a line at least.
  painter.draw(pageOf("你"));
  const auto box = std::ranges::find(painter.textBoxes(), "你", &TextBox::text);
  ASSERT_NE(box, painter.textBoxes().end());
  EXPECT_GT(box->place.width, 0.5 * box->pixels);
}

TEST(ForeignText, whatWasNotAskedForCannotBeShown) {
  const auto context = openOffscreenContext();
  const StudyPainter painter(*context, kScreen, Controls{}, glyphsOf("你"));
  EXPECT_TRUE(painter.canShow("Back in a minute, naïve “Жук”\n你"));
  for (const char* text : {"好", "سلام", "\U0001f600", "e\u0301", "bell\a"}) {
    EXPECT_FALSE(painter.canShow(text)) << text;
  }
}

TEST(ForeignText, longLinesOfIdeographsAreBroken) {
  const auto context = openOffscreenContext();
  std::string text;
  for (int i = 0; i < 120; ++i) {
    text += i % 15 == 14 ? "。" : "字";
  }
  StudyPainter painter(*context, kScreen, Controls{}, glyphsOf(text));
  const GlScope scope(*context);
  painter.draw(PageScreen{"Title", {text}, {}, {}, {}, 0, "Enter: go on"});
  std::string drawn;
  for (const TextBox& box : painter.textBoxes()) {
    EXPECT_LE(box.place.right(), kScreen.width);
    EXPECT_TRUE(painter.canShow(box.text)) << "cut within a character: " << box.text;
    if (box.text.starts_with("字") || box.text.starts_with("。")) {
      drawn += box.text;
    }
  }
  EXPECT_EQ(drawn, text);
}

}  // namespace
}  // namespace ocelli
