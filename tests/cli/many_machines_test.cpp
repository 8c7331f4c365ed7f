// Commands as ranks of an MPI job: the bytes of one process, and an end of the job where one rank fails.
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <nlohmann/json.hpp>
#include <sstream>

#include "tests/base/temporary_folder.h"
#include "tests/cli/run_program.h"

namespace ocelli::test {
namespace {

using testing::HasSubstr;

// More ranks than cores, also as root in a container; no look for networks, nor for this machine's own name, which may
// be known to nobody: both take longer than the tests. A rank that waits leaves its core to others, as Open MPI does of
// itself where it knows of fewer slots than ranks: 8 ranks on two cores take a fifth of the CPU time.
constexpr const char* kLauncher = "'" OCELLI_MPIRUN
                                  "' --host localhost:8 --allow-run-as-root --oversubscribe --mca btl self,vader "
                                  "--mca mpi_yield_when_idle 1 -n";
constexpr const char* kScene = "builtin:statues,triangles=3000";

/// `what` in so many ranks; the output is "out" in the folder.
ProgramResult runRanks(int ranks, const std::string& what, const TemporaryFolder& folder) {
  return runShell(fmt::format("cd {} && {} {} \"$OCELLI\" {}", inQuotes(folder.path()), kLauncher, ranks, what));
}

ProgramResult runAlone(const std::string& what, const TemporaryFolder& folder) {
  return runShell(fmt::format("cd {} && \"$OCELLI\" {}", inQuotes(folder.path()), what));
}

struct Work {
  const char* command;
  const char* output;

