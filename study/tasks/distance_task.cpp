// How far: an object stands in sight, and one says how far it is from where one stands, in a straight line, on a scale
// in metres. Nobody walks.
//
// Not of the source, whose section 8 asks how well people estimate in the views of its cameras. Which way
// something is asks study/tasks/direction_task.cpp.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "oc_core/base/error.h"
#include "oc_core/base/json_fields.h"
#include "study/task/estimate_entry.h"
#include "study/task/task_fields.h"
#include "study/task/task_layout.h"
#include "study/tasks/estimate_policy.h"
#include "study/tasks/estimated_object.h"
#include "study/tasks/task_registry.h"
#include "study/trial/estimated_value.h"

namespace ocelli {
namespace {

constexpr double kTypicalDistanceSeconds = 6;
/// What a case is tried on when it is read.
constexpr TrialScreen kDistanceTrialScreen{640, 400, 60};
constexpr double kUsualRightShare = 0.2;

const EstimateUnit& metres() {
  static const EstimateUnit& unit = estimateUnit("m", "distance_task.cpp");
  return unit;
}

struct DistanceOptions {
  double answerLimitSeconds = 30;
  double scaleMeters = 30;
  double rightShare = kUsualRightShare;
};

/// The views lie above the scale and, at its right, the button.
struct DistanceStage {
  explicit DistanceStage(const TrialScreen& screen) {
    constexpr double kAnswerShare = 0.17;
    constexpr double kMargin = 0.15;  // of the height of what is below the views
    constexpr double kButtonShare = 0.16;
    const PixelRect stage = stageOf(screen);
    const double height = std::floor(kAnswerShare * stage.height);
    const double margin = std::floor(kMargin * height);
    view = {stage.left, stage.top, stage.width, stage.height - height};
    const double width = std::floor(kButtonShare * stage.width);
    button = {stage.right() - margin - width, view.bottom() + margin, width, height - 2 * margin};
    const double left = stage.left + 3 * margin;
    scale = {left, view.bottom(), button.left - 4 * margin - left, height};
  }

  PixelRect view;
  PixelRect scale;
  PixelRect button;
};

/// Between the numbers of a scale: 1, 2 or 5 times a power of ten, such that there are at most ten.
double niceStep(double range) {
  constexpr int kMaxNumbers = 10;
  const double power = std::pow(10, std::floor(std::log10(range / kMaxNumbers)));
  for (const double step : {1.0, 2.0, 5.0}) {
    if (range / (step * power) <= kMaxNumbers) {
      return step * power;
    }
  }
  return 10 * power;
}

class DistanceBlock : public TaskBlock {
 public:
  DistanceBlock(EstimatedObjects objects, const DistanceOptions& options)
      : objects_(std::move(objects)), options_(options) {}

  int caseCount() const override { return objects_.caseCount(); }
  CaseInfo caseInfo(int caseIndex) const override {
    CaseInfo info;
    info.label = objects_.caseOf(caseIndex).label;
    info.longestSeconds = options_.answerLimitSeconds;
    info.typicalSeconds = std::min(kTypicalDistanceSeconds, options_.answerLimitSeconds);
    return info;
  }
  bool isStill() const override { return true; }
  std::string answerOf(const TrialPlan& plan) const override { return estimateText(objects_.metersTo(plan.caseIndex)); }
  std::unique_ptr<TrialRun> start(const TrialPlan& plan, const TrialScreen& screen) const override;

  const EstimatedObjects& objects() const { return objects_; }
  const DistanceOptions& options() const { return options_; }

