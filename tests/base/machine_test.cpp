#include "oc_core/base/machine.h"

#include <gtest/gtest.h>

#include <cstdlib>

#include "oc_core/base/parallel.h"
#include "tests/base/temporary_folder.h"

namespace ocelli {
namespace {

TEST(MachineTest, hasThreadsAndMemory) {
  const MachineInfo info = machineInfo();
  EXPECT_EQ(info.threads, threadCount());
  EXPECT_GE(info.memoryBytes, uint64_t{1} << 28U);  // a test of ours could not run in less
  EXPECT_GT(info.availableBytes, 0);
  EXPECT_LE(info.availableBytes, info.memoryBytes);
}

class FindProgramTest : public testing::Test {
 protected:
  ~FindProgramTest() override { setenv("PATH", before_.c_str(), 1); }

  test::TemporaryFolder folder_;
  const std::string before_ = std::getenv("PATH");
};

TEST_F(FindProgramTest, looksThroughTheFoldersInTheirOrder) {
  namespace fs = std::filesystem;
  for (const char* sub : {"first", "second", "third"}) {
    fs::create_directory(folder_ / sub);
  }
  folder_.write("first/tool", "not executable");
  for (const char* tool : {"second/tool", "third/tool"}) {
    fs::permissions(folder_.write(tool, "#!/bin/sh"), fs::perms::owner_all);
  }
  fs::create_directory(folder_ / "first/folder");
  setenv("PATH",
         ((folder_ / "first").string() + "::" + (folder_ / "second").string() + ":" + (folder_ / "third").string())
             .c_str(),
         1);
  EXPECT_EQ(findProgram("tool"), folder_ / "second/tool");
  EXPECT_EQ(findProgram("folder"), std::nullopt);
  EXPECT_EQ(findProgram("nothing"), std::nullopt);
}

TEST_F(FindProgramTest, findsNothingWithoutAPath) {
  unsetenv("PATH");
  EXPECT_EQ(findProgram("sh"), std::nullopt);
}

}  // namespace
}  // namespace ocelli
