// Which way: an object is seen, and one points to where it really stands, on a dial that shows what is around one from
// above. Nobody walks. The object shows while one points, or for a while before (an exposure): then one points from
// memory, with nothing in sight that one could lay the dial along.
//
// Not of the source. A camera whose rays bend shows things elsewhere than where they are: what that does to knowing
// where things are is what views of such cameras are suspected of.
#include <algorithm>
#include <cmath>

#include "oc_core/base/json_fields.h"
#include "study/task/estimate_entry.h"
#include "study/task/exposure.h"
#include "study/task/task_fields.h"
#include "study/task/task_layout.h"
#include "study/tasks/estimate_policy.h"
#include "study/tasks/estimated_object.h"
#include "study/tasks/task_registry.h"
#include "study/trial/estimated_value.h"

namespace ocelli {
namespace {

constexpr double kTypicalPointingSeconds = 5;
/// What a case is tried on when it is read.
constexpr TrialScreen kDirectionTrialScreen{640, 400, 60};
constexpr double kUsualRightDegrees = 15;

const EstimateUnit& degreesOfTurn() {
  static const EstimateUnit& unit = estimateUnit("degrees", "direction_task.cpp");
  return unit;
}

struct DirectionOptions {
  double answerLimitSeconds = 30;
  std::optional<double> exposureSeconds{};  ///< nothing: the scene shows until the answer
  double rightDegrees = kUsualRightDegrees;
};

/// With an exposure the views take all of the stage, and the dial comes after them; else the dial stands beside them.
struct DirectionStage {
  DirectionStage(const TrialScreen& screen, bool isExposed) {
    constexpr double kBesideShare = 0.25;  // of the width
    constexpr double kMargin = 0.04;       // of the width of what the dial stands in
    constexpr double kMaxDial = 0.65;      // of the height
    constexpr double kButtonHeight = 0.11;
    constexpr double kButtonWidth = 0.16;
    const PixelRect stage = stageOf(screen);
    const double width = isExposed ? stage.width : std::floor(kBesideShare * stage.width);
    view = {stage.left, stage.top, isExposed ? stage.width : stage.width - width, stage.height};
    const double left = stage.right() - width;
    const double side = std::min(std::floor(width * (1 - 2 * kMargin)), std::floor(kMaxDial * stage.height));
    const double height = std::floor(kButtonHeight * stage.height);
    const double space = std::floor(height / 2);
    dial = {left + std::floor((width - side) / 2), stage.top + std::floor((stage.height - side - height - space) / 2),
            side, side};
    const double across = std::floor(kButtonWidth * stage.width);
    button = {left + std::floor((width - across) / 2), dial.bottom() + space, across, height};
  }

  PixelRect view;
  PixelRect dial;
  PixelRect button;
};

class DirectionBlock : public TaskBlock {
 public:
  DirectionBlock(EstimatedObjects objects, const DirectionOptions& options)
      : objects_(std::move(objects)), options_(options) {}

  int caseCount() const override { return objects_.caseCount(); }
  CaseInfo caseInfo(int caseIndex) const override {
    CaseInfo info;
    info.label = objects_.caseOf(caseIndex).label;
    info.exposureSeconds = options_.exposureSeconds;
    const double exposure = options_.exposureSeconds.value_or(0);
    info.longestSeconds = exposure + options_.answerLimitSeconds;
    info.typicalSeconds = exposure + std::min(kTypicalPointingSeconds, options_.answerLimitSeconds);
    return info;
  }
  bool isStill() const override { return true; }
  std::string answerOf(const TrialPlan& plan) const override { return estimateText(truthOf(plan.caseIndex)); }
  std::unique_ptr<TrialRun> start(const TrialPlan& plan, const TrialScreen& screen) const override;

  const EstimatedObjects& objects() const { return objects_; }
  const DirectionOptions& options() const { return options_; }
  /// As it is stored, so that a truth just below a whole turn is not rounded to one.
  double truthOf(int caseIndex) const {
    constexpr double kParts = 1e4;
    return std::fmod(std::round(objects_.degreesTo(caseIndex) * kParts) / kParts, kDegreesOfTurn);
  }

 private:
  EstimatedObjects objects_;
  DirectionOptions options_;
};

class DirectionRun : public TrialRun {
 public:
  DirectionRun(const DirectionBlock& block, const TrialPlan& plan, const DirectionStage& stage,
               const TrialScreen& screen)
      : block_(block),
        truth_(block.truthOf(plan.caseIndex)),
        layout_(block.objects().layoutOf(plan.caseIndex, plan.view, stage.view)),
        pointer_(wholeScreen(screen), block.objects().controls()),
        entry_(TrialLayout::Dial{stage.dial}, stage.button) {
    if (block.options().exposureSeconds) {
      exposure_.emplace(plan.exposure, *block.options().exposureSeconds, screen.refreshHertz);
    } else {
      askedAt_ = 0;
    }
  }