 private:
  EstimatedObjects objects_;
  DistanceOptions options_;
};

class DistanceRun : public TrialRun {
 public:
  DistanceRun(const DistanceBlock& block, const TrialPlan& plan, const DistanceStage& stage, const TrialScreen& screen)
      : block_(block),
        truth_(block.objects().metersTo(plan.caseIndex)),
        layout_(block.objects().layoutOf(plan.caseIndex, plan.view, stage.view)),
        pointer_(wholeScreen(screen), block.objects().controls()),
        entry_(scaleOf(block.options(), stage), stage.button) {
    layout_.prompt = "How far is the object from you?";
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
    if (entry_.handle(event, pointer_)) {
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
    entry_.advance();
    if (tick_ >= ticksOf(block_.options().answerLimitSeconds)) {
      finish(std::nullopt);
    }
  }
  void frameShown(int64_t /*tick*/) override {}

  TrialLayout layout() const override {
    TrialLayout layout = layout_;
    layout.tick = tick_;
    entry_.addTo(layout);
    layout.pointer = pointer_.place();
    return layout;
  }
  WalkerPose pose() const override { return block_.objects().start(); }
  std::optional<TrialOutcome> outcome() const override { return outcome_; }

 private:
  static TrialLayout::Scale scaleOf(const DistanceOptions& options, const DistanceStage& stage) {
    return {.place = stage.scale,
            .least = 0,
            .most = options.scaleMeters,
            .step = niceStep(options.scaleMeters),
            .unit = metres().name};
  }

  void finish(std::optional<double> estimate) {
    TrialOutcome outcome;
    outcome.expected = estimateText(truth_);
    outcome.censored = !estimate;
    outcome.responseTicks = tick_;
    if (estimate) {
      const EstimatedValue value{&metres(), *estimate, truth_};
      outcome.answer = estimateText(*estimate);
      outcome.correct = std::abs(value.signedError()) <= std::log1p(block_.options().rightShare);
      outcome.measures = measuresOf(value);
    }
    outcome_ = std::move(outcome);
  }

  const DistanceBlock& block_;
  double truth_;
  TrialLayout layout_;
  TaskPointer pointer_;
  EstimateEntry entry_;
  int64_t tick_ = 0;
  std::optional<TrialOutcome> outcome_{};
};

std::unique_ptr<TrialRun> DistanceBlock::start(const TrialPlan& plan, const TrialScreen& screen) const {
  return std::make_unique<DistanceRun>(*this, plan, DistanceStage(screen), screen);
}

std::shared_ptr<const TaskBlock> readDistanceTask(JsonFields& fields, const std::string& caseField,
                                                  const TaskSetting& setting) {
  DistanceOptions options;
  options.answerLimitSeconds = fields.number("answer_limit_seconds", 1, 3600, options.answerLimitSeconds);
  options.scaleMeters = fields.number("scale_meters", 1, 1000, options.scaleMeters);
  options.rightShare = fields.number("right_within", 0.01, 10, options.rightShare);
  EstimatedObjects objects(fields, caseField, setting);
  for (int i = 0; i < objects.caseCount(); ++i) {
    if (objects.metersTo(i) > options.scaleMeters) {
      throw InputError(fmt::format("the object is {:.2f} m away, beyond the scale of {:g} m", objects.metersTo(i),
                                   options.scaleMeters),
                       fmt::format("{}, case \"{}\"", fields.where(), objects.caseOf(i).label),
                       "let \"scale_meters\" be well above all distances, so that its end tells nothing of them");
    }
  }
  objects.checkShown(kDistanceTrialScreen, DistanceStage(kDistanceTrialScreen).view, fields.where());
  return std::make_shared<DistanceBlock>(std::move(objects), options);
}

std::unique_ptr<TaskPolicy> distancePolicy(const PolicySetting& setting) {
  return std::make_unique<EstimatePolicy>(EstimatePolicy::Asked::kMeters, setting);
}

}  // namespace

TaskKind distanceTask() {
  return {
      .name = "distance",
      .description = "say how far an object is, on a scale in metres",
      .outcome = OutcomeKind::kEstimate,
      .read = readDistanceTask,
      .policy = distancePolicy,
      .generator = {.effects = {{"error", -0.1, "log of estimate by truth with the reference in the first session",
                                 levelCovariate},
                                {kGraphEffect, 0.1, "the condition that is not the reference", graphCovariate},
                                {"session", 0, "each further session", sessionCovariate},
                                {kSubjectSd, 0.2, "between subjects"},
                                {kSubjectGraphSd, 0.05, "between subjects in the effect of the view"},
                                {kItemSd, 0.1, "between cases"},
                                {kItemViewSd, 0.05, "between cases in the effect of the view"},
                                {kResidualSd, 0.2, "from trial to trial"}},
                    .unit = &metres(),
                    .rightWithin = std::log1p(kUsualRightShare)},
      .images = {
          {"distance_ppc", true, [](const glm::ivec2& size) { return estimateExample(TrialView::kReference, size); }},
          {"distance_gc", true, [](const glm::ivec2& size) { return estimateExample(TrialView::kOther, size); }}}};
}

}  // namespace ocelli
