#include "analysis/report/report_folder.h"

#include <gtest/gtest.h>
#include <sys/resource.h>

#include <csignal>
#include <fstream>
#include <iterator>

#include "analysis/report/json_report.h"
#include "oc_core/base/error.h"

namespace ocelli {
namespace {

namespace fs = std::filesystem;

class ReportFolder : public testing::Test {
 protected:
  void SetUp() override {
    const testing::TestInfo* test = testing::UnitTest::GetInstance()->current_test_info();
    root_ = fs::temp_directory_path() / (std::string("ocelli_report_folder_") + test->name());
    fs::remove_all(root_);
    fs::create_directories(root_);
  }
  void TearDown() override { fs::remove_all(root_); }

  static std::string read(const fs::path& path) {
    std::ifstream file(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
  }
  static std::vector<ReportFile> filesWith(const std::string& html) {
    ReportDocument document;
    return {{"report.html", html}, {"report.json", jsonReport(document)}, {"figures/one.svg", "<svg/>"}};
  }
  size_t entries() const {
    return static_cast<size_t>(std::distance(fs::directory_iterator(root_), fs::directory_iterator()));
  }

  fs::path root_;
};

TEST_F(ReportFolder, holdsAllFilesAndNothingBeside) {
  writeReportFolder(root_ / "report", filesWith("one"));
  EXPECT_EQ(read(root_ / "report/report.html"), "one");
  EXPECT_EQ(read(root_ / "report/figures/one.svg"), "<svg/>");
  EXPECT_EQ(entries(), 1U);
}

TEST_F(ReportFolder, aReportGivesWayToTheNext) {
  writeReportFolder(root_ / "report", filesWith("one"));
  std::ofstream(root_ / "report/stale.txt") << "old";
  writeReportFolder((root_ / "report/").string(), filesWith("two"));
  EXPECT_EQ(read(root_ / "report/report.html"), "two");
  EXPECT_FALSE(fs::exists(root_ / "report/stale.txt"));
  EXPECT_EQ(entries(), 1U);
}

TEST_F(ReportFolder, isCheckedBeforeLongWork) {
  checkReportFolder(root_ / "report");
  checkReportFolder(root_);
  EXPECT_EQ(entries(), 0U) << "nothing is left behind";
  std::ofstream(root_ / "letter.txt") << "dear";
  EXPECT_THROW(checkReportFolder(root_), InputError);
  EXPECT_THROW(checkReportFolder(root_ / "missing" / "report"), WorkError);
}

TEST_F(ReportFolder, whatAKilledProcessLeftGoesWithTheNextReport) {
  const pid_t killed = fork();
  if (killed == 0) {
    _exit(0);
  }
  ASSERT_EQ(waitpid(killed, nullptr, 0), killed);
  const fs::path left = root_ / ("report.partial-" + std::to_string(killed));
  fs::create_directories(left / "figures");
  // One that another process is writing now stays.
  const fs::path other = root_ / "report.partial-1";
  fs::create_directories(other);
  writeReportFolder(root_ / "report", filesWith("one"));
  EXPECT_FALSE(fs::exists(left));
  EXPECT_TRUE(fs::exists(other));
  EXPECT_FALSE(fs::exists(unfinishedReportFolder(root_ / "report")));
}

TEST_F(ReportFolder, anEmptyFolderIsTaken) {
  fs::create_directory(root_ / "report");
  writeReportFolder(root_ / "report", filesWith("one"));
  EXPECT_EQ(read(root_ / "report/report.html"), "one");
}

TEST_F(ReportFolder, whatIsNoReportStays) {
  fs::create_directory(root_ / "thesis");
  std::ofstream(root_ / "thesis/chapter.txt") << "precious";
  std::ofstream(root_ / "thesis/report.json") << "{\"format\": 7}";
  std::ofstream(root_ / "file") << "precious";
  for (const char* name : {"thesis", "file"}) {
    try {
      writeReportFolder(root_ / name, filesWith("one"));
      FAIL() << name << " was replaced";
    } catch (const InputError& error) {
      EXPECT_NE(std::string(error.what()).find("is no report"), std::string::npos);
    }
  }
  EXPECT_EQ(read(root_ / "thesis/chapter.txt"), "precious");
  EXPECT_EQ(read(root_ / "file"), "precious");
  EXPECT_EQ(entries(), 2U);
}

TEST_F(ReportFolder, namesCannotLeadOutOfIt) {
  for (const char* name : {"../x", "/x", "", "a/../../x", "a/"}) {
    EXPECT_THROW(writeReportFolder(root_ / "report", {{name, "x"}}), InputError) << name;
  }
  EXPECT_EQ(entries(), 0U);
}

TEST_F(ReportFolder, aDiskThatTakesNoMoreLeavesWhatWasThere) {
  writeReportFolder(root_ / "report", filesWith("one"));
  rlimit before{};
  ASSERT_EQ(getrlimit(RLIMIT_FSIZE, &before), 0);
  const auto handler = std::signal(SIGXFSZ, SIG_IGN);
  rlimit small = before;
  small.rlim_cur = 4096;
  ASSERT_EQ(setrlimit(RLIMIT_FSIZE, &small), 0);
  bool failed = false;
  try {
    writeReportFolder(root_ / "report", filesWith(std::string(100000, 'x')));
  } catch (const WorkError&) {
    failed = true;
  }
  setrlimit(RLIMIT_FSIZE, &before);
  std::signal(SIGXFSZ, handler);
  EXPECT_TRUE(failed);
  EXPECT_EQ(read(root_ / "report/report.html"), "one");
  EXPECT_EQ(entries(), 1U);
}

TEST_F(ReportFolder, aFolderThatCannotBeMadeIsSaid) {
  try {
    writeReportFolder(root_ / "missing" / "report", filesWith("one"));
    FAIL();
  } catch (const WorkError& error) {
    EXPECT_NE(std::string(error.what()).find("missing"), std::string::npos);
  }
}

}  // namespace
}  // namespace ocelli