  void handle(const InputEvent& event) override {
    if (outcome_) {
      return;
    }
    // A drag is where the pointer has come to; a click is one before its key counts as held.
    const bool moves = std::holds_alternative<PointerMoveEvent>(event);
    if (moves) {
      pointer_.handle(event);
    }
    if (askedAt_ && entry_.handle(event, pointer_)) {
      finish(entry_.value());
    } else if (!moves) {
      pointer_.handle(event);
    }
  }
  void advance() override {
    if (outcome_) {
      return;
    }
    ++tick_;
    pointer_.advance();
    if (askedAt_) {
      entry_.advance();
      if (tick_ - *askedAt_ >= ticksOf(block_.options().answerLimitSeconds)) {
        finish(std::nullopt);
      }
    }
  }
  void frameShown(int64_t tick) override {
    if (!exposure_) {
      return;
    }
    if (!isShowingAlone() && !askedAt_) {
      askedAt_ = tick_;
    }
    exposure_->frameShown(tick);
  }

  TrialLayout layout() const override {
    if (isShowingAlone()) {
      TrialLayout layout = layout_;
      layout.tick = tick_;
      layout.prompt = "Look where the object is";
      return layout;
    }
    TrialLayout layout;
    layout.scene = layout_.scene;
    if (!exposure_) {
      layout = layout_;
      layout.tick = tick_;
    }
    layout.targetObject = 0;
    layout.prompt = "Point to where this is";
    entry_.addTo(layout);
    layout.pointer = pointer_.place();
    return layout;
  }
  WalkerPose pose() const override { return block_.objects().start(); }
  std::optional<TrialOutcome> outcome() const override { return outcome_; }

 private:
  /// The scene, and nothing to answer on yet.
  bool isShowingAlone() const { return exposure_ && !exposure_->isOver(); }

  void finish(std::optional<double> estimate) {
    TrialOutcome outcome;
    outcome.expected = estimateText(truth_);
    outcome.censored = !estimate;
    outcome.responseTicks = tick_ - *askedAt_;
    if (exposure_) {
      outcome.exposureFrames = exposure_->frames();
      outcome.exposureTicks = exposure_->shownTicks();
    }
    if (estimate) {
      const EstimatedValue value{&degreesOfTurn(), *estimate, truth_};
      outcome.answer = estimateText(*estimate);
      outcome.correct = std::abs(value.signedError()) <= block_.options().rightDegrees;
      outcome.measures = measuresOf(value);
    }
    outcome_ = std::move(outcome);
  }

  const DirectionBlock& block_;
  double truth_;
  TrialLayout layout_;  ///< while the scene shows
  std::optional<Exposure> exposure_{};
  TaskPointer pointer_;
  EstimateEntry entry_;
  int64_t tick_ = 0;
  std::optional<int64_t> askedAt_{};  ///< tick of the first frame with the dial
  std::optional<TrialOutcome> outcome_{};
};

std::unique_ptr<TrialRun> DirectionBlock::start(const TrialPlan& plan, const TrialScreen& screen) const {
  return std::make_unique<DirectionRun>(*this, plan, DirectionStage(screen, options_.exposureSeconds.has_value()),
                                        screen);
}

std::shared_ptr<const TaskBlock> readDirectionTask(JsonFields& fields, const std::string& caseField,
                                                   const TaskSetting& setting) {
  DirectionOptions options;
  options.answerLimitSeconds = fields.number("answer_limit_seconds", 1, 3600, options.answerLimitSeconds);
  if (fields.has("exposure_seconds")) {
    options.exposureSeconds = fields.number("exposure_seconds", 0.05, 600);
  }
  options.rightDegrees = fields.number("right_within", 0.1, 180, options.rightDegrees);
  EstimatedObjects objects(fields, caseField, setting);
  const DirectionStage stage(kDirectionTrialScreen, options.exposureSeconds.has_value());
  objects.checkShown(kDirectionTrialScreen, stage.view, fields.where());
  return std::make_shared<DirectionBlock>(std::move(objects), options);
}

std::unique_ptr<TaskPolicy> directionPolicy(const PolicySetting& setting) {
  return std::make_unique<EstimatePolicy>(EstimatePolicy::Asked::kDegrees, setting);
}

}  // namespace

TaskKind directionTask() {
  return {
      .name = "direction",
      .description = "point to where an object is, on a dial seen from above",
      .outcome = OutcomeKind::kEstimate,
      .read = readDirectionTask,
      .policy = directionPolicy,
      .generator = {.effects = {{"error", 0, "degrees clockwise of the truth with the reference in the first session",
                                 levelCovariate},
                                {kGraphEffect, 5, "the condition that is not the reference", graphCovariate},
                                {"session", 0, "each further session", sessionCovariate},
                                {kSubjectSd, 4, "between subjects"},
                                {kSubjectGraphSd, 3, "between subjects in the effect of the view"},
                                {kItemSd, 5, "between cases"},
                                {kItemViewSd, 4, "between cases in the effect of the view"},
                                {kResidualSd, 12, "from trial to trial"}},
                    .unit = &degreesOfTurn(),
                    .rightWithin = kUsualRightDegrees},
      .images = {
          {"direction_ppc", true, [](const glm::ivec2& size) { return estimateExample(TrialView::kReference, size); }},
          {"direction_gc", true, [](const glm::ivec2& size) { return estimateExample(TrialView::kOther, size); }}}};
}

}  // namespace ocelli
