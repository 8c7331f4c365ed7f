#include "tests/study_export/exported_study.h"

#include "study/store/trial_store.h"

namespace ocelli::test {
namespace {

void storeForms(SessionSink& sink) {
  sink.consent({"Consent", "You may stop.", "abc", true, "2026-03-01T12:00:00.000Z"});
  sink.answer({"demographics", "age_band", kFormula, "2026-03-01T12:00:00.100Z"});
  sink.answer({"demographics", "age_band", "18-24, \"about\"", "2026-03-01T12:00:00.200Z"});
  sink.event({7, "2026-03-01T12:00:01.000Z", "note", kTypedNote});
  sink.event({8, "2026-03-01T12:00:02.000Z", "break", "begins"});
}

}  // namespace

void storeStudy(const std::filesystem::path& path) {
  const Protocol protocol = madeProtocol();
  StudyDatabase database = StudyDatabase::openForSessions(path, protocol);
  for (const char* subject : {"S01", "S02", "R1"}) {
    const SubjectKind kind = subject[0] == 'R' ? SubjectKind::kObserver : SubjectKind::kPerson;
    const SessionSchedule schedule = madeSchedule(database.addSubject(subject, kind).slot, 1, 2);
    TrialStore store(database, protocol, madeRun(subject, 1, kind), schedule);
    storeForms(store);
    int number = 0;
    if (std::string(subject) == "S01") {
      TrialPlan practice = schedule.trials[0];
      practice.practice = true;
      practice.index = -1;
      storeTrial(store, number++, madeTrial(practice, 1, 1), 3, 1);
      TrialRecord redone = madeTrial(schedule.trials[0], 1, 2);
      redone.ending = TrialEnding::kRedone;
      storeTrial(store, number++, redone, 3, 2);
      store.trialBegins(number++, schedule.trials[0], 2);
    }
    for (const TrialPlan& plan : schedule.trials) {
      storeTrial(store, number++, madeTrial(plan, plan.index == 0 ? 3 : 1, plan.index), 3, plan.index);
    }
    store.sessionEnds(SessionEnding::kCompleted, "2026-03-01T13:00:00.000Z");
  }
}

}  // namespace ocelli::test
