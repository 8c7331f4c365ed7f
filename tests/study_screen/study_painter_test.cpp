// Every kind of screen, in every size: what is written can be read, and what is clicked is reported.
#include "study/screen/study_painter.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <map>

#include "tests/gl/gl_test_context.h"
#include "tests/study_screen/sample_screens.h"

namespace ocelli {
namespace {

constexpr std::array<TrialScreen, 4> kScreens{{{1024, 640, 60}, {1280, 800, 60}, {1920, 1200, 60}, {2560, 1440, 144}}};

class StudyPainterTest : public testing::Test {
 protected:
  std::unique_ptr<GlContext> context_ = openOffscreenContext();
  test::SampleStudy study_;
};

/// The colour that most pixels of a place have.
Rgb8 commonColor(const Image<Rgb8>& image, const PixelRect& place) {
  std::map<std::array<uint8_t, 3>, int> counts;
  for (int y = static_cast<int>(place.top); y < static_cast<int>(place.bottom()); ++y) {
    for (int x = static_cast<int>(place.left); x < static_cast<int>(place.right()); ++x) {
      const Rgb8& pixel = image(x, y);
      ++counts[{pixel.x, pixel.y, pixel.z}];
    }
  }
  const auto most = std::ranges::max_element(counts, {}, [](const auto& entry) { return entry.second; });
  return {most->first[0], most->first[1], most->first[2]};
}

TEST_F(StudyPainterTest, allTextIsOnTheScreenLargeAndInContrast) {
  for (const TrialScreen& screen : kScreens) {
    StudyPainter painter(*context_, screen, Controls{});
    const GlScope scope(*context_);
    for (const auto& [name, shown] : study_.all(screen)) {
      painter.draw(shown);
      const Image<Rgb8> image = painter.image();
      EXPECT_FALSE(painter.textBoxes().empty()) << name;
      for (const TextBox& box : painter.textBoxes()) {
        const std::string where = name + ", " + std::to_string(screen.width) + ": \"" + box.text + "\"";
        EXPECT_GE(box.place.left, 0) << where;
        EXPECT_GE(box.place.top, 0) << where;
        EXPECT_LE(box.place.right(), screen.width) << where;
        EXPECT_LE(box.place.bottom(), screen.height) << where;
        EXPECT_GE(box.pixels, StudyLook::kMinTextPixels) << where;
        EXPECT_GE(contrastRatio(box.color, box.background), kMinContrast) << where;
        // It is drawn on what it says, not on something else.
        const Rgb8 behind = commonColor(image, box.place);
        EXPECT_EQ(behind, Rgb8(box.background.red, box.background.green, box.background.blue)) << where;
      }
    }
  }
}

TEST_F(StudyPainterTest, noTextLiesOverAnother) {
  for (const TrialScreen& screen : kScreens) {
    StudyPainter painter(*context_, screen, Controls{});
    const GlScope scope(*context_);
    for (const auto& [name, shown] : study_.all(screen)) {
      painter.draw(shown);
      const std::vector<TextBox>& boxes = painter.textBoxes();
      for (size_t i = 0; i < boxes.size(); ++i) {
        for (size_t j = 0; j < i; ++j) {
          const PixelRect& a = boxes[i].place;
          const PixelRect& b = boxes[j].place;
          const bool apart = a.left >= b.right() || b.left >= a.right() || a.top >= b.bottom() || b.top >= a.bottom();
          EXPECT_TRUE(apart) << name << ", " << screen.width << ": \"" << boxes[i].text << "\" and \"" << boxes[j].text
                             << "\"";
        }
      }
    }
  }
}

TEST_F(StudyPainterTest, theKeyForThoseWhoFeelUnwellIsOnEveryScreen) {
  StudyPainter painter(*context_, kScreens[1], Controls{});
  const GlScope scope(*context_);
  for (const auto& [name, shown] : study_.all(kScreens[1])) {
    painter.draw(shown);
    const auto& boxes = painter.textBoxes();
    EXPECT_TRUE(std::ranges::any_of(boxes, [](const TextBox& box) { return box.text == "F10"; })) << name;
  }
}

TEST_F(StudyPainterTest, rightAndWrongDifferInShapeAndWord) {
  StudyPainter painter(*context_, kScreens[1], Controls{});
  const GlScope scope(*context_);
  // Without colours: the luminance of what is drawn differs.
  std::vector<Image<Rgb8>> images;
  for (const bool good : {true, false}) {
    PageScreen page = study_.feedback(good);
    page.title = "The same";
    page.paragraphs = {"The same"};
    painter.draw(page);
    images.push_back(painter.image());
  }
  size_t dark = 0;  // pixels of the tick that are none of the cross, or the other way round
  for (size_t i = 0; i < images[0].size(); ++i) {
    const auto isInk = [&](const Image<Rgb8>& image) {
      return image[i] == Rgb8(kStudyInk.red, kStudyInk.green, kStudyInk.blue);
    };
    dark += isInk(images[0]) != isInk(images[1]);
  }
  EXPECT_GT(dark, 300u);
}

TEST_F(StudyPainterTest, longTextsCanBeScrolledToTheirEnd) {
  StudyPainter painter(*context_, kScreens[0], Controls{});
  const GlScope scope(*context_);
  const SessionScreen consent = study_.consentScreen();
  const auto lines = [&] {
    painter.draw(consent);
    std::vector<std::string> texts;
    for (const TextBox& box : painter.textBoxes()) {
      texts.push_back(box.text);
    }
    return texts;
  };
  study_.consent.back() = "The very last words.";
  const SessionScreen longer = study_.consentScreen();
  painter.draw(longer);
  const auto hasLast = [&] {
    return std::ranges::any_of(painter.textBoxes(),
                               [](const TextBox& box) { return box.text == "The very last words."; });
  };
  EXPECT_FALSE(hasLast());
  for (int i = 0; i < 10; ++i) {
    painter.handle(KeyEvent{Key::kPageDown, true, {}});
    painter.handle(KeyEvent{Key::kPageDown, false, {}});
    painter.draw(longer);
  }
  EXPECT_TRUE(hasLast());
  for (int i = 0; i < 20; ++i) {
    painter.handle(ScrollEvent{0, 3});
    painter.draw(longer);
  }
  EXPECT_FALSE(hasLast());
  EXPECT_THAT(lines(), testing::Contains("PageDown"));
}

TEST_F(StudyPainterTest, theFieldThatKeysActOnIsInSight) {
  StudyPainter painter(*context_, kScreens[0], Controls{});
  const GlScope scope(*context_);
  for (int focus = 0; focus < 5; ++focus) {
    FormScreen form = study_.formScreen(false);
    form.focus = focus;
    painter.draw(form);
    const std::string question = study_.form.fields[static_cast<size_t>(focus)].question.substr(0, 20);
    EXPECT_TRUE(std::ranges::any_of(painter.textBoxes(), [&](const TextBox& box) {
      return box.text.starts_with(question);
    })) << focus;
  }
}

/// Clicks on the middle of a text, and returns what the painter makes of it.
StudyFrame clickOn(StudyPainter& painter, const SessionScreen& screen, const std::string& text) {
  painter.draw(screen);
  const auto box = std::ranges::find(painter.textBoxes(), text, &TextBox::text);
  if (box == painter.textBoxes().end()) {
    ADD_FAILURE() << "there is no \"" << text << "\"";
    return {};
  }
  const glm::dvec2 at = box->place.center();
  painter.handle(PointerMoveEvent{at.x, at.y});
  painter.handle(PointerButtonEvent{PointerButton::kLeft, true, {}});
  painter.handle(PointerButtonEvent{PointerButton::kLeft, false, {}});
  for (int i = 0; i < 6; ++i) {
    const StudyFrame frame = painter.draw(screen);
    if (frame.action || frame.key) {
      return frame;
    }
  }
  return {};
}

TEST_F(StudyPainterTest, reportsClicks) {
  StudyPainter painter(*context_, kScreens[1], Controls{});
  const GlScope scope(*context_);
  const SessionScreen form = study_.formScreen(false);
  const StudyFrame option = clickOn(painter, form, "35-44");
  ASSERT_TRUE(option.action);
  EXPECT_EQ(option.action->kind, FormAction::Kind::kClick);
  EXPECT_EQ(option.action->item, 0);
  EXPECT_EQ(option.action->click.option, 2);
  const StudyFrame done = clickOn(painter, form, "Go on");
  ASSERT_TRUE(done.action);
  EXPECT_EQ(done.action->kind, FormAction::Kind::kGoOn);

  const StudyFrame agree = clickOn(painter, study_.consentScreen(), "I agree");
  ASSERT_TRUE(agree.action);
  EXPECT_EQ(agree.action->kind, FormAction::Kind::kGoOn);
  const StudyFrame decline = clickOn(painter, study_.consentScreen(), "I do not agree");
  ASSERT_TRUE(decline.action);
  EXPECT_EQ(decline.action->kind, FormAction::Kind::kDecline);

  EXPECT_EQ(clickOn(painter, study_.instructions("controls"), "Begin practice").key, Key::kEnter);
  PageScreen unwell;
  unwell.title = "Do you feel unwell?";
  unwell.action = "Enter: end the session    Escape: go on with it";
  EXPECT_EQ(clickOn(painter, unwell, "Go on with it").key, Key::kEscape);
  EXPECT_EQ(clickOn(painter, unwell, "End the session").key, Key::kEnter);
}

TEST_F(StudyPainterTest, whatIsScrolledAwayTakesNoClicks) {
  StudyPainter painter(*context_, kScreens[1], Controls{});
  const GlScope scope(*context_);
  for (const ProtocolForm& each : study_.questionnaires.at("en")) {
    FormScreen form{&each, itemsOf(each.fields), {}, 0, false};
    form.entries.resize(form.items.size());
    for (; form.focus < static_cast<int>(form.items.size()); ++form.focus) {
      const StudyFrame frame = clickOn(painter, form, "Go on");
      ASSERT_TRUE(frame.action) << each.name << " " << form.focus;
      EXPECT_EQ(frame.action->kind, FormAction::Kind::kGoOn) << each.name << " " << form.focus;
    }
  }
}

TEST_F(StudyPainterTest, slidersTakeTheirPlaceFromTheMouse) {
  const auto tlx = findQuestionnaire("nasa-tlx", "en");
  FormScreen form{&tlx->form, itemsOf(tlx->form.fields), {}, 0, false};
  form.entries.resize(form.items.size());
  for (const char* language : {"en", "ar"}) {
    StudyPainter painter(*context_, kScreens[1], Controls{}, {}, SubjectTexts(language));
    const GlScope scope(*context_);
    painter.draw(form);
    const auto end = std::ranges::find(painter.textBoxes(), "very much", &TextBox::text);
    ASSERT_NE(end, painter.textBoxes().end());
    // The line ends above the words, half a mark from the border of the card.
    const bool mirrored = std::string(language) == "ar";
    const double x = mirrored ? end->place.left + 17 : end->place.right() - 17;
    painter.handle(PointerMoveEvent{x, end->place.top - 25});
    painter.handle(PointerButtonEvent{PointerButton::kLeft, true, {}});
    StudyFrame frame;
    for (int i = 0; i < 6 && !frame.action; ++i) {
      frame = painter.draw(form);
    }
    ASSERT_TRUE(frame.action) << language;
    EXPECT_EQ(frame.action->item, 0);
    EXPECT_NEAR(frame.action->click.share, 1, 0.01) << language;
  }
}

TEST_F(StudyPainterTest, aBreakCannotBeClickedAway) {
  StudyPainter painter(*context_, kScreens[1], Controls{});
  const GlScope scope(*context_);
  const StudyFrame waiting = clickOn(painter, study_.rest(20), "Go on");
  EXPECT_FALSE(waiting.action || waiting.key);
  EXPECT_EQ(clickOn(painter, study_.rest(0), "Go on").key, Key::kEnter);
}

TEST_F(StudyPainterTest, pressingIsNoClick) {
  StudyPainter painter(*context_, kScreens[1], Controls{});
  const GlScope scope(*context_);
  const SessionScreen page = study_.rest(0);
  painter.draw(page);
  painter.handle(PointerMoveEvent{1150, 754});
  painter.handle(PointerButtonEvent{PointerButton::kLeft, true, {}});
  for (int i = 0; i < 4; ++i) {
    EXPECT_FALSE(painter.draw(page).key);
  }
  painter.handle(PointerMoveEvent{100, 100});
  painter.handle(PointerButtonEvent{PointerButton::kLeft, false, {}});
  for (int i = 0; i < 4; ++i) {
    EXPECT_FALSE(painter.draw(page).key) << "the button was let go elsewhere";
  }
}

}  // namespace
}  // namespace ocelli
