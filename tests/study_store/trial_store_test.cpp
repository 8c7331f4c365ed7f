// What goes into a database of a study comes out again; what was recorded stays.
#include "study/store/trial_store.h"

#include <SQLiteCpp/SQLiteCpp.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <thread>

#include "study/session/trial_rows.h"
#include "study/store/input_columns.h"
#include "tests/base/temporary_folder.h"
#include "tests/study_store/made_study.h"

namespace ocelli::test {
namespace {

using testing::HasSubstr;

class TrialStoreTest : public testing::Test {
 protected:
  /// Stores a whole session of `trials` trials a block and returns its schedule.
  SessionSchedule storeSession(StudyDatabase& database, const std::string& subject, SubjectKind kind, int trials) {
    const SessionSchedule schedule = madeSchedule(database.subject(subject)->slot, 1, trials);
    TrialStore store(database, protocol_, madeRun(subject, 1, kind), schedule);
    for (const TrialPlan& plan : schedule.trials) {
      storeTrial(store, plan.index, madeTrial(plan, 1, plan.index), 50, plan.index);
    }
    store.sessionEnds(SessionEnding::kCompleted, "2026-03-01T13:00:00.000Z");
    store.flush();
    EXPECT_EQ(store.failure(), std::nullopt);
    return schedule;
  }

