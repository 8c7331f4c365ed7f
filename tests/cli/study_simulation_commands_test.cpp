// `ocelli study simulate` and `replay` as a shell sees them.
#include <SQLiteCpp/Database.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>

#include "oc_core/image/png_file.h"
#include "tests/base/temporary_folder.h"
#include "tests/cli/run_program.h"

namespace ocelli::test {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

constexpr int kWorkFailed = 1;
constexpr int kInputWrong = 2;

constexpr const char* kProtocol = R"({
  "name": "tiny", "title": "Tiny", "sessions": 2,
  "mazes": {"bend": {"plan": ["+-+-+-+", "|     |", "+ +-+-+"]}},
  "blocks": [{"name": "find", "title": "Find", "task": "find", "maze": "bend", "limit_seconds": 20,
              "cases": [{"label": "end", "row": 0, "column": 2}]}]
})";

class StudySimulationCommands : public testing::Test {
 protected:
  StudySimulationCommands() { folder_.write("tiny.json", kProtocol); }
  ProgramResult simulate(const std::string& rest) const {
    return runProgram("study simulate " + path("tiny.json") + " --db " + path("study.db") + " --frame 240x150 " + rest);
  }
  ProgramResult replay(const std::string& rest) const {
    return runProgram("study replay --db " + path("study.db") + " " + rest);
  }
  std::string path(const std::string& name) const { return (folder_ / name).string(); }

  TemporaryFolder folder_;
};

TEST_F(StudySimulationCommands, SimulateAndReplayAllOfIt) {
  const ProgramResult made = simulate("--subjects 2 --sessions 2x1,1x1 --seed 3 --hash-frames");
  EXPECT_EQ(made.exitCode, 0) << made.error;
  EXPECT_THAT(made.error, HasSubstr("2 simulated subjects, 3 sessions simulated, 0 there before; 6 trials in all"));
  EXPECT_THAT(simulate("--subjects 2 --sessions 2x1,1x1 --seed 3 --hash-frames").error,
              HasSubstr("0 sessions simulated, 3 there before"));

  const ProgramResult all = replay("--all");
  EXPECT_EQ(all.exitCode, 0) << all.error;
  EXPECT_THAT(all.output, AllOf(HasSubstr("6 trials: poses identical in 6, outcomes identical in 6"),
                                HasSubstr("; pixels identical in ")));
  const ProgramResult one = replay("--subject sim-0001 --session 2 --trial 1 --plan " + path("plan.svg") +
                                   " --frames " + path("frames") + " --every 40");
  EXPECT_EQ(one.exitCode, 0) << one.error;
  EXPECT_THAT(one.output, HasSubstr("1 trials: poses identical in 1"));
  EXPECT_THAT(fileBytes(folder_ / "plan.svg"), HasSubstr("<svg"));
  EXPECT_EQ(readPng(folder_ / "frames/frame_000000.png").width(), 240);
  EXPECT_TRUE(std::filesystem::exists(folder_ / "frames/frame_000040.png"));
  EXPECT_FALSE(std::filesystem::exists(folder_ / "frames/frame_000041.png"));

  EXPECT_EQ(replay("--subject nobody --trial 1").exitCode, kInputWrong);
  EXPECT_EQ(replay("--subject sim-0001 --trial 99").exitCode, kInputWrong);
  EXPECT_EQ(replay("--subject sim-0001").exitCode, kInputWrong) << "which trial?";
  EXPECT_EQ(replay("--all --plan " + path("plan.svg")).exitCode, kInputWrong);
  EXPECT_EQ(replay("--subject sim-0001 --trial 1 --plan " + path("no/plan.svg")).exitCode, kWorkFailed);
  EXPECT_EQ(replay("--subject sim-0001 --trial 1 --plan " + path("plan.txt")).exitCode, kInputWrong);
}

TEST_F(StudySimulationCommands, ReplaysTellWhereALogWasChanged) {
  ASSERT_EQ(simulate("--seed 3 --sessions 1").exitCode, 0);
  {
    // Rows can only be changed by one who takes the triggers away.
    SQLite::Database database(path("study.db"), SQLite::OPEN_READWRITE);
    database.exec("DROP TRIGGER frame_update");
    EXPECT_EQ(database.exec("UPDATE frame SET x_m = x_m + 0.001 WHERE trial_id = 1 AND frame = 5"), 1);
  }
  const ProgramResult all = replay("--all");
  EXPECT_EQ(all.exitCode, kWorkFailed);
  EXPECT_THAT(all.output, HasSubstr("different: sim-0001, session 1, trial 1"));
}

TEST_F(StudySimulationCommands, GenerateKnownEffects) {
  folder_.write("effects.json", R"({"find": {"graph": -0.6}})");
  const ProgramResult made = simulate("--kind generator --subjects 5 --effects " + path("effects.json"));
  EXPECT_EQ(made.exitCode, 0) << made.error;
  EXPECT_THAT(replay("--all").output, HasSubstr("20 trials have no log to replay"));
}

