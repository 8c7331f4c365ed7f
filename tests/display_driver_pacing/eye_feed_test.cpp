#include "display_driver/pacing/eye_feed.h"

#include <arpa/inet.h>
#include <gtest/gtest.h>
#include <netinet/in.h>
#include <sys/socket.h>
#include <unistd.h>

#include <array>
#include <string_view>
#include <thread>

#include "oc_core/base/error.h"
#include "tests/base/temporary_folder.h"

namespace ocelli {
namespace {

using namespace std::chrono_literals;

const HostTime kNow(100s);

template <class Condition>
bool comesTrue(Condition&& condition) {
  const auto end = std::chrono::steady_clock::now() + 20s;
  while (!condition()) {
    if (std::chrono::steady_clock::now() > end) {
      return false;
    }
    std::this_thread::sleep_for(1ms);
  }
  return true;
}

/// Lines of a tracker, as somebody writes them.
class Pipe {
 public:
  Pipe() { EXPECT_EQ(pipe(ends_.data()), 0); }
  ~Pipe() {
    end();
    close(ends_[0]);
  }
  void write(std::string_view text) {
    EXPECT_EQ(::write(ends_[1], text.data(), text.size()), static_cast<ssize_t>(text.size()));
  }
  void end() {
    if (ends_[1] >= 0) {
      close(ends_[1]);
      ends_[1] = -1;
    }
  }
  int reading() const { return ends_[0]; }

 private:
  std::array<int, 2> ends_{};
};

TEST(EyeFeedTest, aPathIsWalkedFromTheFirstQuestionOn) {
  const test::TemporaryFolder folder;
  const auto path = folder.write("way.csv", "time,x,y,z\n5,0,0,10\n7,4,0,10\n").string();
  const auto feed = openEyeFeed(path, false);
  EXPECT_EQ(feed->eyeAt(kNow), glm::vec3(0, 0, 10));
  EXPECT_EQ(feed->eyeAt(kNow + 500ms), glm::vec3(1, 0, 10));
  EXPECT_FALSE(feed->ended(kNow + 2s));
  EXPECT_TRUE(feed->ended(kNow + 2001ms));
  EXPECT_EQ(feed->eyeAt(kNow + 1h), glm::vec3(4, 0, 10));
  const auto again = openEyeFeed(path, true);
  EXPECT_EQ(again->eyeAt(kNow), glm::vec3(0, 0, 10));
  EXPECT_EQ(again->eyeAt(kNow + 2500ms), glm::vec3(1, 0, 10));
  EXPECT_FALSE(again->ended(kNow + 1h));
}

TEST(EyeFeedTest, ofLiveLinesTheLastOneCounts) {
  Pipe pipe;
  const auto feed = eyeFeedFromLines(pipe.reading());
  EXPECT_FALSE(feed->eyeAt(kNow));
  pipe.write("time,x,y,z\r\n0,1,2,3\n0.1,4,5");
  EXPECT_TRUE(comesTrue([&] { return feed->eyeAt(kNow) == glm::vec3(1, 2, 3); }));
  pipe.write(",6\n");
  EXPECT_TRUE(comesTrue([&] { return feed->eyeAt(kNow) == glm::vec3(4, 5, 6); }));
  EXPECT_EQ(feed->malformed(), 0u);
  EXPECT_FALSE(feed->ended(kNow));
  pipe.write("0.05,7,8,9");  // without an end, and earlier than the one before
  pipe.end();
  EXPECT_TRUE(comesTrue([&] { return feed->ended(kNow); }));
  EXPECT_EQ(feed->eyeAt(kNow), glm::vec3(7, 8, 9));
}

TEST(EyeFeedTest, whatIsNoLineIsCountedAndTheFirstIsKept) {
  Pipe pipe;
  const auto feed = eyeFeedFromLines(pipe.reading());
  pipe.write("\x1b[2Jhello\n0,1,2\n0,1,2,3,4\n0,nan,2,3\n0,1e9,2,3\n\n" + std::string(30000, '7') + "\n0,1,2,3\n");
  EXPECT_TRUE(comesTrue([&] { return feed->eyeAt(kNow) == glm::vec3(1, 2, 3); }));
  EXPECT_EQ(feed->malformed(), 6u);
  EXPECT_EQ(feed->firstMalformed(), "not TIME,X,Y,Z (1 value instead of 4): \"\\x1b[2Jhello\"");
}

TEST(EyeFeedTest, itEndsWhileItWaits) {
  Pipe pipe;
  const auto feed = eyeFeedFromLines(pipe.reading());
}

TEST(EyeFeedTest, datagramsAreOneLineEach) {
  // A port that was free a moment ago.
  const int probe = socket(AF_INET, SOCK_DGRAM, 0);
  sockaddr_in there{};
  there.sin_family = AF_INET;
  there.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  ASSERT_EQ(bind(probe, reinterpret_cast<sockaddr*>(&there), sizeof there), 0);
  socklen_t size = sizeof there;
  getsockname(probe, reinterpret_cast<sockaddr*>(&there), &size);
  close(probe);

  const std::string name = "udp:" + std::to_string(ntohs(there.sin_port));
  const auto feed = openEyeFeed(name, false);
  EXPECT_THROW(openEyeFeed(name, false), WorkError);
  const int sender = socket(AF_INET, SOCK_DGRAM, 0);
  const auto send = [&](const std::string& text) {
    sendto(sender, text.data(), text.size(), 0, reinterpret_cast<const sockaddr*>(&there), sizeof there);
  };
  send("3,1,2,3\n");
  EXPECT_TRUE(comesTrue([&] { return feed->eyeAt(kNow) == glm::vec3(1, 2, 3); }));
  send("what?");
  send(std::string(60000, '1'));
  send("");
  send("1,4,5,6");
  EXPECT_TRUE(comesTrue([&] { return feed->eyeAt(kNow) == glm::vec3(4, 5, 6); }));
  EXPECT_EQ(feed->malformed(), 2u);
  EXPECT_FALSE(feed->ended(kNow));
  close(sender);
}

TEST(EyeFeedTest, wrongNamesAreRefused) {
  for (const char* text : {"udp:", "udp:0", "udp:70000", "udp:x", "udp:5005x", "udp:nowhere:5005", "no.csv", "e.txt"}) {
    EXPECT_THROW(openEyeFeed(text, false), InputError) << text;
  }
}

}  // namespace
}  // namespace ocelli
