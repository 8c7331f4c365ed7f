// A recorder that is killed at any instant leaves a file that opens up to the last whole frame.
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <random>
#include <thread>

#include "display_sim/frames/svol_player.h"
#include "oc_core/base/error.h"
#include "tests/base/temporary_folder.h"
#include "tests/display_sim_observing/recorded_frames.h"

namespace ocelli {
namespace {

constexpr int kKills = 100;

class Recorder {
 public:
  explicit Recorder(const std::filesystem::path& file) {
    process_ = fork();
    if (process_ == 0) {
      execl(OCELLI_RECORD_CHILD, OCELLI_RECORD_CHILD, file.c_str(), nullptr);
      _exit(127);
    }
  }
  /// Returns whether it still ran.
  bool kill() {
    ::kill(process_, SIGKILL);
    int status = 0;
    EXPECT_EQ(waitpid(process_, &status, 0), process_);
    return WIFSIGNALED(status) && WTERMSIG(status) == SIGKILL;
  }

 private:
  pid_t process_ = -1;
};

TEST(SvolKilled, aHundredKilledRecordingsOpenUpToTheirLastWholeFrame) {
  const test::TemporaryFolder folder;
  const std::filesystem::path file = folder / "a.svol";
  const std::vector<Volume> volumes = test::killedVolumes();
  std::mt19937 engine(7);
  size_t frames = 0;
  size_t torn = 0;
  for (int kill = 0; kill < kKills; ++kill) {
    std::filesystem::remove(file);
    Recorder recorder(file);
    for (int wait = 0; wait < 100000 && !std::filesystem::exists(file); ++wait) {
      std::this_thread::sleep_for(std::chrono::microseconds(100));
    }
    std::this_thread::sleep_for(std::chrono::microseconds(engine() % 20000));
    ASSERT_TRUE(recorder.kill()) << "it ended on its own";
    SvolReader reader(file);
    EXPECT_EQ(reader.ending(), SvolEnding::kUnfinished);
    EXPECT_FALSE(reader.damage()) << reader.damage()->what();
    frames += reader.frames().size();
    torn += reader.fileBytes() > reader.wholeBytes() ? 1 : 0;
    SvolPlayer player(reader);
    for (size_t k = 0; k < reader.frames().size(); ++k) {
      player.seek(k);
      ASSERT_EQ(player.volume(), volumes[k % volumes.size()]) << "kill " << kill << ", frame " << k;
    }
  }
  EXPECT_GT(frames, 0u) << "no recorder came as far as a frame";
  std::printf("%zu frames in %d recordings, %zu of which end within a frame\n", frames, kKills, torn);
}

}  // namespace
}  // namespace ocelli
