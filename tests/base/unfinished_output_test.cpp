#include "oc_core/base/unfinished_output.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <atomic>
#include <chrono>
#include <csignal>
#include <fstream>
#include <functional>
#include <random>
#include <stdexcept>
#include <thread>

#include "oc_core/base/output_file.h"
#include "tests/base/temporary_folder.h"

namespace ocelli {
namespace {

namespace fs = std::filesystem;

void endBySignal(int signal) {
  removeUnfinishedOutputs();
  std::signal(signal, SIG_DFL);
  std::raise(signal);
}

/// Runs `work` in a process of its own, which a signal ends as it does a program that removes what is unfinished.
/// Returns how it ended.
int statusOf(
    const std::function<void()>& work, const std::function<void(pid_t)>& meanwhile = [](pid_t) {}) {
  const pid_t child = fork();
  if (child == 0) {
    std::signal(SIGTERM, endBySignal);
    work();
    _exit(0);
  }
  meanwhile(child);
  int status = 0;
  waitpid(child, &status, 0);
  return status;
}

bool endedBy(int status, int signal) {
  return WIFSIGNALED(status) && WTERMSIG(status) == signal;
}

TEST(UnfinishedOutput, aSignalTakesFilesAndFoldersAlong) {
  const test::TemporaryFolder folder;
  folder.write("old", "stays");
  const int status = statusOf([&] {
    OutputFile fresh(folder / "fresh");
    fresh.write("half");
    OutputFile again(folder / "old");
    again.write("half");
    const UnfinishedOutput tree(folder / "tree.partial", [&] {
      fs::create_directories(folder / "tree.partial/a/b");
      for (int i = 0; i < 300; ++i) {  // more than one reading of a folder returns
        std::ofstream(folder / "tree.partial/a" / ("a file with a rather long name " + std::to_string(i))) << i;
      }
      std::ofstream(folder / "tree.partial/a/b/c") << "c";
    });
    std::raise(SIGTERM);
  });
  EXPECT_TRUE(endedBy(status, SIGTERM));
  EXPECT_EQ(test::fileBytes(folder / "old"), "stays");
  EXPECT_EQ(std::distance(fs::directory_iterator(folder.path()), {}), 1);
}

TEST(UnfinishedOutput, whatIsFinishedStays) {
  const test::TemporaryFolder folder;
  const int status = statusOf([&] {
    OutputFile file(folder / "a");
    file.write("whole");
    file.commit();
    { OutputFile(folder / "b").write("given up"); }
    OutputFile grows(folder / "c");
    grows.write("so far");
    grows.publish();
    std::raise(SIGTERM);
  });
  EXPECT_TRUE(endedBy(status, SIGTERM));
  EXPECT_EQ(test::fileBytes(folder / "a"), "whole");
  EXPECT_EQ(test::fileBytes(folder / "c"), "so far");
  EXPECT_EQ(std::distance(fs::directory_iterator(folder.path()), {}), 2);
}

TEST(UnfinishedOutput, aFailedMakingIsForgotten) {
  const test::TemporaryFolder folder;
  const std::string path = folder.write("a", "of somebody else").string();
  EXPECT_THROW(UnfinishedOutput(path, [] { throw std::runtime_error("no"); }), std::runtime_error);
  const int status = statusOf([] { std::raise(SIGTERM); });
  EXPECT_TRUE(endedBy(status, SIGTERM));
  EXPECT_EQ(test::fileBytes(path), "of somebody else");
}

TEST(UnfinishedOutput, aForkedProcessRemovesNothingOfItsParent) {
  const test::TemporaryFolder folder;
  OutputFile file(folder / "a");
  file.write("of the parent");
  EXPECT_TRUE(endedBy(statusOf([] { std::raise(SIGTERM); }), SIGTERM));
  file.commit();
  EXPECT_EQ(test::fileBytes(folder / "a"), "of the parent");
}

TEST(UnfinishedOutput, threadsThatWriteAllTheTimeLeaveNothingHalf) {
  std::mt19937 random(7);
  for (int round = 0; round < 60; ++round) {
    const test::TemporaryFolder folder;
    const auto wait = std::chrono::microseconds(random() % 20000);
    const int status = statusOf(
        [&] {
          std::vector<std::jthread> threads;
          for (int t = 0; t < 4; ++t) {
            threads.emplace_back([&, t] {
              for (int i = 0;; ++i) {
                OutputFile file(folder / ("file" + std::to_string(t) + "-" + std::to_string(i % 50)));
                file.write("first ");
                file.flush();
                file.write("second");
                if (i % 3 != 0) {
                  file.commit();
                }
              }
            });
          }
        },
        [&](pid_t child) {
          std::this_thread::sleep_for(wait);
          kill(child, SIGTERM);
        });
    EXPECT_TRUE(endedBy(status, SIGTERM)) << status;
    for (const fs::directory_entry& entry : fs::directory_iterator(folder.path())) {
      EXPECT_THAT(entry.path().string(), testing::Not(testing::EndsWith(".partial")));
      EXPECT_EQ(test::fileBytes(entry.path()), "first second");
    }
  }
}

}  // namespace
}  // namespace ocelli