  friend std::ostream& operator<<(std::ostream& stream, const Work& work) { return stream << work.command; }
};

class ManyMachinesWrite : public testing::TestWithParam<Work> {};

TEST_P(ManyMachinesWrite, theBytesOfOne) {
  const TemporaryFolder folder;
  const auto [command, output] = GetParam();
  const ProgramResult one = runAlone(command, folder);
  ASSERT_EQ(one.exitCode, 0) << one.error;
  const std::string expected = fileBytes(folder / output);
  ASSERT_FALSE(expected.empty());
  for (const int ranks : {1, 2, 4, 8}) {
    std::filesystem::remove(folder / output);
    const ProgramResult many = runRanks(ranks, command, folder);
    ASSERT_EQ(many.exitCode, 0) << many.error;
    EXPECT_EQ(many.output, one.output);
    EXPECT_TRUE(fileBytes(folder / output) == expected) << ranks << " ranks: " << command;
  }
}

INSTANTIATE_TEST_SUITE_P(
    Images, ManyMachinesWrite,
    testing::Values(Work{"ocri build builtin:statues,triangles=3000 --size 120x80 --camera di -o x.exr", "x.exr"},
                    Work{"ocri build builtin:statues,triangles=3000 --size 120x80 --camera ddoc --viewers 2 -o x.exr",
                         "x.exr"},
                    Work{"ocri build builtin:statues,triangles=3000 --size 120x80 --camera eoc-hv --compositing swap "
                         "-o x.exr",
                         "x.exr"},
                    Work{"ocri build builtin:statues,triangles=3000 --size 120x80 --camera cell -o x.exr", "x.exr"},
                    Work{"ocri build builtin:statues,triangles=3000 --size 120x80 --camera ldi-4 -o x.exr", "x.exr"},
                    Work{"ocri build builtin:boxes --size 120x80 --camera panorama -o x.exr", "x.exr"},
                    Work{"ocri build builtin:maze --size 120x80 --camera comprehensive -o x.exr", "x.exr"}));
INSTANTIATE_TEST_SUITE_P(
    Volumes, ManyMachinesWrite,
    testing::Values(Work{"slice builtin:statues,triangles=3000 --profile test -o x.svol", "x.svol"},
                    Work{"slice builtin:teapot --profile test --exact -o x.svol", "x.svol"},
                    Work{"slice builtin:teapot --profile test --antialias --even-light 0.2 -o x.svol", "x.svol"},
                    Work{"slice builtin:teapot --profile test --dither diffusion -o x.svol", "x.svol"},
                    Work{"slice builtin:teapot --profile test --repeat 3 -o x.svol", "x.svol"}));

TEST(ManyMachines, takePackedScenesAndSceneFiles) {
  const TemporaryFolder folder;
  ASSERT_EQ(runAlone(fmt::format("scene export {} --no-fit -o x.ply -q", kScene), folder).exitCode, 0);
  ASSERT_EQ(runAlone(fmt::format("scene pack {} -o x.opack -q", kScene), folder).exitCode, 0);
  for (const char* scene : {"x.ply", "x.opack"}) {
    const std::string command = fmt::format("ocri build {} --size 120x80 -q -o ", scene);
    const ProgramResult one = runAlone(command + "one.exr", folder);
    ASSERT_EQ(one.exitCode, 0) << one.error;
    const ProgramResult many = runRanks(4, command + "many.exr", folder);
    ASSERT_EQ(many.exitCode, 0) << many.error;
    EXPECT_EQ(many.error, "");
    EXPECT_TRUE(fileBytes(folder / "many.exr") == fileBytes(folder / "one.exr")) << scene;
  }
}

/// Without times, which differ from run to run.
nlohmann::json figuresOf(const std::filesystem::path& file) {
  nlohmann::json json = nlohmann::json::parse(fileBytes(file));
  for (nlohmann::json& row : json.at("representations")) {
    for (const char* time : {"build_ms", "mesh_ms", "slice_ms"}) {
      EXPECT_EQ(row.erase(time), 1u) << time;
    }
  }
  return json;
}

TEST(ManyMachines, evaluateAlike) {
  const TemporaryFolder folder;
  const std::string command =
      "evaluate builtin:fence --cameras di,ddoc --size 90x60 --interior 3 --directions 1 --runs 1 -q --json ";
  ASSERT_EQ(runAlone(command + "one.json", folder).exitCode, 0);
  for (const int ranks : {2, 8}) {
    const ProgramResult many = runRanks(ranks, command + "many.json", folder);
    ASSERT_EQ(many.exitCode, 0) << many.error;
    EXPECT_EQ(figuresOf(folder / "many.json"), figuresOf(folder / "one.json"));
  }
}

TEST(ManyMachines, findTheSamePower) {
  const TemporaryFolder folder;
  const std::string command = "power " OCELLI_SOURCE_DIR
                              "/protocols/short.json --task find --ratio 0.8 --subjects 4,6 --simulations 20 --json -q";
  const ProgramResult one = runAlone(command, folder);
  ASSERT_EQ(one.exitCode, 0) << one.error;
  for (const int ranks : {2, 4}) {
    const ProgramResult many = runRanks(ranks, command, folder);
    EXPECT_EQ(many.exitCode, 0) << many.error;
    EXPECT_EQ(many.output, one.output);
  }
}

/// The rows of trials.csv, without what numbers rows, trials and runs have in the database: those depend on who came
/// first, also with one rank on several threads.
std::vector<std::string> trialsIn(const std::filesystem::path& file) {
  std::istringstream lines(fileBytes(file));
  std::vector<std::string> trials;
  for (std::string line; std::getline(lines, line);) {
    std::istringstream fields(line);
    std::string kept;
    std::string field;
    for (int i = 0; i < 8 && std::getline(fields, field, ','); ++i) {
      kept.append(i < 2 || i == 7 ? "" : field + ",");
    }
    std::getline(fields, field, '\0');
    trials.push_back(kept.append(field));
  }
  std::sort(trials.begin(), trials.end());
  return trials;
}

TEST(ManyMachines, simulateTheSameStudy) {
  const TemporaryFolder folder;
  const std::string command =
      "study simulate " OCELLI_SOURCE_DIR "/protocols/short.json --kind generator --subjects 5 --seed 3 -q --db ";
  const std::string exported = "study export -q --db ";
  ASSERT_EQ(runAlone(command + "one.sqlite", folder).exitCode, 0);
  const ProgramResult one = runAlone(exported + "one.sqlite -o one", folder);
  ASSERT_EQ(one.exitCode, 0) << one.error;
  const ProgramResult many = runRanks(3, command + "many.sqlite", folder);
  ASSERT_EQ(many.exitCode, 0) << many.error;
  ASSERT_EQ(runAlone(exported + "many.sqlite -o many", folder).exitCode, 0);
  const std::vector<std::string> trials = trialsIn(folder / "one" / "trials.csv");
  EXPECT_GT(trials.size(), 20u);
  EXPECT_EQ(trialsIn(folder / "many" / "trials.csv"), trials);
}

TEST(ManyMachinesFail, whereTheSceneIsNotThere) {
  const TemporaryFolder folder;
  const ProgramResult result = runRanks(2, "ocri build none.ply -o x.exr", folder);
  EXPECT_EQ(result.exitCode, 2);
  EXPECT_THAT(result.error, HasSubstr("ocelli: error: "));
  EXPECT_THAT(result.error, HasSubstr("none.ply"));
}

TEST(ManyMachinesFail, whereTheDiskIsFull) {
  const TemporaryFolder folder;
  for (const char* command :
       {"ocri build builtin:teapot --size 120x80 -o /dev/full", "slice builtin:teapot --profile test -o /dev/full"}) {
    const auto start = std::chrono::steady_clock::now();
    const ProgramResult result = runRanks(3, command, folder);
    EXPECT_EQ(result.exitCode, 1) << result.error;
    EXPECT_THAT(result.error, HasSubstr("ocelli: error: "));
    EXPECT_THAT(result.error, HasSubstr("/dev/full"));
    EXPECT_LT(std::chrono::steady_clock::now() - start, std::chrono::seconds(10));
  }
}

TEST(ManyMachinesFail, whereARankIsKilled) {
  const TemporaryFolder folder;
  folder.write("rank.sh",
               "if [ \"$OMPI_COMM_WORLD_RANK\" = 1 ]; then (sleep 1; touch killed; kill -9 $$) & fi\n"
               "exec \"$1\" ocri build builtin:statues --camera cell --size 2000x1500 -o x.exr\n");
  const auto start = std::chrono::steady_clock::now();
  const ProgramResult result =
      runShell(fmt::format("cd {} && {} 3 sh rank.sh \"$OCELLI\"", inQuotes(folder.path()), kLauncher));
  EXPECT_NE(result.exitCode, 0);
  EXPECT_FALSE(result.error.empty());
  EXPECT_TRUE(std::filesystem::exists(folder / "killed"));
  EXPECT_FALSE(std::filesystem::exists(folder / "x.exr")) << "the work was done before the rank was killed";
  EXPECT_LT(std::chrono::steady_clock::now() - start, std::chrono::seconds(12));
}

TEST(ManyMachinesFail, whereACommandIsNotDivided) {
  const TemporaryFolder folder;
  const ProgramResult result = runRanks(2, "render builtin:teapot -o x.png", folder);
  EXPECT_EQ(result.exitCode, 2);
  EXPECT_THAT(result.error, HasSubstr("does not divide its work among 2 ranks"));
  EXPECT_FALSE(std::filesystem::exists(folder / "x.png"));
}

TEST(ManyMachines, printOnce) {
  const TemporaryFolder folder;
  const ProgramResult help = runRanks(3, "--version", folder);
  EXPECT_EQ(help.exitCode, 0);
  EXPECT_EQ(help.output, runAlone("--version", folder).output);
  const ProgramResult built =
      runRanks(2, fmt::format("ocri build {} --size 60x40 --camera di -o x.exr", kScene), folder);
  EXPECT_EQ(built.exitCode, 0) << built.error;
  EXPECT_EQ(built.error.find("wrote x.exr"), built.error.rfind("wrote x.exr")) << built.error;
  EXPECT_THAT(built.error, HasSubstr("drawn by 2 ranks"));
}

}  // namespace
}  // namespace ocelli::test
