// The process that reads scene files: what becomes of its crashes, hangs and nonsense, and of files that bring Assimp
// down.
#include "oc_core/scene/scene_reader.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <ostream>

#include "oc_core/base/error.h"
#include "oc_core/base/sanitizer.h"
#include "oc_core/scene/scene_file.h"
#include "tests/base/temporary_folder.h"
#include "tests/scene/scene_file_samples.h"

namespace ocelli {
namespace {

namespace fs = std::filesystem;
using test::SceneFileSample;
using test::TemporaryFolder;
using testing::AllOf;
using testing::HasSubstr;
using testing::ThrowsMessage;
using Clock = std::chrono::steady_clock;

constexpr double kGibibyte = 1 << 30;
const std::string kTriangle = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";

constexpr bool kLimitsMemory = !kAddressSanitizer;  // which ends the process in its own way

/// Of this process and of those that it has waited for: the same on a machine with much other work.
double processorSeconds() {
  double seconds = 0;
  for (const auto who : {RUSAGE_SELF, RUSAGE_CHILDREN}) {
    rusage usage{};
    getrusage(who, &usage);
    for (const timeval& time : {usage.ru_utime, usage.ru_stime}) {
      seconds += static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_usec);
    }
  }
  return seconds;
}

/// An environment variable while it lives.
class Variable {
 public:
  Variable(const char* name, const std::string& value) : name_(name) { setenv(name, value.c_str(), 1); }
  ~Variable() { unsetenv(name_); }
  Variable(const Variable&) = delete;
  Variable& operator=(const Variable&) = delete;

 private:
  const char* name_;
};

/// Reads a sound file with a shell script in place of the program that reads scenes.
class FakeReader : public testing::Test {
 protected:
  fs::path makeReader(const std::string& script) const {
    fs::path path = folder_.write("reader", "#!/bin/sh\n" + script + "\n");
    fs::permissions(path, fs::perms::owner_all);
    return path;
  }
  Scene readWith(const std::string& script, const Progress& progress = {}) const {
    const Variable reader("OCELLI_SCENE_READER", makeReader(script).string());
    return readSceneFile(file_, {}, progress);
  }

