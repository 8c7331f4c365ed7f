// Names that are not UTF-8, results on standard output, and inputs that have no end, from outside.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "oc_core/base/sanitizer.h"
#include "tests/base/temporary_folder.h"
#include "tests/cli/run_program.h"

namespace ocelli::test {
namespace {

using testing::AllOf;
using testing::AnyOf;
using testing::HasSubstr;
using testing::Not;

const std::string kTriangle = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";
const std::string kEvaluation = " --cameras di,ddoc --size 48x32 --interior 1 --directions 1 --runs 1 ";

/// The text must be JSON by the letter: no NaN, valid UTF-8, nothing around it.
nlohmann::json parsed(const ProgramResult& result) {
  EXPECT_EQ(result.exitCode, 0) << result.error;
  EXPECT_TRUE(nlohmann::json::accept(result.output)) << result.output;
  return nlohmann::json::parse(result.output, nullptr, false);
}

class NameThatIsNotUtf8 : public testing::Test {
 protected:
  const TemporaryFolder folder_;
  const std::string scene_ = inQuotes(folder_.write("caf\xe9 \"1\".obj", kTriangle));
};

TEST_F(NameThatIsNotUtf8, StandsInTheJsonOfSceneInfo) {
  EXPECT_THAT(parsed(runProgram("scene info " + scene_ + " --json"))["scene"].get<std::string>(),
              HasSubstr("caf\xef\xbf\xbd \"1\".obj"));
}

TEST_F(NameThatIsNotUtf8, StandsInTheJsonOfEvaluate) {
  const auto json = parsed(runProgram("evaluate " + scene_ + kEvaluation + "--json"));
  EXPECT_THAT(json["scene"].get<std::string>(), HasSubstr("caf\xef\xbf\xbd"));
  EXPECT_EQ(json["representations"].size(), 2u);
}

TEST_F(NameThatIsNotUtf8, StandsInAVolumeAndWhatIsMadeOfIt) {
  const std::string volume = inQuotes(folder_ / "a\xe9.svol");
  EXPECT_EQ(parsed(runProgram("slice " + scene_ + " --profile test --json -o " + volume)).is_object(), true);
  EXPECT_THAT(parsed(runProgram("volume info " + volume + " --json")).dump(), HasSubstr("caf\xef\xbf\xbd"));
  EXPECT_EQ(runProgram("observe " + volume + " -o " + inQuotes(folder_ / "o\xe9.exr")).exitCode, 0);
}

TEST_F(NameThatIsNotUtf8, StandsInAReferenceImage) {
  const std::string image = inQuotes(folder_ / "r\xe9.exr");
  EXPECT_EQ(runProgram("ocri build " + scene_ + " --size 48x32 -o " + image).exitCode, 0);
  EXPECT_EQ(runProgram("ocri mesh " + image + " -o " + inQuotes(folder_ / "m\xe9.ply")).exitCode, 0);
}

TEST(Evaluate, PrintsJsonAloneWhereItsFileIsStandardOutput) {
  for (const std::string name : {"-", "/dev/stdout", "/dev/fd/1"}) {
    // The output of runProgram() is a file: a pipe is what a reader of JSON has.
    const ProgramResult result =
        runShell("\"$OCELLI\" evaluate builtin:teapot,segments=4" + kEvaluation + "--json " + name + " | cat");
    EXPECT_EQ(parsed(result)["representations"].size(), 2u) << name;
  }
}

TEST(Evaluate, PrintsCsvAloneToo) {
  const ProgramResult result =
      runShell("\"$OCELLI\" evaluate builtin:teapot,segments=4" + kEvaluation + "--csv /dev/stdout | cat");
  EXPECT_EQ(std::count(result.output.begin(), result.output.end(), '\n'), 3) << result.output;
}

TEST(SceneWarning, NamesAMissingTextureUnlessQuiet) {
  const TemporaryFolder folder;
  folder.write("a.mtl", "newmtl a\nmap_Kd none.png\n");
  const std::string scene =
      inQuotes(folder.write("a.obj", "mtllib a.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 0\nusemtl a\nf 1/1 2/1 3/1\n"));
  const ProgramResult result = runProgram("scene info " + scene + " --json");
  parsed(result);
  EXPECT_THAT(result.error, AllOf(HasSubstr("warning"), HasSubstr("none.png"), HasSubstr("try:")));
  EXPECT_THAT(runProgram("scene info --quiet " + scene).error, Not(HasSubstr("none.png")));
  EXPECT_THAT(runProgram("scene info --no-textures " + scene).error, Not(HasSubstr("none.png")));
  EXPECT_THAT(runProgram("scene info builtin:room,mesh=" + scene).error, HasSubstr("none.png"));
}

TEST(Interrupt, EndsTheReadingOfAScene) {
  const TemporaryFolder folder;
  const auto reader = folder.write("reader", "#!/bin/sh\necho $$ >\"$OCELLI_TEST_ID\"\nexec sleep 1000\n");
  std::filesystem::permissions(reader, std::filesystem::perms::owner_all);
  const ProgramResult result =
      runShell("export OCELLI_SCENE_READER=" + inQuotes(reader) + " OCELLI_TEST_ID=" + inQuotes(folder / "id") +
               "\n\"$OCELLI\" scene info " + inQuotes(folder.write("a.obj", kTriangle)) +
               " &\nwhile [ ! -s \"$OCELLI_TEST_ID\" ]; do sleep 0.05; done\nkill -TERM $!\nwait $!\necho ended "
               "$?\nkill $(cat \"$OCELLI_TEST_ID\")\n");
  EXPECT_THAT(result.output, HasSubstr("ended 143"));
}

const std::string kLimit = kAddressSanitizer ? "" : "ulimit -v 3000000\n";

class EndlessInput : public testing::TestWithParam<std::string> {};

TEST_P(EndlessInput, IsAnErrorThatSaysWhatToDo) {
  const TemporaryFolder folder;
  std::filesystem::create_symlink("/dev/zero", folder / "zero.json");
  std::filesystem::create_symlink("/dev/zero", folder / "zero.csv");
  std::filesystem::create_symlink("/dev/zero", folder / "zero.svol");
  std::filesystem::create_symlink("/dev/zero", folder / "zero.db");
  const ProgramResult result =
      runShell(kLimit + "cd " + inQuotes(folder.path()) + "\ntimeout 60 \"$OCELLI\" " + GetParam());
  EXPECT_THAT(result.exitCode, AnyOf(1, 2)) << "neither a crash nor a time-out";
  EXPECT_THAT(result.error, AllOf(HasSubstr("zero"), HasSubstr("try:"), Not(HasSubstr("out of memory"))));
}

INSTANTIATE_TEST_SUITE_P(Commands, EndlessInput,
                         testing::Values("ocri mesh /dev/zero -o x.ply", "slice /dev/zero -o x.svol",
                                         "slice zero.svol -o x.svol", "slice builtin:box --profile zero.json -o x.svol",
                                         "observe /dev/zero -o x.png", "volume info /dev/zero",
                                         "volume verify zero.svol", "present /dev/zero --device sim",
                                         "scene info /dev/zero", "render builtin:box --view zero.json -o x.png",
                                         "camera info builtin:box --camera zero.json",
                                         "camera edit builtin:box --camera portal --edits /dev/zero -o x.json",
                                         "study check zero.json", "study subjects --db zero.db", "analyse zero.db -o r",
                                         "analyse zero.csv -o r", "analyse /dev/zero -o r",
                                         "evaluate builtin:box --cameras zero.json"));

}  // namespace
}  // namespace ocelli::test
