// Databases of several stations become one.
#include "study/store/merge.h"

#include <SQLiteCpp/SQLiteCpp.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <regex>

#include "oc_core/base/error.h"
#include "study/store/trial_store.h"
#include "study/store/withdraw.h"
#include "tests/base/temporary_folder.h"
#include "tests/study_store/made_study.h"
#include "tests/study_store/study_checks.h"

namespace ocelli::test {
namespace {

using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::Not;

/// A subject whose id is so long that no name of a temporary folder, which databases hold too, has it by chance.
constexpr const char* kLeaver = "leaver-of-studies";

class MergeTest : public testing::Test {
 protected:
  /// One session of a subject, who is added where that is needed.
  void store(const std::string& file, const std::string& subject, int session = 1,
             SubjectKind kind = SubjectKind::kPerson, const Protocol& protocol = madeProtocol()) const {
    StudyDatabase database = StudyDatabase::openForSessions(folder_ / file, protocol);
    if (!database.subject(subject)) {
      database.addSubject(subject, kind);
    }
    const SessionSchedule schedule = madeSchedule(0, session, 2);
    TrialStore store(database, protocol, madeRun(subject, session, kind), schedule);
    store.consent({"Consent", "", "", true, ""});
    store.answer({"demographics", "age_band", subject, ""});
    store.event({1, "", "note", subject});
    for (const TrialPlan& plan : schedule.trials) {
      storeTrial(store, plan.index, madeTrial(plan, 1, plan.index), 40, plan.index + saltOf(subject));
    }
    store.sessionEnds(SessionEnding::kCompleted, "2026-03-01T13:00:00.000Z");
  }
  static int saltOf(const std::string& subject) { return subject.back(); }
  MergeReport merge(const std::vector<std::string>& sources) const {
    std::vector<std::filesystem::path> paths;
    for (const std::string& source : sources) {
      paths.push_back(folder_ / source);
    }
    return mergeDatabases(target_, paths);
  }
  /// All rows of the tables of subjects, as text.
  static std::string contents(const std::filesystem::path& file) {
    std::string text;
    SQLite::Database database(file.string());
    for (const char* table :
         {"subject", "session", "run", "consent", "answer", "event", "trial", "frame", "input", "gaze"}) {
      SQLite::Statement row(database, std::string("SELECT * FROM ") + table);
      while (row.executeStep()) {
        for (int i = 0; i < row.getColumnCount(); ++i) {
          text += row.getColumn(i).getString() + "|";
        }
        text += "\n";
      }
    }
    return text;
  }