  TemporaryFolder folder_;
  fs::path file_ = folder_.write("a.obj", kTriangle);
};

TEST_F(FakeReader, CrashIsAnErrorThatNamesTheFileAndTheLastMessage) {
  EXPECT_THAT([&] { readWith("echo first; echo 'Error: bad chunk'; kill -SEGV $$"); },
              ThrowsMessage<InputError>(AllOf(HasSubstr(file_.string()), HasSubstr("Assimp crashed"),
                                              HasSubstr("Segmentation fault"), HasSubstr("Error: bad chunk"),
                                              Not(HasSubstr("first")), HasSubstr("\n  try: "))));
}

TEST_F(FakeReader, MessagesCannotSteerTheTerminal) {
  EXPECT_THAT([&] { readWith("printf '\\033[2Jx'; kill -ABRT $$"); },
              ThrowsMessage<InputError>(AllOf(HasSubstr("Aborted"), Not(HasSubstr("\033")))));
}

TEST_F(FakeReader, LackOfMemoryIsAnError) {
  EXPECT_THAT([&] { readWith("exit 3"); },
              ThrowsMessage<InputError>(AllOf(HasSubstr(file_.string()), HasSubstr("more than 1.0 GiB of memory"),
                                              HasSubstr("OCELLI_SCENE_MEMORY_GIB"))));
  EXPECT_THAT([&] { readWith("kill -KILL $$"); },
              ThrowsMessage<InputError>(AllOf(HasSubstr(file_.string()), HasSubstr("lack of memory"))));
}

TEST_F(FakeReader, CpuTimeThatIsOverIsAnError) {
  EXPECT_THAT([&] { readWith("kill -XCPU $$"); },
              ThrowsMessage<InputError>(AllOf(HasSubstr("longer than 31 s"), HasSubstr("OCELLI_SCENE_SECONDS"))));
}

TEST_F(FakeReader, SleepIsEndedByTheWallClock) {
  const Variable seconds("OCELLI_SCENE_SECONDS", "0.2");
  const auto start = Clock::now();
  EXPECT_THAT([&] { readWith("sleep 1000"); }, ThrowsMessage<InputError>(HasSubstr("took longer than 4 s")));
  EXPECT_LT(Clock::now() - start, std::chrono::seconds(20));
}

TEST_F(FakeReader, NonsenseIsAnErrorOfTheInstallation) {
  EXPECT_THAT([&] { readWith("echo nonsense >&3"); }, ThrowsMessage<WorkError>(HasSubstr("no scene")));
  EXPECT_THAT([&] { readWith("exit 0"); }, ThrowsMessage<WorkError>(HasSubstr("no scene")));
  EXPECT_THAT([&] { readWith("echo cannot >&2; exit 1"); }, ThrowsMessage<WorkError>(HasSubstr("cannot")));
}

TEST_F(FakeReader, ProgressIsCalledAndMayEndIt) {
  struct Stop {};
  const auto start = Clock::now();
  EXPECT_THROW(readWith("sleep 1000", [](std::string_view, double) { throw Stop{}; }), Stop);
  EXPECT_LT(Clock::now() - start, std::chrono::seconds(20));
}

TEST_F(FakeReader, MissingProgramSaysWhatToDo) {
  const Variable reader("OCELLI_SCENE_READER", "/no/such/reader");
  EXPECT_THAT([&] { readSceneFile(file_); },
              ThrowsMessage<WorkError>(AllOf(HasSubstr("/no/such/reader"), HasSubstr("OCELLI_SCENE_READER"))));
}

TEST(SceneReaderProgram, StandsInLibexecAboveTheProgram) {
  const fs::path program = findOwnProgram(sceneReader().program);
  EXPECT_EQ(program.filename(), "ocelli-read-scene");
  EXPECT_EQ(program.parent_path().filename(), "ocelli");
  EXPECT_EQ(access(program.c_str(), X_OK), 0);
}

TEST(SceneReaderProgram, EndsWhereItsParentIsNoMore) {
  // The first process of all is the parent of none that a test starts.
  const std::string command =
      "'" + findOwnProgram(sceneReader().program).string() + "' 1 plain /no/such/file 2>&1 3>/dev/null";
  EXPECT_EQ(WEXITSTATUS(std::system(command.c_str())), kReaderFailed);
}

TEST(ReadingLimits, GrowWithTheFilesUpToTheMachine) {
  const ReadingLimits limits{kGibibyte, 64, 8 * kGibibyte, 30, 1e-6};
  EXPECT_EQ(limits.memoryBytes(0), uint64_t{1} << 30U);
  EXPECT_EQ(limits.memoryBytes(1 << 24), uint64_t{2} << 30U);
  EXPECT_EQ(limits.memoryBytes(uint64_t{1} << 40U), uint64_t{8} << 30U);
  EXPECT_EQ(limits.processorSeconds(10'000'000), 40);
  EXPECT_GT(limits.wallSeconds(0), limits.processorSeconds(0));
}

TEST(ReadingLimits, ComeFromTheEnvironment) {
  const Variable memory("OCELLI_SCENE_MEMORY_GIB", "2.5");
  const Variable seconds("OCELLI_SCENE_SECONDS", "7");
  EXPECT_EQ(readingLimits(sceneReader()).memoryBytes(1 << 30), static_cast<uint64_t>(2.5 * kGibibyte));
  EXPECT_EQ(readingLimits(sceneReader()).processorSeconds(1 << 30), 7);
  for (const char* bad : {"much", "-1", "0", "nan", "1e99", "3 GiB"}) {
    const Variable wrong("OCELLI_SCENE_SECONDS", bad);
    EXPECT_THAT([] { readingLimits(sceneReader()); },
                ThrowsMessage<InputError>(AllOf(HasSubstr("OCELLI_SCENE_SECONDS"), HasSubstr(bad))))
        << bad;
  }
}

TEST(SceneReader, EndsWithinASecondWhereAFewBytesPromiseGigabytes) {
  const TemporaryFolder folder;
  const SceneFileSample sample = test::hostileSceneFiles().front();
  ASSERT_EQ(sample.name, "memory.off");
  const fs::path path = folder.write(sample.name, sample.bytes);
  const double start = processorSeconds();
  EXPECT_THROW(readSceneFile(path), InputError);
  EXPECT_LT(processorSeconds() - start, kLimitsMemory ? 1 : 20);
}

TEST(SceneReader, EndsWhatNeedsMoreMemoryThanItMay) {
  if (!kLimitsMemory) {
    GTEST_SKIP() << "AddressSanitizer ends the process in its own way";
  }
  const TemporaryFolder folder;
  std::string mesh = kTriangle;
  for (int i = 0; i < 200'000; ++i) {
    mesh += "f 1 2 3\n";
  }
  const fs::path path = folder.write("a.obj", mesh);
  EXPECT_EQ(triangleCount(readSceneFile(path)), 200'001u);
  const Variable memory("OCELLI_SCENE_MEMORY_GIB", "0.06");
  EXPECT_THAT([&] { readSceneFile(path); }, ThrowsMessage<InputError>(HasSubstr("GiB of memory")));
}

TEST(SceneReader, ReadsAFileWhoseNameLooksLikeAnOption) {
  const TemporaryFolder folder;
  folder.write("--help.obj", kTriangle);
  const fs::path before = fs::current_path();
  fs::current_path(folder.path());
  EXPECT_EQ(triangleCount(readSceneFile("--help.obj")), 1u);
  fs::current_path(before);
}

TEST(SceneReader, ReadsFilesWhoseNamesAreNotUtf8) {
  const TemporaryFolder folder;
  EXPECT_EQ(triangleCount(readSceneFile(folder.write("caf\xe9.obj", kTriangle))), 1u);
}

void expectSceneOrClearError(const SceneFileSample& sample) {
  const TemporaryFolder folder;
  const fs::path path = folder.write(sample.name, sample.bytes);
  const auto start = Clock::now();
  try {
    const Scene scene = readSceneFile(path);
    validate(flatten(scene), path.string());
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(), AllOf(HasSubstr(path.string()), HasSubstr("\n  try: ")));
  }
  EXPECT_LT(Clock::now() - start, std::chrono::seconds(60));
}

class HostileSceneFile : public testing::TestWithParam<SceneFileSample> {};

TEST_P(HostileSceneFile, IsAnErrorThatSaysWhatToDo) {
  const Variable seconds("OCELLI_SCENE_SECONDS", "5");
  expectSceneOrClearError(GetParam());
}

INSTANTIATE_TEST_SUITE_P(Files, HostileSceneFile, testing::ValuesIn(test::hostileSceneFiles()), [](const auto& test) {
  std::string name = test.param.name;
  std::replace(name.begin(), name.end(), '.', '_');
  return name;
});

class SmallSceneFile : public testing::TestWithParam<SceneFileSample> {};

TEST_P(SmallSceneFile, IsAnErrorWhereverItEnds) {
  const std::string& bytes = GetParam().bytes;
  for (size_t part = 1; part <= 4; ++part) {
    expectSceneOrClearError({GetParam().name, bytes.substr(0, bytes.size() * part / 4)});
  }
}

INSTANTIATE_TEST_SUITE_P(Files, SmallSceneFile, testing::ValuesIn(test::smallSceneFiles()), [](const auto& test) {
  std::string name = test.param.name;
  std::replace(name.begin(), name.end(), '.', '_');
  return name;
});

}  // namespace

namespace test {
// The parameter as tests are listed with it: without this, as raw bytes.
void PrintTo(const SceneFileSample& sample, std::ostream* out) {
  *out << sample.name;
}
}  // namespace test
}  // namespace ocelli
