// What every row of the registry keeps to (task_registry.h, task.h).
#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <functional>

#include "oc_core/constructor/multiperspective_camera.h"
#include "study/agent/visibility_sensor.h"
#include "study/tasks/task_registry.h"
#include "study/trial/estimated_value.h"
#include "tests/study_task/study_tasks.h"

namespace ocelli {
namespace {

using test::TaskExample;

constexpr TrialScreen kContractScreen{640, 480, 60};
constexpr int64_t kTicksPerFrame = 4;  // 240 a second, 60 frames

/// All that one sees of a moment, as text.
std::string textOf(const TrialLayout& layout) {
  std::string text = layout.prompt;
  const auto add = [&](double number) { text.append(",").append(std::to_string(std::bit_cast<uint64_t>(number))); };
  for (const glm::vec3& offset : layout.objectOffsets) {
    add(static_cast<double>(offset.x));
    add(static_cast<double>(offset.z));
  }
  for (const TrialLayout::View& view : layout.views) {
    add(view.place.left + 10000 * view.place.top + view.place.width + view.place.height);
    if (const auto* graph = std::get_if<GraphCamera>(&view.camera)) {
      for (const GraphCamera::Frustum& frustum : graph->frusta()) {
        for (int i = 0; i < 16; ++i) {
          add(frustum.pixelFromWorld[i / 4][i % 4]);
        }
      }
    } else {
      text += jsonText(std::get<PinholeCamera>(view.camera).view());
    }
  }
  for (const TrialLayout::PathMap& map : layout.maps) {
    for (const glm::dvec2& corner : map.corners) {
      add(corner.x);
      add(corner.y);
    }
  }
  for (const TrialLayout::Choice& choice : layout.choices) {
    text += choice.label + (choice.chosen ? "!" : "");
    add(choice.place.left);
  }
  if (layout.scale) {
    add(layout.scale->mark.value_or(-1));
  }
  if (layout.dial) {
    add(layout.dial->degrees.value_or(-1));
  }
  if (layout.pointer) {
    add(layout.pointer->x);
    add(layout.pointer->y);
  }
  return text;
}

/// Runs a trial to its end or for so many ticks; `input` is asked at each of them.
std::vector<std::string> follow(TrialRun& run, int64_t ticks, const std::function<void(int64_t tick)>& input,
                                int64_t imageEvery = 120) {
  std::vector<std::string> seen;
  for (int64_t tick = 0; tick < ticks && !run.outcome(); ++tick) {
    input(tick);
    if (tick % kTicksPerFrame == 0) {
      run.frameShown(tick);
    }
    if (tick % imageEvery == 0) {
      const WalkerPose pose = run.pose();
      seen.push_back(textOf(run.layout()) + std::to_string(pose.x) + std::to_string(pose.z) +
                     std::to_string(pose.headingRadians));
    }
    run.advance();
  }
  return seen;
}

int64_t longestTicks(const TaskBlock& block, const TrialPlan& plan) {
  return static_cast<int64_t>(
      std::ceil(block.caseInfo(plan.caseIndex).longestSeconds * static_cast<double>(kTicksPerSecond)));
}

/// A trial by the simulated observer of the row, one fixation of 0.3 s after the other.
TrialOutcome observed(const TaskKind& kind, const TaskBlock& block, const TrialPlan& plan) {
  constexpr TrialScreen kObserverScreen{240, 150, 60};
  constexpr int64_t kTick = 1'000'000'000 / kTicksPerSecond;
  constexpr int64_t kFixation = 300'000'000;
  const auto run = block.start(plan, kObserverScreen);
  const VisibilitySensor eye(kObserverScreen);
  const HumanFactors factors;
  const Vision vision(factors, 5);
  const Controls controls;
  MazeMemory memory;
  const auto policy = kind.policy({vision, controls, [&]() -> MazeMemory& { return memory; }, plan.seed});
  MotorModel motor(factors, controls, plan.seed);
  int64_t nextLook = 0;
  for (int64_t tick = 0; tick <= longestTicks(block, plan) && !run->outcome(); ++tick) {
    const int64_t now = tick * kTick;
    if (now >= nextLook) {
      nextLook = now + kFixation;
      policy->think(eye.look(run->layout(), policy->wantsFloor()), now, nextLook, motor);
    }
    for (const TimedInput& input : motor.take(now + kTick)) {
      run->handle(input.event);
    }
    if (tick % kTicksPerFrame == 0) {
      run->frameShown(tick);
    }
    run->advance();
  }
  EXPECT_TRUE(std::isfinite(policy->effort(1)));
  EXPECT_TRUE(run->outcome().has_value()) << kind.name;
  return run->outcome().value_or(TrialOutcome{});
}

class TaskContract : public testing::TestWithParam<TaskExample> {
 protected:
  void forEachTrial(const std::function<void(const TaskBlock& block, const TrialPlan& plan)>& visit) const {
    const auto block = test::readBlock(GetParam().task, GetParam().json);
    for (int i = 0; i < block->caseCount(); ++i) {
      for (const TrialView view : kViews) {
        visit(*block, test::planOf(GetParam().task, i, view, static_cast<uint64_t>(11 + i)));
      }
    }
  }
};

TEST_P(TaskContract, casesSayWhatTheyAre) {
  forEachTrial([&](const TaskBlock& block, const TrialPlan& plan) {
    const CaseInfo info = block.caseInfo(plan.caseIndex);
    EXPECT_FALSE(info.label.empty());
    EXPECT_EQ(info.moving, GetParam().json.find("moving") != std::string::npos);
    EXPECT_GT(info.typicalSeconds, 0);
    EXPECT_LE(info.typicalSeconds, info.longestSeconds);
    EXPECT_FALSE(block.answerOf(plan).empty());
    EXPECT_EQ(block.answerOf(plan), block.answerOf(plan));
  });
}

TEST_P(TaskContract, endsByItselfAndIsThenCensored) {
  forEachTrial([&](const TaskBlock& block, const TrialPlan& plan) {
    const auto run = block.start(plan, kContractScreen);
    follow(
        *run, longestTicks(block, plan), [](int64_t) {}, 1 << 20);
    ASSERT_TRUE(run->outcome().has_value());
    EXPECT_TRUE(run->outcome()->censored);
    EXPECT_FALSE(run->outcome()->correct);
    EXPECT_EQ(run->outcome()->answer, "");
    EXPECT_EQ(run->outcome()->expected, block.answerOf(plan));
  });
}

TEST_P(TaskContract, sameInputAtTheSameTicksGivesTheSameTrial) {
  forEachTrial([&](const TaskBlock& block, const TrialPlan& plan) {
    const auto once = [&] {
      const auto run = block.start(plan, kContractScreen);
      Random random(plan.seed);
      std::vector<std::string> seen = follow(
          *run, longestTicks(block, plan),
          [&](int64_t tick) {
            if (tick % 17 == 0) {
              run->handle(test::randomInput(random, kContractScreen));
            }
          },
          60);
      return std::pair(seen, run->outcome());
    };
    const auto first = once();
    EXPECT_FALSE(first.first.empty());
    EXPECT_TRUE(first == once());
  });
}

TEST_P(TaskContract, nothingHappensAfterTheOutcome) {
  forEachTrial([&](const TaskBlock& block, const TrialPlan& plan) {
    const auto run = block.start(plan, kContractScreen);
    follow(
        *run, longestTicks(block, plan), [](int64_t) {}, 1 << 20);
    const auto outcome = run->outcome();
    const std::string layout = textOf(run->layout());
    const WalkerPose pose = run->pose();
    Random random(3);
    for (int i = 0; i < 2000; ++i) {
      run->handle(test::randomInput(random, kContractScreen));
      run->advance();
      run->frameShown(i);
    }
    EXPECT_TRUE(run->outcome() == outcome);
    EXPECT_TRUE(run->pose() == pose);
    EXPECT_EQ(textOf(run->layout()), layout);
  });
}

TEST_P(TaskContract, imagesStayOnTheScreenBelowThePrompt) {
  forEachTrial([&](const TaskBlock& block, const TrialPlan& plan) {
    const auto run = block.start(plan, kContractScreen);
    const auto isOnStage = [](const PixelRect& place) {
      return place.left >= 0 && place.right() <= kContractScreen.width && place.top >= promptHeight(kContractScreen) &&
             place.bottom() <= kContractScreen.height && place.width > 10 && place.height > 10;
    };
    follow(
        *run, longestTicks(block, plan),
        [&](int64_t tick) {
          if (tick % 97 != 0) {
            return;
          }
          const TrialLayout layout = run->layout();
          EXPECT_FALSE(layout.prompt.empty());
          EXPECT_TRUE(!layout.views.empty() || !layout.choices.empty() || layout.scale || layout.dial);
          for (const TrialLayout::View& view : layout.views) {
            EXPECT_TRUE(isOnStage(view.place));
            const auto size =
                std::visit([](const auto& of) { return glm::dvec2(of.width(), of.height()); }, view.camera);
            EXPECT_EQ(size, glm::dvec2(view.place.width, view.place.height));
          }
          for (const TrialLayout::Choice& choice : layout.choices) {
            EXPECT_TRUE(isOnStage(choice.place));
          }
          for (const TrialLayout::PathMap& map : layout.maps) {
            EXPECT_TRUE(isOnStage(map.place));
          }
          EXPECT_TRUE(!layout.scale || isOnStage(layout.scale->place));
          EXPECT_TRUE(!layout.dial || isOnStage(layout.dial->place));
          ASSERT_NE(layout.scene, nullptr);
          EXPECT_LE(layout.objectOffsets.size(), layout.scene->objectCount());
        },
        1 << 20);
  });
}

TEST_P(TaskContract, anyInputIsBorne) {
  forEachTrial([&](const TaskBlock& block, const TrialPlan& plan) {
    Random random(plan.seed * 3 + static_cast<uint64_t>(plan.view));
    const auto run = block.start(plan, kContractScreen);
    follow(
        *run, longestTicks(block, plan), [&](int64_t) { run->handle(test::randomInput(random, kContractScreen)); }, 30);
    SUCCEED();
  });
}

TEST_P(TaskContract, theSimulatedObserverEndsEachTrialTheSameEachTime) {
  const TaskKind& kind = taskKind(GetParam().task, "test");
  forEachTrial([&](const TaskBlock& block, const TrialPlan& plan) {
    const TrialOutcome outcome = observed(kind, block, plan);
    EXPECT_EQ(outcome, observed(kind, block, plan));
    EXPECT_EQ(outcome.censored, outcome.answer.empty());
    if (kind.outcome != OutcomeKind::kTime) {
      EXPECT_FALSE(outcome.censored) << "it has time to answer";
    }
  });
}

TEST_P(TaskContract, answersMayBeRightOrWrong) {
  const TaskKind& kind = taskKind(GetParam().task, "test");
  forEachTrial([&](const TaskBlock& block, const TrialPlan& plan) {
    const auto first = block.start(plan, kContractScreen);
    const auto wait = [&](TrialRun& run) {
      follow(
          run, longestTicks(block, plan), [](int64_t) {}, 1 << 20);
    };
    // Of a task that takes time: to be done is right, and no time is wrong.
    if (kind.outcome == OutcomeKind::kTime) {
      wait(*first);
      EXPECT_FALSE(first->outcome()->correct);
      return;
    }
    // Of one that asks for a number: the truth is right, and what is far from it is not.
    const auto toTheQuestion = [&] {
      auto run = block.start(plan, kContractScreen);
      int64_t tick = 0;
      const auto asks = [&] {
        const TrialLayout layout = run->layout();
        return !layout.choices.empty() || layout.scale || layout.dial;
      };
      for (; !asks() && tick < longestTicks(block, plan); ++tick) {
        if (tick % kTicksPerFrame == 0) {
          run->frameShown(tick);
        }
        run->advance();
      }
      run->frameShown(tick);
      return run;
    };
    if (kind.outcome == OutcomeKind::kEstimate) {
      for (const bool isRight : {true, false}) {
        const auto run = toTheQuestion();
        const double truth = std::stod(block.answerOf(plan));
        run->handle(test::moveTo(test::placeOfAnswer(run->layout(), truth, isRight)));
        run->handle(test::button(PointerButton::kLeft, true));
        run->handle(test::button(PointerButton::kLeft, false));
        ASSERT_FALSE(run->outcome().has_value()) << "a mark is no answer yet";
        run->handle(test::press(Key::kEnter));
        ASSERT_TRUE(run->outcome().has_value());
        const TrialOutcome outcome = *run->outcome();
        EXPECT_EQ(outcome.correct, isRight);
        const std::optional<EstimatedValue> value = estimatedValue(outcome.measures);
        ASSERT_TRUE(value.has_value());
        EXPECT_EQ(value->unit, kind.generator.unit);
        EXPECT_EQ(outcome.answer, estimateText(value->estimate));
        EXPECT_EQ(outcome.expected, estimateText(value->truth));
        EXPECT_EQ(outcome.correct, std::abs(value->signedError()) <= kind.generator.rightWithin);
      }
      return;
    }
    // Of one that asks for a choice: one of them is right.
    const size_t choices = toTheQuestion()->layout().choices.size();
    EXPECT_GT(choices, 1u);
    int right = 0;
    for (size_t i = 0; i < choices; ++i) {
      const auto run = toTheQuestion();
      run->handle(test::press(run->layout().choices[i].key));
      ASSERT_TRUE(run->outcome().has_value());
      EXPECT_FALSE(run->outcome()->answer.empty());
      EXPECT_EQ(run->outcome()->correct, run->outcome()->answer == run->outcome()->expected);
      right += run->outcome()->correct ? 1 : 0;
    }
    EXPECT_EQ(right, 1);
  });
}

INSTANTIATE_TEST_SUITE_P(Tasks, TaskContract, testing::ValuesIn(test::taskExamples()),
                         [](const auto& example) { return example.param.name; });

}  // namespace
}  // namespace ocelli