  TemporaryFolder folder_;
  const std::filesystem::path target_ = folder_ / "all.db";
};

TEST_F(MergeTest, BringsAllSubjectsWithAllTheyDid) {
  store("one.db", "A1");
  store("one.db", "A2");
  store("a %41 #strange? name.db", "B1");
  store("a %41 #strange? name.db", "R1", 1, SubjectKind::kObserver);
  const MergeReport report = merge({"one.db", "a %41 #strange? name.db"});
  EXPECT_EQ(report.subjects, 4);
  EXPECT_EQ(report.runs, 4);
  EXPECT_EQ(report.trials, 16);
  EXPECT_EQ(report.knownSubjects, 0);

  const StudyDatabase database = StudyDatabase::openForReading(target_);
  EXPECT_EQ(database.study().protocolText, madeProtocol().text);
  for (const char* subject : {"A1", "A2", "B1", "R1"}) {
    EXPECT_EQ(database.subject(subject)->kind,
              subject == std::string("R1") ? SubjectKind::kObserver : SubjectKind::kPerson);
    ASSERT_EQ(database.answers(subject).size(), 1u);
    EXPECT_EQ(database.answers(subject)[0].record.answer, subject);
    EXPECT_EQ(database.events(subject).size(), 1u);
    EXPECT_EQ(database.consents(subject).size(), 1u);
    EXPECT_EQ(database.session(subject, 1)->completedTrials, 4);
    const std::vector<TrialRow> trials = database.trials(subject);
    ASSERT_EQ(trials.size(), 4u);
    for (const TrialRow& trial : trials) {
      EXPECT_EQ(database.frames(trial.trialId), madeFrames(0, 40, trial.trialNumber + saltOf(subject)));
      EXPECT_EQ(database.inputs(trial.trialId).size(), madeInputs().size());
      EXPECT_EQ(database.gaze(trial.trialId), madeGaze());
    }
  }
  SQLite::Database raw(target_.string());
  EXPECT_EQ(raw.execAndGet("SELECT count(*) FROM frame WHERE simulated = 1").getInt(), 4 * 40);
  EXPECT_EQ(raw.execAndGet("SELECT count(*) FROM final_trial").getInt(), 16);
  EXPECT_FALSE(SQLite::Statement(raw, "PRAGMA foreign_key_check").executeStep());
  // Both stations began with slot 0.
  EXPECT_THAT(slotUse(target_, false), ElementsAre(2, 1));
  EXPECT_THAT(slotUse(target_, true), ElementsAre(1));
}

TEST_F(MergeTest, LeavesSourcesAsTheyAre) {
  store("one.db", "A1");
  const std::string before = fileBytes(folder_ / "one.db");
  merge({"one.db"});
  EXPECT_EQ(fileBytes(folder_ / "one.db"), before);
  size_t files = 0;
  for ([[maybe_unused]] const auto& entry : std::filesystem::directory_iterator(folder_.path())) {
    ++files;
  }
  EXPECT_EQ(files, 2u);  // one.db and all.db, without logs and locks
}

TEST_F(MergeTest, DoesNothingTheSecondTime) {
  store("one.db", "A1");
  store("two.db", "B1");
  merge({"one.db", "two.db"});
  const std::string before = contents(target_);
  const size_t audit = StudyDatabase::openForReading(target_).audit().size();
  const MergeReport report = merge({"one.db", "two.db"});
  EXPECT_EQ(report.subjects, 0);
  EXPECT_EQ(report.runs, 0);
  EXPECT_EQ(report.knownSubjects, 2);
  EXPECT_TRUE(contents(target_) == before);
  EXPECT_EQ(StudyDatabase::openForReading(target_).audit().size(), audit);
}

TEST_F(MergeTest, AddsWhatHasComeSince) {
  store("one.db", "A1");
  merge({"one.db"});
  store("one.db", "A1", 2);
  store("one.db", "A2");
  const MergeReport report = merge({"one.db"});
  EXPECT_EQ(report.subjects, 1);
  EXPECT_EQ(report.runs, 2);
  EXPECT_TRUE(contents(target_) == contents(folder_ / "one.db"));
}

TEST_F(MergeTest, CompletesRunsOfWhichItHasACopyMadeMeanwhile) {
  store("one.db", "A0");
  {
    StudyDatabase database = StudyDatabase::openForSessions(folder_ / "one.db", madeProtocol());
    database.addSubject("A1", SubjectKind::kPerson);
    const SessionSchedule schedule = madeSchedule(0, 1, 2);
    TrialStore store(database, madeProtocol(), madeRun("A1", 1), schedule);
    store.consent({"Consent", "", "", true, ""});
    store.event({1, "", "note", "same"});
    storeTrial(store, 0, madeTrial(schedule.trials[0], 1, 0), 40, 0);
    store.trialBegins(1, schedule.trials[1], 1);
    store.frames(1, madeFrames(0, 30, 1));
    const std::vector<InputRecord> inputs = madeInputs();
    store.inputs(1, std::span(inputs).first(2));
    const std::vector<GazeRecord> gaze = madeGaze();
    store.gaze(1, std::span(gaze).first(1));
    store.flush();
    SQLite::Database((folder_ / "one.db").string()).exec("VACUUM INTO '" + (folder_ / "copy.db").string() + "'");
    store.frames(1, madeFrames(30, 30, 1));
    store.inputs(1, std::span(inputs).subspan(2));
    store.gaze(1, std::span(gaze).subspan(1));
    store.trialEnds(1, madeTrial(schedule.trials[1], 1, 1));
    storeTrial(store, 2, madeTrial(schedule.trials[2], 1, 2), 40, 2);
    store.event({2, "", "note", "same"});
    store.event({3, "", "note", "last"});
    store.answer({"survey", "easier", "1", ""});
    store.sessionEnds(SessionEnding::kAborted, "2026-03-01T13:00:00.000Z");
  }
  merge({"copy.db"});
  EXPECT_FALSE(StudyDatabase::openForReading(target_).session("A1", 1)->ending);
  const MergeReport report = merge({"one.db"});
  EXPECT_EQ(report.runs, 0);
  EXPECT_EQ(report.runsThatWentOn, 1);
  EXPECT_EQ(report.trials, 1);
  EXPECT_TRUE(contents(target_) == contents(folder_ / "one.db"));
  EXPECT_EQ(StudyDatabase::openForReading(target_).session("A1", 1)->ending, SessionEnding::kAborted);
  EXPECT_EQ(merge({"one.db", "copy.db"}).runsThatWentOn, 0);
  EXPECT_TRUE(contents(target_) == contents(folder_ / "one.db"));
}

TEST_F(MergeTest, LeavesOutWhoWithdrew) {
  store("one.db", kLeaver);
  store("one.db", "A2");
  merge({"one.db"});
  withdrawSubject(target_, kLeaver, {});
  const MergeReport report = merge({"one.db"});
  EXPECT_EQ(report.subjects, 0);
  EXPECT_EQ(report.runs, 0);
  EXPECT_THAT(report.withdrawnSubjects, ElementsAre(kLeaver));
  EXPECT_THAT(fileBytes(target_), Not(HasSubstr(kLeaver)));
  EXPECT_EQ(StudyDatabase::openForReading(target_).subjects().size(), 1u);
  // The id is free for someone else.
  store("two.db", kLeaver);
  EXPECT_EQ(merge({"one.db", "two.db"}).subjects, 1);
  EXPECT_EQ(StudyDatabase::openForReading(target_).subjects().size(), 2u);
}

TEST_F(MergeTest, LeavesOutWhoWithdrewFromAnotherSourceAndRemembersIt) {
  store("one.db", kLeaver);
  store("one.db", "A2");
  mergeDatabases(folder_ / "copy.db", {folder_ / "one.db"});
  withdrawSubject(folder_ / "one.db", kLeaver, {});
  const MergeReport report = merge({"copy.db", "one.db"});
  EXPECT_EQ(report.subjects, 1);
  EXPECT_THAT(report.withdrawnSubjects, ElementsAre(kLeaver));
  EXPECT_THAT(fileBytes(target_), Not(HasSubstr(kLeaver)));
  // Also when the copy comes alone.
  EXPECT_THAT(merge({"copy.db"}).withdrawnSubjects, ElementsAre(kLeaver));
  EXPECT_EQ(StudyDatabase::openForReading(target_).subjects().size(), 1u);
}

TEST_F(MergeTest, TellsOfSubjectsOfTheTargetWhoWithdrewFromASource) {
  store("one.db", "A1");
  store("one.db", "A2");
  EXPECT_TRUE(merge({"one.db"}).withdrewElsewhere.empty());
  withdrawSubject(folder_ / "one.db", "A1", {});
  const MergeReport report = merge({"one.db"});
  EXPECT_THAT(report.withdrewElsewhere, ElementsAre("A1"));
  EXPECT_TRUE(report.withdrawnSubjects.empty());
  EXPECT_EQ(StudyDatabase::openForReading(target_).subjects().size(), 2u) << "only a withdrawal deletes";
}

TEST_F(MergeTest, TellsOfItInTheAuditTrail) {
  store("one.db", "A1");
  merge({"one.db"});
  const std::vector<AuditEntry> audit = StudyDatabase::openForReading(target_).audit();
  ASSERT_EQ(audit.size(), 2u);
  EXPECT_EQ(audit[1].action, "merged");
  // The name of the folder is random and may hold anything.
  const std::string detail = std::regex_replace(audit[1].detailJson, std::regex("\"source\":\"[^\"]*/"), "");
  EXPECT_THAT(detail, AllOf(HasSubstr("one.db"), HasSubstr("\"trials\":4"), Not(HasSubstr("A1"))));
}

TEST_F(MergeTest, RefusesIdsThatStandForDifferentPeopleAndListsThem) {
  store("one.db", "A1");
  store("one.db", "A2");
  store("two.db", "A2");
  store("two.db", "A3");
  store("three.db", "A3");
  EXPECT_THAT(messageOf<InputError>([&] { merge({"one.db", "two.db", "three.db"}); }), HasSubstr("subjects: A2, A3\n"));
  EXPECT_FALSE(std::filesystem::exists(target_));
  merge({"one.db"});
  const std::string before = contents(target_);
  EXPECT_THAT(messageOf<InputError>([&] { merge({"two.db"}); }), HasSubstr("subjects: A2\n"));
  EXPECT_TRUE(contents(target_) == before);
}

TEST_F(MergeTest, RefusesCopiesThatWentOnApart) {
  store("one.db", "A1");
  std::filesystem::copy_file(folder_ / "one.db", folder_ / "two.db");
  store("one.db", "A1", 2);
  EXPECT_EQ(merge({"one.db", "two.db"}).runs, 2);  // a copy that stood still is no conflict
  store("two.db", "A1", 2);
  EXPECT_THAT(messageOf<InputError>([&] { merge({"two.db"}); }), HasSubstr("subjects: A1\n"));
}

TEST_F(MergeTest, RefusesAnotherProtocolARunningSessionAndItself) {
  store("one.db", "A1");
  store("other.db", "B1", 1, SubjectKind::kPerson, madeProtocol("other"));
  EXPECT_THAT(messageOf<InputError>([&] { merge({"one.db", "other.db"}); }), HasSubstr("another protocol"));
  EXPECT_FALSE(std::filesystem::exists(target_));
  {
    const StudyDatabase running = StudyDatabase::openForSessions(folder_ / "one.db", madeProtocol());
    EXPECT_THAT(messageOf<WorkError>([&] { merge({"one.db"}); }), HasSubstr("runs sessions"));
  }
  EXPECT_THAT(messageOf<InputError>([&] { mergeDatabases(folder_ / "one.db", {folder_ / "one.db"}); }),
              HasSubstr("into itself"));
  EXPECT_THAT(messageOf<InputError>([&] { merge({"none.db"}); }), HasSubstr("there is no such file"));
  merge({"one.db"});
}

TEST_F(MergeTest, CanBeFollowedByAWithdrawal) {
  store("one.db", kLeaver);
  store("two.db", "B1");
  merge({"one.db", "two.db"});
  withdrawSubject(target_, kLeaver, {});
  EXPECT_THAT(fileBytes(target_), Not(HasSubstr(kLeaver)));
  EXPECT_EQ(StudyDatabase::openForReading(target_).subjects().size(), 1u);
}

}  // namespace
}  // namespace ocelli::test
