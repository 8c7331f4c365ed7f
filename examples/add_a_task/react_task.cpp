#include "react_task.h"

#include <algorithm>
#include <variant>

#include "oc_core/base/json_fields.h"
#include "study/agent/chance.h"
#include "study/task/choice_list.h"
#include "study/task/task_fields.h"
#include "study/task/task_layout.h"

using namespace ocelli;

namespace {

constexpr const char* kPressed = "pressed";
constexpr const char* kTooEarly = "too early";

struct ReactCase {
  std::string label;
  double delaySeconds = 1;
};

/// What a block of a protocol says.
class ReactBlock final : public TaskBlock {
 public:
  ReactBlock(std::vector<ReactCase> cases, double limitSeconds)
      : cases_(std::move(cases)), limitSeconds_(limitSeconds) {}

  int caseCount() const override { return int(cases_.size()); }
  CaseInfo caseInfo(int caseIndex) const override {
    CaseInfo info;
    info.label = cases_.at(size_t(caseIndex)).label;
    info.longestSeconds = delaySeconds(caseIndex) + limitSeconds_;
    info.typicalSeconds = delaySeconds(caseIndex) + std::min(0.4, limitSeconds_);
    return info;
  }
  std::string answerOf(const TrialPlan&) const override { return kPressed; }
  std::unique_ptr<TrialRun> start(const TrialPlan& plan, const TrialScreen& screen) const override;

  double delaySeconds(int caseIndex) const { return cases_.at(size_t(caseIndex)).delaySeconds; }
  double limitSeconds() const { return limitSeconds_; }

 private:
  std::vector<ReactCase> cases_;
  double limitSeconds_;
};

/// One trial. Time passes in ticks, so that the same keys at the same ticks always give the same outcome.
class ReactRun final : public TrialRun {
 public:
  ReactRun(const ReactBlock& block, const TrialPlan& plan, const TrialScreen& screen)
      : appearsAt_(ticksOf(block.delaySeconds(plan.caseIndex))),
        endsAt_(appearsAt_ + ticksOf(block.limitSeconds())),
        answer_{buttonsIn(stageOf(screen), 1).front(), "Enter", Key::kEnter} {}

  void handle(const InputEvent& event) override {
    const auto* key = std::get_if<KeyEvent>(&event);
    if (!outcome_ && key != nullptr && key->pressed && key->key == answer_.key) {
      finish(hasAppeared() ? kPressed : kTooEarly);
    }
  }
  void advance() override {
    if (!outcome_ && ++tick_ >= endsAt_) {
      finish("");
    }
  }
  void frameShown(int64_t /*tick*/) override {}

  TrialLayout layout() const override {
    TrialLayout layout;
    layout.prompt = "Press Enter as soon as the button appears";
    if (hasAppeared()) {
      layout.choices.push_back(answer_);
    }
    return layout;
  }
  WalkerPose pose() const override { return {}; }
  std::optional<TrialOutcome> outcome() const override { return outcome_; }

 private:
  bool hasAppeared() const { return tick_ >= appearsAt_; }

  void finish(const std::string& answer) {
    const int64_t reaction = std::max<int64_t>(tick_ - appearsAt_, 0);
    outcome_ = TrialOutcome{.answer = answer,
                            .expected = kPressed,
                            .correct = answer == kPressed,
                            .censored = answer.empty(),
                            .responseTicks = tick_,
                            .measures = {{"reaction_s", double(reaction) / kTicksPerSecond}}};
  }

  const int64_t appearsAt_;
  const int64_t endsAt_;
  const TrialLayout::Choice answer_;
  int64_t tick_ = 0;
  std::optional<TrialOutcome> outcome_{};
};

std::unique_ptr<TrialRun> ReactBlock::start(const TrialPlan& plan, const TrialScreen& screen) const {
  return std::make_unique<ReactRun>(*this, plan, screen);
}

/// Fields that nothing here asks for are refused by the caller, with their names.
std::shared_ptr<const TaskBlock> readReactTask(JsonFields& fields, const std::string& caseField, const TaskSetting&) {
  const double limitSeconds = fields.number("answer_limit_seconds", 0.5, 60, 3);
  std::vector<ReactCase> cases;
  readCases(fields, caseField, [&](JsonFields& each, const std::string& label) {
    cases.push_back({label, each.number("delay_seconds", 0.1, 60)});
  });
  return std::make_shared<ReactBlock>(std::move(cases), limitSeconds);
}

/// What a simulated observer does: it looks, fixation after fixation, and presses the key once it has seen the button.
class ReactPolicy final : public TaskPolicy {
 public:
  explicit ReactPolicy(const PolicySetting& setting) : vision_(setting.vision), random_(setting.seed) {}

  bool wantsFloor() const override { return false; }
  double effort(double seconds) const override { return seconds; }
  double think(const Percept& seen, int64_t, int64_t now, MotorModel& motor) override {
    if (!hasPressed_ && !seen.choices.empty()) {
      const double seconds = vision_.factors().reactionSeconds * normalWithin(random_, 1, 0.2, 0.5, 2);
      motor.tap(seen.choices.front().key, now + nanosecondsOf(seconds));
      hasPressed_ = true;
    }
    return 0;
  }

 private:
  Vision vision_;
  Random random_;
  bool hasPressed_ = false;
};

std::unique_ptr<TaskPolicy> reactPolicy(const PolicySetting& setting) {
  return std::make_unique<ReactPolicy>(setting);
}

}  // namespace

TaskKind reactTask() {
  // `generator` is for subjects who are data alone (SubjectKind::kGenerator): log seconds, made up.
  return {.name = "react",
          .description = "press a key as soon as a button appears",
          .outcome = OutcomeKind::kTime,
          .read = readReactTask,
          .policy = reactPolicy,
          .generator = {
              .effects = {{"log_seconds", 0.4, "log seconds with the pinhole in the first session", levelCovariate},
                          {kGraphEffect, 0, "the graph camera", graphCovariate},
                          {"session", -0.05, "each further session", sessionCovariate},
                          {kSubjectSd, 0.15, "between subjects"},
                          {kItemSd, 0.1, "between cases"},
                          {kItemViewSd, 0, "between cases in the effect of the view"},
                          {kResidualSd, 0.2, "between trials"}}}};
}
