// Killing either side of an emulated USB leaves nothing behind, and nobody waiting.
#include <fcntl.h>
#include <gmock/gmock.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>

#include "display_driver/emulator/test_bed_folder.h"
#include "tests/base/temporary_folder.h"
#include "tests/display_driver_usb/usb_bench.h"

namespace ocelli {
namespace {

/// A running emulated_stream, with a folder of its own for temporary files.
class EmulatedStream {
 public:
  explicit EmulatedStream(const std::filesystem::path& folder) {
    std::array<int, 2> ends{};
    EXPECT_EQ(pipe(ends.data()), 0);
    process_ = fork();
    if (process_ == 0) {
      dup2(ends[1], STDOUT_FILENO);
      close(ends[0]);
      setenv("TMPDIR", folder.c_str(), 1);
      execl(OCELLI_EMULATED_STREAM, OCELLI_EMULATED_STREAM, nullptr);
      _exit(127);
    }
    close(ends[1]);
    output_ = fdopen(ends[0], "r");
  }
  ~EmulatedStream() {
    kill(process_, SIGKILL);
    waitpid(process_, nullptr, 0);
    std::fclose(output_);
  }

  pid_t process() const { return process_; }
  std::string nextLine() {
    std::array<char, 256> line{};
    return std::fgets(line.data(), line.size(), output_) == nullptr ? "" : std::string(line.data());
  }

 private:
  pid_t process_ = 0;
  FILE* output_ = nullptr;
};

bool lives(pid_t process) {
  // A process that has ended and that nobody has waited for still has a number.
  std::ifstream file("/proc/" + std::to_string(process) + "/stat");
  std::string number;
  std::string name;
  std::string state;
  return static_cast<bool>(file >> number >> name >> state) && state != "Z" && state != "X";
}

size_t testBedsIn(const std::filesystem::path& folder) {
  return static_cast<size_t>(std::distance(std::filesystem::directory_iterator(folder), {}));
}

using UsbKillTest = UsbTest;

TEST_F(UsbKillTest, aClientEndsWithItsEmulator) {
  const test::TemporaryFolder folder;
  pid_t client = 0;
  {
    EmulatedStream stream(folder.path());
    client = std::atoi(stream.nextLine().c_str());
    ASSERT_GT(client, 0);
    EXPECT_TRUE(lives(client));
    kill(stream.process(), SIGKILL);
    EXPECT_TRUE(becomesTrue([&] { return !lives(client); }));
  }
  EXPECT_EQ(testBedsIn(folder.path()), 1u);
  EXPECT_EQ(sweepTestBeds(folder.path()), 1u);
  EXPECT_EQ(testBedsIn(folder.path()), 0u);
}

TEST_F(UsbKillTest, theDisplayOfAKilledClientIsFree) {
  const test::TemporaryFolder folder;
  EmulatedStream stream(folder.path());
  const pid_t client = std::atoi(stream.nextLine().c_str());
  ASSERT_GT(client, 0);
  EXPECT_EQ(sweepTestBeds(folder.path()), 0u) << "its emulator lives";
  kill(client, SIGKILL);
  EXPECT_EQ(stream.nextLine(), "client ended with 137\n");
  const pid_t next = std::atoi(stream.nextLine().c_str());
  EXPECT_GT(next, 0) << "the second client could not stream";
  EXPECT_NE(next, client);
}

TEST_F(UsbKillTest, signalsAreForTheClient) {
  const test::TemporaryFolder folder;
  EmulatedStream stream(folder.path());
  ASSERT_GT(std::atoi(stream.nextLine().c_str()), 0);
  kill(stream.process(), SIGTERM);
  EXPECT_EQ(stream.nextLine(), "client ended with 143\n");
}

}  // namespace
}  // namespace ocelli
