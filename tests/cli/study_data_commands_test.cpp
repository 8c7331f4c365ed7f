// `ocelli study subjects`, `withdraw`, `merge` and `export` as a shell sees them.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "study/store/study_database.h"
#include "study/store/trial_store.h"
#include "tests/base/temporary_folder.h"
#include "tests/cli/run_program.h"
#include "tests/study_export/exported_study.h"

namespace ocelli::test {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

constexpr int kWorkFailed = 1;
constexpr int kInputWrong = 2;

class StudyDataCommandsTest : public testing::Test {
 protected:
  StudyDataCommandsTest() { storeStudy(folder_ / "study.db"); }
  /// The command, with the words after its --db.
  ProgramResult run(const std::string& command, const std::string& rest = "") const {
    return runProgram("study " + command + " --db " + path("study.db") + " " + rest);
  }
  std::string path(const std::string& name) const { return (folder_ / name).string(); }

  TemporaryFolder folder_;
};

TEST_F(StudyDataCommandsTest, ListSubjects) {
  const ProgramResult text = run("subjects");
  EXPECT_EQ(text.exitCode, 0) << text.error;
  EXPECT_THAT(text.output, AllOf(HasSubstr("protocol made-up"), HasSubstr("S01"), HasSubstr("simulated_observer"),
                                 HasSubstr("session 1: 4 of 4 trials, completed")));
  EXPECT_THAT(text.output, Not(HasSubstr("ended early")));
  const nlohmann::json json = nlohmann::json::parse(run("subjects", "--json").output);
  ASSERT_EQ(json["subjects"].size(), 3u);
  EXPECT_EQ(json["subjects"][1]["subject_id"], "S02");
  EXPECT_EQ(json["subjects"][1]["slot"], 1);
  EXPECT_EQ(json["subjects"][1]["sessions"][0]["ending"], "completed");
  EXPECT_EQ(runProgram("study subjects --db " + path("none.db")).exitCode, kInputWrong);
}

TEST_F(StudyDataCommandsTest, ListSlotsOfWhoLeftEarly) {
  {
    StudyDatabase database = StudyDatabase::openForSessions(path("study.db"), madeProtocol());
    const int slot = database.addSubject("S09", SubjectKind::kPerson).slot;
    TrialStore store(database, madeProtocol(), madeRun("S09", 1), madeSchedule(slot, 1, 2));
    store.sessionEnds(SessionEnding::kDeclined, "2026-03-01T13:00:00.000Z");
  }
  EXPECT_THAT(run("subjects").output, HasSubstr("ended early: 2 (S09, declined)"));
}

TEST_F(StudyDataCommandsTest, NoteWhoASubjectIsApartFromTheData) {
  EXPECT_EQ(run("subjects", "--key " + path("key.csv") + " --subject S01 --name 'Ada L.'").exitCode, 0);
  EXPECT_THAT(fileBytes(folder_ / "key.csv"), HasSubstr("S01,Ada L."));
  EXPECT_THAT(fileBytes(folder_ / "study.db"), Not(HasSubstr("Ada L.")));
  // Before the first session too, and before there is a database.
  const ProgramResult early = run("subjects", "--key " + path("key.csv") + " --subject S09 --name 'Grace H.'");
  EXPECT_EQ(early.exitCode, 0);
  EXPECT_THAT(early.error, HasSubstr("not taken part yet"));
  EXPECT_THAT(fileBytes(folder_ / "key.csv"), HasSubstr("S09,Grace H."));
  EXPECT_EQ(run("subjects", "--key " + path("key.csv") + " --subject 'S 9' --name x").exitCode, kInputWrong);
  EXPECT_EQ(run("subjects", "--key " + path("key.csv")).exitCode, kInputWrong);
  EXPECT_EQ(run("subjects", "--name x").exitCode, kInputWrong);
}

TEST_F(StudyDataCommandsTest, Export) {
  const ProgramResult csv = run("export", "-o " + path("tables"));
  EXPECT_EQ(csv.exitCode, 0) << csv.error;
  EXPECT_THAT(csv.error, AllOf(HasSubstr("wrote 6 files"), HasSubstr("1 of the subjects are simulated")));
  EXPECT_EQ(run("export", "-o " + path("tables")).exitCode, kInputWrong);
  EXPECT_EQ(run("export", "--frames --inputs --notes --force -o " + path("tables")).exitCode, 0);
  EXPECT_THAT(fileBytes(folder_ / "tables/events.csv"), HasSubstr(kTypedNote));
  EXPECT_EQ(run("export", "--form psych-ds -o " + path("set")).exitCode, 0);
  EXPECT_TRUE(std::filesystem::exists(folder_ / "set/dataset_description.json"));
  EXPECT_EQ(run("export", "--form sav -o " + path("other")).exitCode, kInputWrong);
  EXPECT_EQ(run("export", "-o /proc/none").exitCode, kWorkFailed);
}

TEST_F(StudyDataCommandsTest, Withdraw) {
  ASSERT_EQ(run("export", "-o " + path("tables")).exitCode, 0);
  ASSERT_EQ(run("subjects", "--key " + path("key.csv") + " --subject S02 --name 'Grace H.'").exitCode, 0);
  const ProgramResult refused = run("withdraw", "--subject S02");
  EXPECT_EQ(refused.exitCode, kInputWrong);
  EXPECT_THAT(refused.error, HasSubstr("--delete-exports"));
  const ProgramResult done = run("withdraw", "--subject S02 --delete-exports --key " + path("key.csv"));
  EXPECT_EQ(done.exitCode, 0) << done.error;
  EXPECT_THAT(done.output, AllOf(HasSubstr("trials.csv"), HasSubstr("1 sessions with 4 trials")));
  EXPECT_THAT(fileBytes(folder_ / "key.csv"), Not(HasSubstr("Grace")));
  EXPECT_EQ(run("withdraw", "--subject S02").exitCode, kInputWrong);
}

TEST_F(StudyDataCommandsTest, Merge) {
  const ProgramResult first = runProgram("study merge --db " + path("all.db") + " " + path("study.db"));
  EXPECT_EQ(first.exitCode, 0) << first.error;
  EXPECT_THAT(first.output,
              AllOf(HasSubstr("3 new subjects, 3 new runs, 15 new trials"), HasSubstr("people, slots 0-1: 1 each"),
                    HasSubstr("simulated subjects, slot 0: 1 each")));
  const ProgramResult second = runProgram("study merge --db " + path("all.db") + " " + path("study.db"));
  EXPECT_THAT(second.output, HasSubstr("0 new subjects, 0 new runs, 0 new trials; 3 subjects were there before"));
  EXPECT_EQ(runProgram("study merge --db " + path("study.db") + " " + path("study.db")).exitCode, kInputWrong);
}

}  // namespace
}  // namespace ocelli::test
