// `ocelli study check` from outside.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "tests/base/temporary_folder.h"
#include "tests/cli/run_program.h"

namespace ocelli::test {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;

const std::string kShort = "\"" OCELLI_SOURCE_DIR "/protocols/short.json\"";

TEST(StudyCheck, TellsScheduleLengthAndBalance) {
  const ProgramResult result = runProgram("study check " + kShort + " --subjects 3 --answers");
  EXPECT_EQ(result.exitCode, 0) << result.error;
  EXPECT_THAT(result.error, IsEmpty());
  EXPECT_THAT(result.output,
              AllOf(HasSubstr("Session 1 of the subject in slot 0"), HasSubstr("typical min"), HasSubstr("location 3"),
                    HasSubstr("object at row "), HasSubstr("Balance of session 1 over 3 subjects"),
                    HasSubstr("the consent still says \"[fill in: name and address]\"")));
  EXPECT_THAT(runProgram("study check " + kShort).output, Not(HasSubstr("object at row")));
}

TEST(StudyCheck, PrintsAllOfItAsJson) {
  const ProgramResult result = runProgram("study check " + kShort + " --json --subject-slot 1 --subjects 5");
  ASSERT_EQ(result.exitCode, 0) << result.error;
  const auto json = nlohmann::json::parse(result.output);
  EXPECT_EQ(json.at("schedule").at("slot"), 1);
  EXPECT_EQ(json.at("schedule").at("first_view"), "gc");
  EXPECT_EQ(json.at("schedule").at("trials").size(), 12u);
  EXPECT_EQ(json.at("balance").at(0).at("cells").at("ppc first"), 3);
  EXPECT_FALSE(json.at("schedule").at("trials").at(0).contains("answer"));
}

TEST(StudyCheck, RefusesWhatIsWrongWithExitCodeTwo) {
  const TemporaryFolder folder;
  const std::string path = (folder.path() / "bad.json").string();
  const ProgramResult bad = runShell("echo '{\"name\": \"x\", \"titel\": \"y\"}' > '" + path + "'\n" +
                                     "\"$OCELLI\" study check '" + path + "'\n");
  EXPECT_EQ(bad.exitCode, 2);
  EXPECT_THAT(bad.error, AllOf(HasSubstr("field \"title\" is missing"), HasSubstr("bad.json")));
  EXPECT_EQ(runProgram("study check " + kShort + " --session 2").exitCode, 2);
  EXPECT_EQ(runProgram("study check " + kShort + " --subjects 0").exitCode, 2);
  EXPECT_EQ(runProgram("study check no_such_file.json").exitCode, 2);
}

#ifdef OCELLI_WITH_OPENGL
TEST(StudyCheck, RefusesTextsThatTheScreenWouldNotShow) {
  const TemporaryFolder folder;
  std::string text = fileBytes(OCELLI_SOURCE_DIR "/protocols/short.json");
  const std::string agreed = "Go on only if you agree to take part.";
  text.replace(text.find(agreed), agreed.size(), "\u0938\u093e\u0932");
  const std::string path = inQuotes(folder.write("hindi.json", text));
  const std::string database = (folder / "study.db").string();
  const ProgramResult checked = runProgram("study check " + path);
  const ProgramResult run = runProgram("study run " + path + " --db '" + database + "' --subject S01");
  for (const ProgramResult& result : {checked, run}) {
    EXPECT_EQ(result.exitCode, 2) << result.error;
    EXPECT_THAT(result.error, AllOf(HasSubstr("\"consent\", \"paragraphs\" 8"), HasSubstr("U+0938"),
                                    HasSubstr("joined or reordered")));
  }
  EXPECT_FALSE(std::filesystem::exists(database));
}
#endif

}  // namespace
}  // namespace ocelli::test
