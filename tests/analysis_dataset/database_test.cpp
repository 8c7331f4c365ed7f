#include "analysis/dataset/database.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <set>

#include "tests/analysis_dataset/sample_study.h"

namespace ocelli::test {
namespace {

using ::testing::HasSubstr;

struct Database : ::testing::Test {
  SampleFolder folder;
  std::string path = folder.file("study.db");

  std::string errorOfReading() const {
    return analysisErrorOf([&] { readDatabase(path); });
  }
};

TEST_F(Database, givesWhatTheViewsGive) {
  SampleStudy study(path);
  fillSmallStudy(study);
  const Dataset data = readDatabase(path);
  ASSERT_EQ(data.trials.size(), 12u);
  const Trial& found = data.trials[1];
  EXPECT_EQ(found.subject, "S01");
  EXPECT_EQ(found.view, TrialView::kOther);
  EXPECT_EQ(found.caseLabel, "location 1");
  EXPECT_EQ(found.responseSeconds, 6.0);
  EXPECT_EQ(found.censored, false);
  EXPECT_EQ(found.measures.at("path_length_m"), 12.5);
  EXPECT_EQ(found.longestSeconds, 60.0);
  EXPECT_EQ(found.subjectKind, SubjectKind::kPerson);
  EXPECT_FALSE(found.exposureSeconds);
  EXPECT_TRUE(data.trials[6].censored.value());
  ASSERT_EQ(data.sessions.size(), 4u);
  EXPECT_EQ(data.sessions[0].ending, SessionEnding::kCompleted);
  EXPECT_EQ(data.sessions[0].completedTrials, 3);
  EXPECT_EQ(data.consents.size(), 2u);
  EXPECT_EQ(data.answers.size(), 4u);
  EXPECT_EQ(data.sources[0].protocolText, kSampleProtocol);
  EXPECT_FALSE(data.isSimulated());
}

TEST_F(Database, countsTheLastAttemptAndSaysWhatBecameOfTheOthers) {
  SampleStudy study(path);
  study.addSubject("S01");
  study.addSession("S01", 1, "");
  SampleTrial trial;
  trial.plan.reset();
  study.addTrial(trial);
  trial.plan = 0;
  trial.ending = "redone";
  study.addTrial(trial);
  trial.ending = "completed";
  study.addTrial(trial);
  trial.response = 20;
  study.addTrial(trial);
  trial.plan = 1;
  trial.ending = "";
  study.addTrial(trial);
  const Dataset data = readDatabase(path);
  ASSERT_EQ(data.trials.size(), 1u);
  EXPECT_EQ(data.trials[0].trialId, 4);
  ASSERT_EQ(data.otherAttempts.size(), 4u);
  using Why = OtherAttempt::Why;
  const Why expected[] = {Why::kPractice, Why::kRedone, Why::kRepeated, Why::kNotEnded};
  for (size_t i = 0; i < 4; ++i) {
    EXPECT_EQ(data.otherAttempts[i].why, expected[i]) << i;
  }
  EXPECT_FALSE(data.sessions[0].ending);
}

TEST_F(Database, readsALogThatWasNotYetPutBack) {
  SampleStudy study(path);
  fillSmallStudy(study);
  ASSERT_GT(std::filesystem::file_size(path + "-wal"), 0u);
  std::filesystem::copy_file(path, folder.file("killed.db"));
  std::filesystem::copy_file(path + "-wal", folder.file("killed.db-wal"));
  EXPECT_EQ(readDatabase(folder.file("killed.db")).trials.size(), 12u);
  EXPECT_GT(std::filesystem::file_size(folder.file("killed.db-wal")), 0u) << "the log is the owner's to put back";
}

TEST_F(Database, readsOneMomentWhileAnotherWrites) {
  SampleStudy study(path);
  fillSmallStudy(study);
  SQLite::Transaction unfinished(study.database());
  SampleTrial trial;
  trial.plan = 3;
  study.addTrial(trial);
  EXPECT_EQ(readDatabase(path).trials.size(), 12u);
  unfinished.commit();
  EXPECT_EQ(readDatabase(path).trials.size(), 13u);
}

TEST_F(Database, leavesNothingBehindAndChangesNothing) {
  {
    SampleStudy study(path);
    fillSmallStudy(study);
  }
  const auto bytes = [&] {
    std::ifstream file(path, std::ios::binary);
    return std::string(std::istreambuf_iterator<char>(file), {});
  };
  const std::string before = bytes();
  readDatabase(path);
  EXPECT_EQ(bytes(), before);
  EXPECT_FALSE(std::filesystem::exists(path + "-wal"));
  EXPECT_FALSE(std::filesystem::exists(path + "-shm"));
}

TEST_F(Database, everyChangedValueChangesTheHash) {
  const auto hashAfter = [&](const std::string& change) {
    const SampleFolder other;
    SampleStudy study(other.file("study.db"));
    fillSmallStudy(study);
    study.database().exec(
        "DROP TRIGGER trial_update; DROP TRIGGER trial_update_plan; DROP TRIGGER answer_update; "
        "DROP TRIGGER run_update; DROP TRIGGER subject_update");
    study.database().exec(change);
    return dataHash(readDatabase(other.file("study.db")));
  };
  std::set<std::string> hashes{hashAfter("SELECT 1")};
  EXPECT_EQ(hashAfter("SELECT 1"), *hashes.begin());
  for (const char* column : {"response_s = 7.000000000000001",
                             "answer = 'x'",
                             "expected = 'x'",
                             "correct = 0",
                             "censored = 1",
                             "view = 'ppc'",
                             "case_index = 5",
                             "case_label = 'x'",
                             "moving = 1",
                             "moving = NULL",
                             "exposure_s = 0",
                             "objects = 2",
                             "duplicate_colors = 1",
                             "attempt = 2",
                             "block = 'x'",
                             "block_index = 7",
                             "task = 'path'",
                             "plan_index = 77",
                             "trial_number = 900",
                             "trial_seed = 12",
                             "started_ns = 3",
                             "ended_ns = 3",
                             "started_utc = 'x'",
                             "ended_utc = 'x'",
                             "response_ticks = 1",
                             "exposure_frames = 1",
                             "exposure_rule = 'frames'",
                             "exposure_rule = 'clock', exposure_shown_s = 2",
                             "measures_json = '{\"path_length_m\": 12.6, \"wrong_clicks\": 0}'",
                             "measures_json = '{\"path_length_m\": 12.5}'",
                             "frames = 1",
                             "dropped_frames = 1",
                             "median_interval_ns = 1",
                             "longest_interval_ns = 1",
                             "timing_verdict = 'early_frames'",
                             "screen_width_px = 1",
                             "screen_height_px = 1",
                             "refresh_hz = 60"}) {
    EXPECT_TRUE(hashes.insert(hashAfter("UPDATE trial SET " + std::string(column) + " WHERE trial_id = 5")).second)
        << column;
  }
  for (const char* change :
       {"UPDATE answer SET answer = 'x' WHERE answer_id = 1", "UPDATE answer SET field = 'x' WHERE answer_id = 1",
        "UPDATE run SET ending = 'unwell' WHERE run_id = 1", "UPDATE subject SET slot = 9 WHERE slot = 1"}) {
    EXPECT_TRUE(hashes.insert(hashAfter(change)).second) << change;
  }
}

TEST_F(Database, keepsHostileTexts) {
  const std::string hostile = "</script><b>\"'; DROP TABLE trial; --\n=1+1\x01\xff";
  SampleStudy study(path);
  study.addSubject(hostile);
  study.addSession(hostile, 1);
  study.addAnswer(hostile, hostile, hostile, hostile);
  SampleTrial trial;
  trial.subject = hostile;
  trial.answer = hostile;
  trial.caseLabel = hostile;
  study.addTrial(trial);
  const Dataset data = readDatabase(path);
  EXPECT_EQ(data.trials[0].subject, hostile);
  EXPECT_EQ(data.trials[0].answer, hostile);
  EXPECT_EQ(data.trials[0].caseLabel, hostile);
  EXPECT_EQ(data.answers[0].field, hostile);
}

TEST_F(Database, saysWhatIsWrong) {
  EXPECT_THAT(errorOfReading(), HasSubstr("there is no such file"));
  std::ofstream(path) << "";
  EXPECT_THAT(errorOfReading(), HasSubstr("this database is empty"));
  std::ofstream(path) << std::string(5000, 'x');
  EXPECT_THAT(errorOfReading(), HasSubstr("this is no database"));
  std::filesystem::remove(path);
  {
    SQLite::Database other(path, SQLite::OPEN_READWRITE | SQLite::OPEN_CREATE);
    other.exec("CREATE TABLE t (x)");
  }
  EXPECT_THAT(errorOfReading(), HasSubstr("this is no database of a study"));
  std::filesystem::remove(path);
  {
    SampleStudy study(path);
    study.database().exec("PRAGMA user_version = 9");
  }
  EXPECT_THAT(errorOfReading(), HasSubstr("has version 9 of the schema, and this program knows those up to 4"));
  EXPECT_THAT(errorOfReading(), HasSubstr("a newer version of ocelli"));
  std::filesystem::remove(path);
  {
    SampleStudy study(path);
    study.database().exec("DROP TRIGGER study_delete; DELETE FROM study");
  }
  EXPECT_THAT(errorOfReading(), HasSubstr("this database holds no study yet"));
  std::filesystem::remove(path);
  {
    SampleStudy study(path);
    study.database().exec("DROP TRIGGER study_update; UPDATE study SET protocol_text = '{}'");
  }
  EXPECT_THAT(errorOfReading(), HasSubstr("someone changed it"));
}

TEST_F(Database, aDamagedFileIsSaidToBe) {
  {
    SampleStudy study(path);
    fillSmallStudy(study);
  }
  std::filesystem::resize_file(path, std::filesystem::file_size(path) / 2);
  EXPECT_THAT(errorOfReading(), HasSubstr("damaged"));
}

TEST_F(Database, anEmptyStudyHasNoTrials) {
  SampleStudy study(path);
  const Dataset data = readDatabase(path);
  EXPECT_TRUE(data.trials.empty());
  EXPECT_EQ(dataHash(data).size(), 64u);
}

TEST_F(Database, measuresMustBeNumbers) {
  SampleStudy study(path);
  study.addSubject("S01");
  study.addSession("S01", 1);
  SampleTrial trial;
  trial.measures = R"({"a": "b"})";
  study.addTrial(trial);
  EXPECT_THAT(errorOfReading(), HasSubstr("trial_id 1, measures_json"));
}

}  // namespace
}  // namespace ocelli::test
