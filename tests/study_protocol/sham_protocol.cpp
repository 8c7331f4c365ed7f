#include "tests/study_protocol/sham_protocol.h"

#include <fmt/format.h>

namespace ocelli::test {
namespace {

class ShamTask : public TaskBlock {
 public:
  explicit ShamTask(int cases) : cases_(cases) {}
  int caseCount() const override { return cases_; }
  CaseInfo caseInfo(int caseIndex) const override {
    CaseInfo info;
    info.label = fmt::format("case {}", caseIndex + 1);
    info.typicalSeconds = 10;
    info.longestSeconds = 30;
    return info;
  }
  std::string answerOf(const TrialPlan& plan) const override { return fmt::format("answer {}", plan.caseIndex); }
  std::unique_ptr<TrialRun> start(const TrialPlan&, const TrialScreen&) const override { return nullptr; }

 private:
  int cases_;
};

}  // namespace

std::shared_ptr<const TaskBlock> shamTask(int cases) {
  return std::make_shared<ShamTask>(cases);
}

ProtocolBlock shamBlock(const std::string& name, int cases, TrialOrder order, ViewsOfCases views) {
  ProtocolBlock block;
  block.name = name;
  block.title = name;
  block.taskName = "sham";
  block.task = shamTask(cases);
  block.order = order;
  block.views = views;
  return block;
}

Protocol shamProtocol(std::vector<ProtocolBlock> blocks, bool shuffle, int sessions) {
  Protocol protocol;
  protocol.name = "sham";
  protocol.title = "Sham";
  protocol.sessions = sessions;
  protocol.shuffleBlocks = shuffle;
  protocol.blocks = std::move(blocks);
  return protocol;
}

}  // namespace ocelli::test
