// Frames of replays show scales and dials, and where the mark is.
#include "study/replay/trial_frame.h"

#include <gtest/gtest.h>

#include "tests/study_task/study_tasks.h"

namespace ocelli {
namespace {

constexpr TrialScreen kFrameScreen{320, 240, 60};

/// Pixels of a place that differ.
int changedIn(const Image<Rgb8>& a, const Image<Rgb8>& b, const PixelRect& place) {
  int changed = 0;
  for (int y = static_cast<int>(place.top); y < static_cast<int>(place.bottom()); ++y) {
    for (int x = static_cast<int>(place.left); x < static_cast<int>(place.right()); ++x) {
      changed += a(x, y) != b(x, y) ? 1 : 0;
    }
  }
  return changed;
}

TEST(TrialFrame, ShowsScaleAndDialAndTheirMark) {
  for (const char* task : {"distance", "direction"}) {
    SCOPED_TRACE(task);
    const test::TaskExample& example = test::taskExample(task);
    const auto block = test::readBlock(example.task, example.json);
    TrialLayout layout = block->start(test::planOf(example.task, 0, TrialView::kReference), kFrameScreen)->layout();
    const glm::dvec2 at = test::placeOfAnswer(layout, std::stod(block->answerOf({})), true);
    const PixelRect around{at.x - 6, at.y - 6, 12, 12};
    const PixelRect place = layout.scale ? layout.scale->place : layout.dial->place;
    layout.pointer.reset();
    TrialLayout bare = layout;
    bare.scale.reset();
    bare.dial.reset();
    TrialLayout marked = layout;
    if (marked.scale) {
      marked.scale->mark = std::stod(block->answerOf({}));
    } else {
      marked.dial->degrees = std::stod(block->answerOf({}));
    }
    const auto frame = [](const TrialLayout& of) { return trialFrame(of, kFrameScreen, rasterizeStudy); };
    const Image<Rgb8> shown = frame(layout);
    EXPECT_GT(changedIn(shown, frame(bare), place), 50);
    EXPECT_GT(changedIn(shown, frame(marked), around), 10);
  }
}

}  // namespace
}  // namespace ocelli
