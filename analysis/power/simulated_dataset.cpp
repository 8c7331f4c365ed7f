#include "analysis/power/simulated_dataset.h"

#include <fmt/format.h>

#include "analysis/dataset/protocol_facts.h"
#include "oc_core/base/check.h"
#include "study/agent/chance.h"
#include "study/session/session_sink.h"
#include "study/store/program_version.h"
#include "study/subject/simulate_session.h"

namespace ocelli {
namespace {

/// Takes the records of one session as rows of the schema of trials (protocols/trials.schema.sql).
class DatasetSink : public SessionSink {
 public:
  DatasetSink(const Protocol& protocol, std::string subject, int session, Dataset& data)
      : protocol_(protocol), subject_(std::move(subject)), session_(session + 1), data_(data) {}

  void consent(const ConsentRecord& record) override {
    data_.consents.push_back({0, subject_, session_, record.agreed});
  }
  void answer(const AnswerRecord& record) override {
    const auto id = static_cast<int64_t>(data_.answers.size() + 1);
    data_.answers.push_back({0, id, subject_, session_, record.form, record.field, record.answer, true});
  }
  void trialBegins(int /*number*/, const TrialPlan& /*plan*/, int /*attempt*/) override {}
  void frames(int /*number*/, std::span<const FrameRecord> /*records*/) override {}
  void inputs(int /*number*/, std::span<const InputRecord> /*records*/) override {}
  void trialEnds(int number, const TrialRecord& record, std::function<void()> acknowledged) override;
  void event(const EventRecord& /*record*/) override {}
  void sessionEnds(SessionEnding ending, const std::string& utc) override;
  void flush() override {}
  std::optional<std::string> failure() const override { return std::nullopt; }

 private:
  const Protocol& protocol_;
  std::string subject_;
  int session_;
  Dataset& data_;
  int trials_ = 0;
};

void DatasetSink::trialEnds(int /*number*/, const TrialRecord& record, std::function<void()> /*acknowledged*/) {
  Trial& trial = data_.trials.emplace_back();
  trial.trialId = static_cast<int64_t>(data_.trials.size());
  trial.subject = subject_;
  trial.session = session_;
  trial.planIndex = record.plan.index;
  trial.blockIndex = record.plan.block;
  trial.block = protocol_.blocks[static_cast<size_t>(record.plan.block)].name;
  trial.task = record.plan.task;
  trial.caseIndex = record.plan.caseIndex;
  trial.caseLabel = record.info.label;
  trial.view = record.plan.view == TrialView::kOther ? TrialView::kOther : TrialView::kReference;
  trial.attempt = record.attempt;
  trial.simulated = true;
  trial.subjectKind = nameOf(SubjectKind::kGenerator);
  trial.moving = record.info.moving;
  trial.exposureSeconds = record.info.exposureSeconds;
  trial.objects = record.info.objects;
  trial.duplicateColors = record.info.duplicateColors;
  trial.longestSeconds = record.info.longestSeconds;
  trial.answer = record.outcome.answer;
  trial.expected = record.outcome.expected;
  trial.correct = record.outcome.correct;
  trial.censored = record.outcome.censored;
  trial.responseSeconds = static_cast<double>(record.outcome.responseTicks) / static_cast<double>(kTicksPerSecond);
  trial.measures = {record.outcome.measures.begin(), record.outcome.measures.end()};
  trial.frames = record.timing.frames;
  trial.droppedFrames = record.timing.dropped;
  trial.timingVerdict = record.timing.verdict;
  ++trials_;
}

void DatasetSink::sessionEnds(SessionEnding ending, const std::string& /*utc*/) {
  data_.sessions.push_back({0, subject_, session_, true, trials_, trials_, 1, nameOf(ending), false});
}

Dataset simulate(const Protocol& protocol, const SimulationPlan& plan, bool tellsAnswers) {
  OC_CHECK(plan.kind == SubjectKind::kGenerator, "observers are simulated into databases");
  Dataset data;
  DataSource source;
  source.path = "simulation";
  source.protocolName = protocol.name;
  source.protocolSha256 = protocol.sha256;
  source.protocolText = protocol.text;
  source.programVersion = programVersion();
  if (!source.protocolText.empty()) {
    data.conditions = protocolFacts(source.protocolText, source.path).conditions;
  }
  data.sources.push_back(std::move(source));
  for (size_t i = 0; i < plan.sessions.size(); ++i) {
    const auto slot = static_cast<int>(i);
    const uint64_t seed = seedOf(plan.seed, i);
    Subject subject;
    subject.id = fmt::format("{}{:04}", plan.idPrefix, i + 1);
    subject.kind = nameOf(plan.kind);
    subject.simulated = true;
    subject.slot = slot;
    data.subjects.push_back(subject);
    for (int session = 0; session < plan.sessions[i]; ++session) {
      const SessionSchedule schedule = scheduleOf(protocol, slot, session, seed);
      DatasetSink sink(protocol, subject.id, session, data);
      generateSession(protocol, {schedule, plan.effects, plan.seed, seed, tellsAnswers}, sink);
    }
  }
  return data;
}

}  // namespace

Dataset simulatedDataset(const Protocol& protocol, const SimulationPlan& plan) {
  return simulate(protocol, plan, true);
}

Dataset simulatedDatasetWithoutAnswers(const Protocol& protocol, const SimulationPlan& plan) {
  return simulate(protocol, plan, false);
}

}  // namespace ocelli