// The way of a task that was added by a row: no other code knows it.
TEST_F(StudySimulationCommands, ANewTaskGoesAllTheWayToTheExport) {
  const std::string protocol = OCELLI_SOURCE_DIR "/protocols/nearer.json";
  const ProgramResult checked = runProgram("study check " + protocol + " --answers");
  EXPECT_EQ(checked.exitCode, 0) << checked.error;
  EXPECT_THAT(checked.output, AllOf(HasSubstr("2 and 3"), HasSubstr("; left"), HasSubstr("; right")));

  const std::string database = " --db " + path("nearer.db") + " --frame 240x150 ";
  for (const char* kind : {"observer --first see-", "generator --first draw- --subjects 20"}) {
    const ProgramResult made = runProgram("study simulate " + protocol + database + "--kind " + kind);
    EXPECT_EQ(made.exitCode, 0) << made.error;
  }
  {
    SQLite::Database stored(path("nearer.db"), SQLite::OPEN_READONLY);
    const auto count = [&](const std::string& where) {
      return stored.execAndGet("SELECT count(*) FROM trial WHERE practice = 0 AND " + where).getInt();
    };
    EXPECT_EQ(count("task = 'nearer'"), 21 * 24);
    EXPECT_EQ(count("simulated = 0"), 0);
    EXPECT_EQ(count("correct = (answer = expected)"), 21 * 24);
    EXPECT_EQ(count("answer IN ('left', 'right') AND expected IN ('left', 'right')"), 21 * 24);
    EXPECT_GT(count("correct = 1"), 100);
    EXPECT_GT(count("correct = 0"), 10);
    EXPECT_GT(count("measures_json LIKE '%left_distance_m%'"), 15);
  }
  EXPECT_THAT(runProgram("study replay --all --db " + path("nearer.db")).output, HasSubstr("outcomes identical in "));
  const ProgramResult exported = runProgram("study export --db " + path("nearer.db") + " -o " + path("tables"));
  EXPECT_EQ(exported.exitCode, 0) << exported.error;
  EXPECT_THAT(fileBytes(folder_ / "tables/trials.csv"), AllOf(HasSubstr(",nearer,"), HasSubstr("left_distance_m")));
}

// The way of conditions that a protocol names itself: the mesh of an occlusion camera, seen from a moved eye.
TEST_F(StudySimulationCommands, NamedConditionsGoAllTheWayToTheReport) {
  const std::string protocol = OCELLI_SOURCE_DIR "/protocols/nearer-aside.json";
  const ProgramResult checked = runProgram("study check " + protocol);
  EXPECT_EQ(checked.exitCode, 0) << checked.error;
  EXPECT_THAT(checked.output, AllOf(HasSubstr("pinhole first"), HasSubstr(" aside")));
  const std::string database = " --db " + path("aside.db") + " --frame 240x150 ";
  for (const char* kind : {"observer --first see- --hash-frames", "generator --first draw- --subjects 12"}) {
    const ProgramResult made = runProgram("study simulate " + protocol + database + "--kind " + kind);
    EXPECT_EQ(made.exitCode, 0) << made.error;
  }
  {
    SQLite::Database stored(path("aside.db"), SQLite::OPEN_READONLY);
    const auto count = [&](const std::string& view) {
      return stored.execAndGet("SELECT count(*) FROM trial WHERE practice = 0 AND view = '" + view + "'").getInt();
    };
    EXPECT_EQ(count("pinhole"), 13 * 12);
    EXPECT_EQ(count("aside"), 13 * 12);
  }
  const ProgramResult replayed = runProgram("study replay --all --subject see-0001 --db " + path("aside.db"));
  EXPECT_EQ(replayed.exitCode, 0) << replayed.error;
  EXPECT_THAT(replayed.output, HasSubstr("outcomes identical in 24"));
  const ProgramResult analysed =
      runProgram("analyse " + path("aside.db") + " --simulated together -o " + path("report"));
  EXPECT_EQ(analysed.exitCode, 0) << analysed.error;
  EXPECT_THAT(fileBytes(folder_ / "report/index.html"),
              AllOf(HasSubstr("mesh from aside"), Not(HasSubstr("graph camera"))));
}

TEST_F(StudySimulationCommands, RejectWhatCannotBe) {
  EXPECT_EQ(simulate("--sessions 3x1").exitCode, kInputWrong) << "the protocol has but two";
  EXPECT_EQ(simulate("--subjects 3 --sessions 1x2").exitCode, kInputWrong);
  EXPECT_EQ(simulate("--first 'a b'").exitCode, kInputWrong);
  EXPECT_EQ(simulate("--effects x.json").exitCode, kInputWrong) << "observers have no effects";
  EXPECT_EQ(simulate("--kind generator --effects " + path("none.json")).exitCode, kInputWrong);
  EXPECT_NE(simulate("--subjects 0").exitCode, 0);
  EXPECT_EQ(runProgram("study simulate " + path("none.json") + " --db " + path("a.db")).exitCode, kInputWrong);
  EXPECT_EQ(runProgram("study replay --db " + path("none.db") + " --all").exitCode, kInputWrong);
}

}  // namespace
}  // namespace ocelli::test
