// Every task of the registry can be seen: what its trials show is drawn whole, and so are its images of instructions.
#include <gtest/gtest.h>

#include <set>

#include "study/screen/study_painter.h"
#include "study/screen/trial_painter.h"
#include "study/tasks/task_registry.h"
#include "tests/gl/gl_test_context.h"
#include "tests/study_screen/sample_screens.h"
#include "tests/study_task/study_tasks.h"

namespace ocelli {
namespace {

constexpr TrialScreen kTaskScreen{1024, 640, 60};

/// Colours in a part of an image.
size_t colorsIn(const Image<Rgb8>& image, const PixelRect& place) {
  std::set<std::array<int, 3>> colors;
  for (int y = static_cast<int>(place.top); y < static_cast<int>(place.bottom()); ++y) {
    for (int x = static_cast<int>(place.left); x < static_cast<int>(place.right()); ++x) {
      colors.insert({image(x, y).x, image(x, y).y, image(x, y).z});
    }
  }
  return colors.size();
}

/// Every view, choice and map has something drawn in its place; one colour would be a fill alone.
void expectDrawn(TrialPainter& painter, const TrialLayout& layout) {
  const Image<Rgb8> image = painter.render(layout);
  for (const TrialLayout::View& view : layout.views) {
    EXPECT_GT(colorsIn(image, view.place), 10u);
  }
  for (const TrialLayout::Choice& choice : layout.choices) {
    EXPECT_GT(colorsIn(image, choice.place), 3u) << choice.label;
  }
  for (const TrialLayout::PathMap& map : layout.maps) {
    EXPECT_GT(colorsIn(image, map.place), 3u);
  }
  if (layout.scale) {
    EXPECT_GT(colorsIn(image, layout.scale->place), 3u);
  }
  if (layout.dial) {
    EXPECT_GT(colorsIn(image, layout.dial->place), 3u);
  }
}

/// What tasks say is in the catalogues, under the English words.
void expectTranslated(const TrialLayout& layout) {
  const SubjectTexts german("de");
  EXPECT_NE(german.translated(layout.prompt), layout.prompt) << "protocols/languages/en.json lacks the prompt";
  for (const TrialLayout::Choice& choice : layout.choices) {
    const bool isNumber = choice.label.find_first_not_of("0123456789") == std::string::npos;
    EXPECT_TRUE(isNumber || german.translated(choice.label) != choice.label) << choice.label;
  }
}

TEST(TaskScreens, trialsAreDrawnFromTheirBeginToTheQuestion) {
  const std::unique_ptr<GlContext> context = openTestContext(GlProvider::kOsMesa);
  TrialPainter painter(*context, kTaskScreen);
  for (const test::TaskExample& example : test::taskExamples()) {
    SCOPED_TRACE(example.name);
    const auto block = test::readBlock(example.task, example.json);
    for (const TrialView view : kViews) {
      const auto run = block->start(test::planOf(example.task, 0, view), kTaskScreen);
      expectDrawn(painter, run->layout());
      expectTranslated(run->layout());
      for (int64_t tick = 0; run->layout().choices.empty() && !run->outcome(); ++tick) {
        if (tick % 4 == 0) {
          run->frameShown(tick);
        }
        run->advance();
      }
      expectDrawn(painter, run->layout());
      expectTranslated(run->layout());
    }
  }
}

/// Pixels that differ, in a part of an image.
int changedIn(const Image<Rgb8>& a, const Image<Rgb8>& b, const PixelRect& place) {
  int changed = 0;
  for (int y = static_cast<int>(place.top); y < static_cast<int>(place.bottom()); ++y) {
    for (int x = static_cast<int>(place.left); x < static_cast<int>(place.right()); ++x) {
      changed += a(x, y) != b(x, y) ? 1 : 0;
    }
  }
  return changed;
}

TEST(TaskScreens, theMarkOfAnEstimateShowsWhereItIsAndBringsAButton) {
  const std::unique_ptr<GlContext> context = openTestContext(GlProvider::kOsMesa);
  TrialPainter painter(*context, kTaskScreen);
  for (const char* name : {"distance", "direction"}) {
    SCOPED_TRACE(name);
    const test::TaskExample& example = test::taskExample(name);
    const auto block = test::readBlock(example.task, example.json);
    const auto run = block->start(test::planOf(example.task, 0, TrialView::kReference), kTaskScreen);
    TrialLayout before = run->layout();
    EXPECT_TRUE(before.choices.empty());
    const glm::dvec2 at = test::placeOfAnswer(before, std::stod(block->answerOf({})), true);
    run->handle(test::moveTo(at));
    run->handle(test::button(PointerButton::kLeft, true));
    TrialLayout after = run->layout();
    expectTranslated(after);
    expectDrawn(painter, after);
    ASSERT_EQ(after.choices.size(), 1u);
    before.pointer.reset();
    after.pointer.reset();
    const PixelRect around{at.x - 12, at.y - 12, 24, 24};
    EXPECT_GT(changedIn(painter.render(before), painter.render(after), around), 20);
  }
}

TEST(TaskScreens, imagesOfInstructionsAreDrawn) {
  const std::unique_ptr<GlContext> context = openTestContext(GlProvider::kOsMesa);
  StudyPainter painter(*context, kTaskScreen, Controls{});
  const test::SampleStudy study;
  const GlScope scope(*context);
  const auto drawn = [&](const std::string& name) {
    painter.draw(study.instructions(name));
    return painter.image();
  };
  const PixelRect right{kTaskScreen.width * 0.5, 100, kTaskScreen.width * 0.4, 400};
  std::set<std::string> names;
  for (const TaskKind& kind : taskKinds()) {
    EXPECT_FALSE(kind.images.empty()) << kind.name;
    for (const InstructionImage& image : kind.images) {
      EXPECT_TRUE(names.insert(image.name).second) << image.name;
      EXPECT_TRUE(std::string(image.name).starts_with(kind.name + "_"));
      EXPECT_EQ(instructionImage(image.name), &image);
      EXPECT_GT(colorsIn(drawn(image.name), right), 10u) << image.name;
    }
  }
  EXPECT_EQ(instructionImage("none"), nullptr);
}

}  // namespace
}  // namespace ocelli
