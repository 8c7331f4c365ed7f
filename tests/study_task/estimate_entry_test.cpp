// Marks on scales and dials: by the mouse, by keys, and when they are answers.
#include "study/task/estimate_entry.h"

#include <gtest/gtest.h>

#include "tests/study_task/study_tasks.h"

namespace ocelli {
namespace {

using test::press;

constexpr PixelRect kScreen{0, 0, 640, 480};
constexpr PixelRect kButton{500, 400, 100, 40};
/// 20 m over 400 pixels.
TrialLayout::Scale scale() {
  return {.place = {50, 400, 400, 60}, .least = 0, .most = 20, .step = 2, .unit = "m"};
}
constexpr TrialLayout::Dial kDial{{100, 100, 200, 200}};

/// An entry with its pointer, as tasks have them.
class Entry {
 public:
  template <class On>
  explicit Entry(On on) : entry_(on, kButton) {}

  bool handle(const InputEvent& event) {
    if (std::holds_alternative<PointerMoveEvent>(event)) {
      pointer_.handle(event);
    }
    const bool confirmed = entry_.handle(event, pointer_);
    pointer_.handle(event);
    return confirmed;
  }
  bool click(const glm::dvec2& at) {
    handle(test::moveTo(at));
    const bool confirmed = handle(test::button(PointerButton::kLeft, true));
    handle(test::button(PointerButton::kLeft, false));
    return confirmed;
  }
  void tap(Key key) {
    handle(press(key));
    handle(test::release(key));
  }
  void pass(int64_t ticks) {
    for (int64_t i = 0; i < ticks; ++i) {
      entry_.advance();
    }
  }
  std::optional<double> value() const { return entry_.value(); }
  TrialLayout layout() const {
    TrialLayout layout;
    entry_.addTo(layout);
    return layout;
  }

 private:
  Controls controls_;
  TaskPointer pointer_{kScreen, controls_};
  EstimateEntry entry_;
};

TEST(EstimateEntry, HasNoMarkUntilOneIsSetAndCannotBeConfirmedWithoutOne) {
  for (Entry entry : {Entry(scale()), Entry(kDial)}) {
    EXPECT_FALSE(entry.value());
    EXPECT_TRUE(entry.layout().choices.empty());
    EXPECT_FALSE(entry.handle(press(Key::kEnter)));
    EXPECT_FALSE(entry.click(kButton.center()));
    EXPECT_FALSE(entry.value());
  }
}

TEST(EstimateEntry, AClickOnTheScaleSetsTheMarkThere) {
  Entry entry(scale());
  EXPECT_FALSE(entry.click({50 + 400 * 0.25, 430}));
  EXPECT_EQ(entry.value(), 5);
  EXPECT_EQ(entry.layout().scale->mark, 5);
  EXPECT_FALSE(entry.click({300, 300})) << "beside it";
  EXPECT_EQ(entry.value(), 5);
  EXPECT_FALSE(entry.click({50, 430}));
  EXPECT_EQ(entry.value(), 0.01) << "lengths are above 0";
  EXPECT_FALSE(entry.click({449, 430}));
  EXPECT_EQ(entry.value(), 19.95);
}

TEST(EstimateEntry, ADragMovesTheMarkUntilTheButtonIsLetGo) {
  Entry entry(scale());
  entry.handle(test::moveTo({150, 430}));
  entry.handle(test::button(PointerButton::kLeft, true));
  entry.handle(test::moveTo({250, 100}));
  EXPECT_EQ(entry.value(), 10) << "above the scale too";
  entry.handle(test::moveTo({639, 430}));
  EXPECT_EQ(entry.value(), 20);
  entry.handle(test::button(PointerButton::kRight, false));
  entry.handle(test::moveTo({250, 430}));
  EXPECT_EQ(entry.value(), 10) << "another button";
  entry.handle(test::button(PointerButton::kLeft, false));
  entry.handle(test::moveTo({150, 430}));
  EXPECT_EQ(entry.value(), 10);
}

TEST(EstimateEntry, TheDialCountsClockwiseFromAhead) {
  Entry entry(kDial);
  for (const auto& [at, degrees] : std::vector<std::pair<glm::dvec2, double>>{
           {{200, 110}, 0}, {{290, 200}, 90}, {{200, 290}, 180}, {{110, 200}, 270}, {{150, 150}, 315}}) {
    entry.click(at);
    EXPECT_EQ(entry.value(), degrees);
  }
  entry.click({202, 203});
  EXPECT_EQ(entry.value(), 315) << "the middle tells no direction";
}

TEST(EstimateEntry, ArrowsMoveTheMarkStepByStep) {
  Entry entry(scale());
  entry.tap(Key::kRight);
  EXPECT_EQ(entry.value(), 0.1) << "from the lower end, by a two-hundredth of the scale";
  entry.tap(Key::kUp);
  entry.tap(Key::kLeft);
  EXPECT_EQ(entry.value(), 0.1);
  Entry fromAbove(scale());
  fromAbove.tap(Key::kLeft);
  EXPECT_EQ(fromAbove.value(), 19.9);
  Entry dial(kDial);
  dial.tap(Key::kLeft);
  EXPECT_EQ(dial.value(), 0) << "the first puts it ahead";
  dial.tap(Key::kLeft);
  EXPECT_EQ(dial.value(), 359);
  dial.tap(Key::kRight);
  dial.tap(Key::kRight);
  EXPECT_EQ(dial.value(), 1);
}

TEST(EstimateEntry, AnArrowThatIsHeldGoesOnByTicksAndNotByRepeats) {
  Entry entry(kDial);
  entry.handle(press(Key::kRight));
  for (int i = 0; i < 50; ++i) {
    entry.handle(press(Key::kRight));  // as systems repeat it
  }
  EXPECT_EQ(entry.value(), 0);
  entry.pass(72);  // 0.3 s
  EXPECT_EQ(entry.value(), 0);
  entry.pass(240);  // a second: 60 degrees
  EXPECT_EQ(entry.value(), 60);
  entry.handle(test::release(Key::kRight));
  entry.pass(240);
  EXPECT_EQ(entry.value(), 60);
  entry.handle(press(Key::kRight, true));
  entry.pass(240);
  EXPECT_EQ(entry.value(), 60) << "with Shift it moves the pointer";
}

TEST(EstimateEntry, EnterOrAClickOnTheButtonConfirms) {
  for (const bool byKey : {true, false}) {
    Entry entry(scale());
    entry.click({250, 430});
    const TrialLayout layout = entry.layout();
    ASSERT_EQ(layout.choices.size(), 1u);
    EXPECT_EQ(layout.choices.front().key, Key::kEnter);
    EXPECT_EQ(layout.choices.front().place, kButton);
    EXPECT_TRUE(byKey ? entry.handle(press(Key::kEnter)) : entry.click(kButton.center()));
    EXPECT_EQ(entry.value(), 10);
  }
}

TEST(EstimateEntry, TheSelectKeyClicksWhereThePointerIs) {
  Entry entry(scale());
  entry.handle(test::moveTo({250, 430}));
  entry.handle(press(Key::kSpace));
  EXPECT_EQ(entry.value(), 10);
  entry.handle(test::moveTo({350, 430}));
  EXPECT_EQ(entry.value(), 10) << "it does not drag";
  entry.handle(press(Key::kSpace));
  EXPECT_EQ(entry.value(), 10) << "a repeat";
}

}  // namespace
}  // namespace ocelli
