#include "study/protocol/leveled_block.h"

#include "oc_core/base/check.h"

namespace ocelli {
namespace {

class LeveledRun : public TrialRun {
 public:
  LeveledRun(std::unique_ptr<TrialRun> run, double level) : run_(std::move(run)), level_(level) {}

  void handle(const InputEvent& event) override { run_->handle(event); }
  void advance() override { run_->advance(); }
  void frameShown(int64_t tick) override { run_->frameShown(tick); }
  TrialLayout layout() const override { return run_->layout(); }
  WalkerPose pose() const override { return run_->pose(); }
  std::optional<TrialOutcome> outcome() const override {
    std::optional<TrialOutcome> outcome = run_->outcome();
    if (outcome) {
      outcome->measures[kLevelMeasure] = level_;
    }
    return outcome;
  }

 private:
  std::unique_ptr<TrialRun> run_;
  double level_;
};

class LeveledBlock : public TaskBlock {
 public:
  LeveledBlock(std::shared_ptr<const TaskBlock> task, std::vector<double> levels)
      : task_(std::move(task)), levels_(std::move(levels)) {
    OC_CHECK(static_cast<int>(levels_.size()) == task_->caseCount(), "each case has a level");
  }

  int caseCount() const override { return task_->caseCount(); }
  CaseInfo caseInfo(int caseIndex) const override {
    CaseInfo info = task_->caseInfo(caseIndex);
    info.level = levels_.at(static_cast<size_t>(caseIndex));
    return info;
  }
  std::string answerOf(const TrialPlan& plan) const override { return task_->answerOf(plan); }
  int choiceCount() const override { return task_->choiceCount(); }
  std::unique_ptr<TrialRun> start(const TrialPlan& plan, const TrialScreen& screen) const override {
    return std::make_unique<LeveledRun>(task_->start(plan, screen), levels_.at(static_cast<size_t>(plan.caseIndex)));
  }

 private:
  std::shared_ptr<const TaskBlock> task_;
  std::vector<double> levels_;
};

}  // namespace

std::shared_ptr<const TaskBlock> leveledBlock(std::shared_ptr<const TaskBlock> task, std::vector<double> levels) {
  return std::make_shared<LeveledBlock>(std::move(task), std::move(levels));
}

}  // namespace ocelli
