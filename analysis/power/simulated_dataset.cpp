#include "analysis/power/simulated_dataset.h"

#include <fmt/format.h>

#include "analysis/dataset/protocol_facts.h"
#include "oc_core/base/check.h"
#include "study/agent/chance.h"
#include "study/session/session_sink.h"
#include "study/session/trial_rows.h"
#include "study/store/program_version.h"
#include "study/subject/simulate_session.h"

namespace ocelli {
namespace {

/// Takes the records of one session as rows of the schema of trials (protocols/trials.schema.sql).
class DatasetSink : public SessionSink {
 public:
  DatasetSink(const Protocol& protocol, RunRecord run, Dataset& data)
      : protocol_(protocol), run_(std::move(run)), data_(data) {}

  void consent(const ConsentRecord& record) override {
    data_.consents.push_back({0, run_.subject, run_.session, record.agreed});
  }
  void answer(const AnswerRecord& record) override {
    const auto id = static_cast<int64_t>(data_.answers.size() + 1);
    data_.answers.push_back({0, id, run_.subject, run_.session, record.form, record.field, record.answer, true});
  }
  void trialBegins(int /*number*/, const TrialPlan& /*plan*/, int /*attempt*/) override {}
  void frames(int /*number*/, std::span<const FrameRecord> /*records*/) override {}
  void inputs(int /*number*/, std::span<const InputRecord> /*records*/) override {}
  void gaze(int /*number*/, std::span<const GazeRecord> /*records*/) override {}
  void trialEnds(int number, const TrialRecord& record, std::function<void()> acknowledged) override;
  void event(const EventRecord& /*record*/) override {}
  void sessionEnds(SessionEnding ending, const std::string& utc) override;
  void flush() override {}
  std::optional<std::string> failure() const override { return std::nullopt; }

 private:
  const Protocol& protocol_;
  RunRecord run_;
  Dataset& data_;
  int trials_ = 0;
};

void DatasetSink::trialEnds(int number, const TrialRecord& record, std::function<void()> /*acknowledged*/) {
  Trial& trial = data_.trials.emplace_back(Trial{
      rowOf(run_, number, record.plan, record.attempt, protocol_.blocks[static_cast<size_t>(record.plan.block)].name)});
  trial.trialId = static_cast<int64_t>(data_.trials.size());
  addEnd(trial, record);
  ++trials_;
}

void DatasetSink::sessionEnds(SessionEnding ending, const std::string& /*utc*/) {
  data_.sessions.push_back({0, run_.subject, run_.session, true, trials_, trials_, 1, ending, false});
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
    subject.kind = plan.kind;
    subject.simulated = true;
    subject.slot = slot;
    data.subjects.push_back(subject);
    for (int session = 1; session <= plan.sessions[i]; ++session) {
      const SessionSchedule schedule = scheduleOf(protocol, slot, session, seed);
      RunRecord run;
      run.subject = subject.id;
      run.kind = plan.kind;
      run.slot = slot;
      run.session = session;
      DatasetSink sink(protocol, std::move(run), data);
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