  TemporaryFolder folder_;
  const std::filesystem::path file_ = folder_ / "study.db";
  const Protocol protocol_ = madeProtocol();
};

void expectSame(const TrialRecord& got, const TrialRecord& put) {
  EXPECT_EQ(got.plan, put.plan);
  EXPECT_EQ(got.attempt, put.attempt);
  EXPECT_EQ(got.info.label, put.info.label);
  EXPECT_EQ(got.info.moving, put.info.moving);
  EXPECT_EQ(got.info.exposureSeconds, put.info.exposureSeconds);
  EXPECT_EQ(got.info.objects, put.info.objects);
  EXPECT_EQ(got.info.duplicateColors, put.info.duplicateColors);
  EXPECT_EQ(got.info.longestSeconds, put.info.longestSeconds);
  EXPECT_EQ(got.info.typicalSeconds, put.info.typicalSeconds);
  EXPECT_EQ(got.screen, put.screen);
  EXPECT_EQ(got.startedNanoseconds, put.startedNanoseconds);
  EXPECT_EQ(got.endedNanoseconds, put.endedNanoseconds);
  EXPECT_EQ(got.startedUtc, put.startedUtc);
  EXPECT_EQ(got.endedUtc, put.endedUtc);
  EXPECT_EQ(got.ending, put.ending);
  EXPECT_EQ(got.outcome, put.outcome);
  EXPECT_EQ(got.timing.frames, put.timing.frames);
  EXPECT_EQ(got.timing.dropped, put.timing.dropped);
  EXPECT_EQ(got.timing.medianNanoseconds, put.timing.medianNanoseconds);
  EXPECT_EQ(got.timing.longestNanoseconds, put.timing.longestNanoseconds);
  EXPECT_EQ(got.timing.verdict, put.timing.verdict);
}

TEST_F(TrialStoreTest, GivesBackWhatASessionStored) {
  {
    StudyDatabase database = StudyDatabase::openForSessions(file_, protocol_);
    EXPECT_EQ(database.addSubject("S01", SubjectKind::kPerson).slot, 0);
    const SessionSchedule schedule = madeSchedule(0, 1, 2);
    TrialStore store(database, protocol_, madeRun("S01", 1), schedule);
    store.consent({"Consent", "You may stop.", "abc", true, "2026-03-01T12:00:00.500Z"});
    store.answer({"demographics", "age_band", "18-24", "2026-03-01T12:00:00.700Z"});
    store.event({5, "2026-03-01T12:00:00.800Z", "note", "a \"note\", with\nlines"});
    storeTrial(store, 0, madeTrial(schedule.trials[0], 1, 4), 70, 4);
    store.sessionEnds(SessionEnding::kUnwell, "2026-03-01T12:10:00.000Z");
  }
  const StudyDatabase database = StudyDatabase::openForReading(file_);
  EXPECT_EQ(database.study().protocolName, "made-up");
  EXPECT_EQ(database.study().protocolText, protocol_.text);
  EXPECT_EQ(database.study().protocolSha256, protocol_.sha256);
  ASSERT_EQ(database.subjects().size(), 1u);
  EXPECT_EQ(database.subjects()[0].id, "S01");

  const std::optional<StoredSession> session = database.session("S01", 1);
  ASSERT_TRUE(session);
  EXPECT_EQ(session->seed, 0xfedcba9876543210u);
  EXPECT_EQ(session->scheduleJson, jsonText(madeSchedule(0, 1, 2), defaultConditions()));
  EXPECT_EQ(session->plannedTrials, 4);
  EXPECT_EQ(session->completedTrials, 1);
  EXPECT_EQ(session->ending, SessionEnding::kUnwell);
  EXPECT_EQ(session->endedUtc, "2026-03-01T12:10:00.000Z");

  const std::vector<StoredRun> runs = database.runs("S01", 1);
  ASSERT_EQ(runs.size(), 1u);
  EXPECT_EQ(runs[0].record.environment, R"({"clock": "made up"})");
  EXPECT_EQ(runs[0].record.station, "station-1");
  EXPECT_EQ(runs[0].record.simulation, "");

  const std::vector<TrialRow> trials = database.trials("S01");
  ASSERT_EQ(trials.size(), 1u);
  EXPECT_TRUE(trials[0].ending);
  EXPECT_EQ(trials[0].block, "find stationary");
  expectSame(recordOf(trials[0]), madeTrial(madeSchedule(0, 1, 2).trials[0], 1, 4));
  EXPECT_EQ(database.frames(trials[0].trialId), madeFrames(0, 70, 4));

  const std::vector<InputRecord> inputs = database.inputs(trials[0].trialId);
  const std::vector<InputRecord> put = madeInputs();
  ASSERT_EQ(inputs.size(), put.size());
  for (size_t i = 0; i < put.size(); ++i) {
    EXPECT_EQ(inputs[i].nanoseconds, put[i].nanoseconds);
    EXPECT_EQ(inputs[i].tick, put[i].tick);
    const InputColumns got = columnsOf(inputs[i].event);
    const InputColumns want = columnsOf(put[i].event);
    EXPECT_EQ(std::tie(got.kind, got.what, got.pressed, got.modifiers, got.x, got.y, got.moreJson),
              std::tie(want.kind, want.what, want.pressed, want.modifiers, want.x, want.y, want.moreJson))
        << i;
  }
  EXPECT_EQ(std::get<KeyEvent>(inputs[0].event).key, Key::kW);
  EXPECT_TRUE(std::get<KeyEvent>(inputs[0].event).modifiers.alt);
  EXPECT_EQ(std::get<PointerMoveEvent>(inputs[3].event).y, -1e-9);
  EXPECT_EQ(std::get<TextEvent>(inputs[2].event).character, U'\u00e4');

  ASSERT_EQ(database.answers("S01").size(), 1u);
  EXPECT_EQ(database.answers("S01")[0].record.answer, "18-24");
  ASSERT_EQ(database.consents("S01").size(), 1u);
  EXPECT_TRUE(database.consents("S01")[0].record.agreed);
  ASSERT_EQ(database.events("S01").size(), 1u);
  EXPECT_EQ(database.events("S01")[0].record.detail, "a \"note\", with\nlines");
}

TEST_F(TrialStoreTest, AcknowledgesATrialOnceItIsInTheFile) {
  StudyDatabase database = StudyDatabase::openForSessions(file_, protocol_);
  database.addSubject("S01", SubjectKind::kPerson);
  const SessionSchedule schedule = madeSchedule(0, 1, 1);
  // Nothing but the end of the trial may make it store.
  TrialStore store(database, protocol_, madeRun("S01", 1), schedule, {3600});
  std::atomic<int> seen{-1};
  storeTrial(store, 0, madeTrial(schedule.trials[0], 1, 1), 90, 1, [&] {
    const StudyDatabase reader = StudyDatabase::openForReading(file_);
    seen = static_cast<int>(reader.frames(reader.trials("S01").at(0).trialId).size());
  });
  for (int wait = 0; wait < 1000 && seen < 0; ++wait) {
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
  }
  EXPECT_EQ(seen, 90);
}

TEST_F(TrialStoreTest, KeepsWhatWasSeenOfATrialThatNeverEnds) {
  StudyDatabase database = StudyDatabase::openForSessions(file_, protocol_);
  database.addSubject("S01", SubjectKind::kPerson);
  const SessionSchedule schedule = madeSchedule(0, 1, 1);
  TrialStore store(database, protocol_, madeRun("S01", 1), schedule, {0.01});
  store.trialBegins(0, schedule.trials[0], 1);
  store.frames(0, madeFrames(0, 30, 1));
  size_t frames = 0;
  for (int wait = 0; wait < 1000 && frames == 0; ++wait) {
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
    const std::vector<TrialRow> trials = database.trials("S01");
    frames = trials.empty() ? 0 : database.frames(trials[0].trialId).size();
  }
  EXPECT_EQ(frames, 30u);
  EXPECT_FALSE(database.trials("S01").at(0).ending);
}

TEST_F(TrialStoreTest, GoesOnAfterARecordThatContradictsOthers) {
  StudyDatabase database = StudyDatabase::openForSessions(file_, protocol_);
  database.addSubject("S01", SubjectKind::kPerson);
  const SessionSchedule schedule = madeSchedule(0, 1, 1);
  TrialStore store(database, protocol_, madeRun("S01", 1), schedule);
  std::atomic<int> acknowledged{0};
  store.trialBegins(0, schedule.trials[0], 1);
  store.frames(0, madeFrames(0, 30, 1));
  store.frames(0, madeFrames(29, 30, 1));  // frame 29 comes again
  store.frames(0, madeFrames(60, 30, 1));
  store.trialEnds(0, madeTrial(schedule.trials[0], 1, 1), [&] { ++acknowledged; });
  storeTrial(store, 1, madeTrial(schedule.trials[1], 1, 2), 20, 2, [&] { ++acknowledged; });
  store.flush();
  EXPECT_EQ(acknowledged, 2);
  EXPECT_THAT(store.failure().value_or(""), HasSubstr("a record cannot be stored"));
  const std::vector<TrialRow> trials = database.trials("S01");
  ASSERT_EQ(trials.size(), 2u);
  EXPECT_EQ(database.frames(trials[0].trialId).size(), 60u);
  EXPECT_EQ(database.frames(trials[1].trialId).size(), 20u);
  ASSERT_EQ(database.events("S01").size(), 1u);
  EXPECT_EQ(database.events("S01")[0].record.what, "record_refused");
}

TEST_F(TrialStoreTest, GoesOnAfterATrialThatCannotBegin) {
  StudyDatabase database = StudyDatabase::openForSessions(file_, protocol_);
  database.addSubject("S01", SubjectKind::kPerson);
  const SessionSchedule schedule = madeSchedule(0, 1, 1);
  TrialStore store(database, protocol_, madeRun("S01", 1), schedule);
  std::atomic<int> acknowledged{0};
  TrialRecord broken = madeTrial(schedule.trials[0], 0, 1);  // attempts count from 1
  storeTrial(store, 0, broken, 20, 1, [&] { ++acknowledged; });
  storeTrial(store, 1, madeTrial(schedule.trials[1], 1, 2), 20, 2, [&] { ++acknowledged; });
  store.flush();
  EXPECT_EQ(acknowledged, 1);
  EXPECT_THAT(store.failure().value_or(""), HasSubstr("a record cannot be stored"));
  const std::vector<TrialRow> trials = database.trials("S01");
  ASSERT_EQ(trials.size(), 1u);
  EXPECT_EQ(database.frames(trials[0].trialId).size(), 20u);
  ASSERT_EQ(database.events("S01").size(), 2u);  // its beginning and its end
  EXPECT_THAT(database.events("S01")[1].record.detail, HasSubstr("whose beginning was not stored"));
}

TEST_F(TrialStoreTest, GivesUpWhereNotEvenTheRefusalCanBeStored) {
  StudyDatabase database = StudyDatabase::openForSessions(file_, protocol_);
  database.addSubject("S01", SubjectKind::kPerson);
  const SessionSchedule schedule = madeSchedule(0, 1, 1);
  TrialStore store(database, protocol_, madeRun("S01", 1), schedule);
  {
    SQLite::Database raw(file_.string(), SQLite::OPEN_READWRITE);
    raw.exec("UPDATE withdrawal SET subject_id = 'S01'; DELETE FROM run; UPDATE withdrawal SET subject_id = NULL");
  }
  store.event({1, "", "note", "of nobody"});
  storeTrial(store, 0, madeTrial(schedule.trials[0], 1, 1), 20, 1);
  store.flush();  // comes back
  EXPECT_THAT(store.failure().value_or(""), HasSubstr("a record cannot be stored"));
  EXPECT_TRUE(database.trials("S01").empty());
}

TEST_F(TrialStoreTest, EndsARunOnce) {
  StudyDatabase database = StudyDatabase::openForSessions(file_, protocol_);
  database.addSubject("S01", SubjectKind::kPerson);
  TrialStore store(database, protocol_, madeRun("S01", 1), madeSchedule(0, 1, 1));
  store.sessionEnds(SessionEnding::kUnwell, "2026-03-01T12:10:00.000Z");
  store.sessionEnds(SessionEnding::kFailed, "2026-03-01T12:11:00.000Z");
  store.flush();
  EXPECT_EQ(store.failure(), std::nullopt);
  EXPECT_EQ(database.session("S01", 1)->ending, SessionEnding::kUnwell);
}

TEST_F(TrialStoreTest, MarksEveryRowOfSimulatedSubjects) {
  StudyDatabase database = StudyDatabase::openForSessions(file_, protocol_);
  database.addSubject("person", SubjectKind::kPerson);
  database.addSubject("robot", SubjectKind::kObserver);
  storeSession(database, "person", SubjectKind::kPerson, 1);
  storeSession(database, "robot", SubjectKind::kObserver, 1);
  SQLite::Database raw(file_.string(), SQLite::OPEN_READONLY);
  for (const char* table : {"session", "run", "trial"}) {
    const std::string query =
        std::string("SELECT count(*) FROM ") + table + " WHERE subject_id = 'robot' AND simulated = ";
    EXPECT_GT(raw.execAndGet(query + "1").getInt(), 0) << table;
    EXPECT_EQ(raw.execAndGet(query + "0").getInt(), 0) << table;
  }
  for (const char* table : {"frame", "input", "gaze"}) {
    const std::string query = std::string("SELECT count(*) FROM ") + table +
                              " JOIN trial USING (trial_id) WHERE subject_id = 'robot' AND " + table + ".simulated = ";
    EXPECT_GT(raw.execAndGet(query + "1").getInt(), 0) << table;
    EXPECT_EQ(raw.execAndGet(query + "0").getInt(), 0) << table;
  }
}

}  // namespace
}  // namespace ocelli::test
