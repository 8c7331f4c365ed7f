// Feeds over RTSP on this machine: FFmpeg's program sends them, is killed, and comes back.
#include <arpa/inet.h>
#include <gtest/gtest.h>
#include <netinet/in.h>
#include <spawn.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <csignal>

#include "oc_core/base/error.h"
#include "oc_core/feeds_live/feeds_run.h"
#include "tests/feeds/made_setup.h"

namespace ocelli {
namespace {

int freePort() {
  const int listener = socket(AF_INET, SOCK_STREAM, 0);
  sockaddr_in address{};
  address.sin_family = AF_INET;
  address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  socklen_t size = sizeof(address);
  bind(listener, reinterpret_cast<sockaddr*>(&address), size);
  getsockname(listener, reinterpret_cast<sockaddr*>(&address), &size);
  close(listener);
  return ntohs(address.sin_port);
}

/// Sends a moving picture of 64x48 at 15 frames a second; tries until somebody listens.
class Sender {
 public:
  explicit Sender(const std::string& address) {
    std::string script =
        "while :; do ffmpeg -loglevel quiet -re -f lavfi -i testsrc2=size=64x48:rate=15 -c:v libx264 -preset ultrafast "
        "-tune zerolatency -g 5 -threads 1 -f rtsp -rtsp_transport tcp " +
        address + " </dev/null; sleep 0.2; done";
    std::array<std::string, 3> words{"sh", "-c", script};
    std::array<char*, 4> arguments{words[0].data(), words[1].data(), words[2].data(), nullptr};
    posix_spawnattr_t attributes;
    posix_spawnattr_init(&attributes);
    posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETPGROUP);
    posix_spawnattr_setpgroup(&attributes, 0);
    EXPECT_EQ(posix_spawn(&process_, "/bin/sh", nullptr, &attributes, arguments.data(), environ), 0);
    posix_spawnattr_destroy(&attributes);
  }
  ~Sender() {
    kill(-process_, SIGKILL);
    waitpid(process_, nullptr, 0);
  }
  Sender(const Sender&) = delete;
  Sender& operator=(const Sender&) = delete;

 private:
  pid_t process_ = 0;
};

FeedSetup liveSetup() {
  FeedSetup setup = test::tSetup();
  for (Feed& feed : setup.feeds) {
    feed.width = 64;
    feed.height = 48;
    feed.lens.focal = {50, 50};
    feed.lens.center = {32, 24};
    feed.source = "rtsp://127.0.0.1:" + std::to_string(freePort()) + "/" + feed.name;
    feed.ffmpegOptions = {"rtsp_flags=listen"};
  }
  // Nobody is there, ever.
  setup.feeds[2].source = "tcp://127.0.0.1:" + std::to_string(freePort());
  setup.feeds[2].ffmpegOptions.clear();
  setup.output.width = 64;
  setup.output.height = 48;
  return setup;
}

TEST(LiveFeeds, oneThatIsLostComesBackAndHoldsNobodyUp) {
  const FeedSetup setup = liveSetup();
  const Sender stem(setup.feeds[0].source);
  auto left = std::make_unique<Sender>(setup.feeds[1].source);
  enum class Stage { kStarting, kBoth, kKilled, kSentAgain, kBack };
  Stage stage = Stage::kStarting;
  double since = 0;
  double start = 0;
  double oldestLeft = 0;
  std::vector<double> stemAges;
  FeedsRunOptions options;
  options.framesPerSecond = 15;
  options.seconds = 90;
  options.streams.maxSilenceSeconds = 30;
  options.isStopped = [&] { return stage == Stage::kBack; };
  std::vector<int> remarked(3, 0);
  options.remarkOn = [&](size_t feed, const Image<Rgb8>&) { return std::to_string(++remarked[feed]); };
  const auto enter = [&](Stage next, double seconds) {
    stage = next;
    since = seconds;
  };
  const FeedsRunFigures figures = runFeeds(setup, options, [&](const ComposedFrame& frame) {
    start = start == 0 ? frame.seconds : start;
    const double leftAge = frame.seconds - frame.feedSeconds[1];  // NaN before its first frame
    const double here = frame.seconds - since;
    if (stage != Stage::kStarting) {
      stemAges.push_back(frame.seconds - frame.feedSeconds[0]);
    }
    if (stage == Stage::kStarting && leftAge < 1 && frame.seconds - frame.feedSeconds[0] < 1) {
      enter(Stage::kBoth, frame.seconds);
    } else if (stage == Stage::kBoth && here > 1) {
      left.reset();
      enter(Stage::kKilled, frame.seconds);
    } else if (stage == Stage::kKilled && here > 1.5) {
      oldestLeft = leftAge;
      left = std::make_unique<Sender>(setup.feeds[1].source);
      enter(Stage::kSentAgain, frame.seconds);
    } else if (stage == Stage::kSentAgain && leftAge < 0.5) {
      enter(Stage::kBack, frame.seconds);
    }
  });
  EXPECT_EQ(stage, Stage::kBack) << figures.feeds[0].message << figures.feeds[1].message;
  EXPECT_TRUE(figures.isLive);
  EXPECT_GT(oldestLeft, 1);
  EXPECT_EQ(figures.feeds[1].reconnections, 1u);
  EXPECT_TRUE(figures.feeds[1].wasLost);
  EXPECT_EQ(figures.feeds[0].reconnections, 0u);
  EXPECT_EQ(remarked, (std::vector<int>{1, 2, 0})) << "a camera may have been moved while it was away";
  EXPECT_EQ(figures.feeds[2].state, FeedState::kLost);
  EXPECT_THAT(figures.feeds[2].message, testing::HasSubstr("start what sends it"));
  // A busy machine is late at times; a second is less than the feed was away.
  std::sort(stemAges.begin(), stemAges.end());
  ASSERT_FALSE(stemAges.empty());
  EXPECT_LT(stemAges[stemAges.size() * 9 / 10], 1);
}

TEST(LiveFeeds, saysWhatToDoWhereNoneComes) {
  FeedSetup setup = liveSetup();
  for (Feed& feed : setup.feeds) {
    feed.source = "v4l2:/dev/video-unplugged";
    feed.ffmpegOptions.clear();
  }
  FeedsRunOptions options;
  options.streams.maxWaitSeconds = 0.2;
  try {
    runFeeds(setup, options, [](const ComposedFrame&) {});
    FAIL() << "there is no such camera";
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(), testing::AllOf(testing::HasSubstr("/dev/video-unplugged"),
                                             testing::HasSubstr("try: connect the camera; `ls /dev/video*`")));
  }
}

}  // namespace
}  // namespace ocelli
