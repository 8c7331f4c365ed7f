#include "study/gaze/gaze_input.h"

#include <arpa/inet.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <netinet/in.h>
#include <sys/socket.h>
#include <unistd.h>

#include <chrono>
#include <fstream>
#include <thread>

#include "oc_core/base/error.h"
#include "oc_core/base/file_bytes.h"
#include "oc_core/base/steady_time.h"
#include "tests/base/temporary_folder.h"

namespace ocelli::test {
namespace {

using testing::HasSubstr;

/// What comes until there are so many samples, or two seconds are over.
std::vector<GazeRecord> awaitSamples(GazeInput& input, size_t count) {
  std::vector<GazeRecord> all;
  for (const int64_t end = steadyNanoseconds() + 2'000'000'000; all.size() < count && steadyNanoseconds() < end;) {
    for (const GazeRecord& sample : input.take()) {
      all.push_back(sample);
    }
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
  return all;
}

/// A port that nobody uses.
int freePort() {
  const int probe = socket(AF_INET, SOCK_DGRAM | SOCK_CLOEXEC, 0);
  sockaddr_in address{};
  address.sin_family = AF_INET;
  address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  socklen_t size = sizeof(address);
  EXPECT_EQ(bind(probe, reinterpret_cast<sockaddr*>(&address), size), 0);
  EXPECT_EQ(getsockname(probe, reinterpret_cast<sockaddr*>(&address), &size), 0);
  close(probe);
  return ntohs(address.sin_port);
}

class Tracker {
 public:
  explicit Tracker(int port) : socket_(socket(AF_INET, SOCK_DGRAM | SOCK_CLOEXEC, 0)) {
    address_.sin_family = AF_INET;
    address_.sin_port = htons(static_cast<uint16_t>(port));
    address_.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  }
  ~Tracker() { close(socket_); }
  Tracker(const Tracker&) = delete;
  Tracker& operator=(const Tracker&) = delete;

  void send(const std::string& text) const {
    EXPECT_EQ(
        sendto(socket_, text.data(), text.size(), 0, reinterpret_cast<const sockaddr*>(&address_), sizeof(address_)),
        static_cast<ssize_t>(text.size()));
  }

 private:
  int socket_;
  sockaddr_in address_{};
};

GazeLines pixelLines() {
  return {GazeUnit::kPixels, 1000, 1000};
}

TEST(UdpGaze, ComesWithTheTimeOfItsArrival) {
  const int port = freePort();
  GazeInput input(openGazeBytes("udp:127.0.0.1:" + std::to_string(port)), pixelLines());
  const Tracker tracker(port);
  const int64_t before = steadyNanoseconds();
  tracker.send("1,10,20,1\n2,11,21,1\n");
  tracker.send("oops");
  tracker.send("3,12,22,0\n");
  const std::vector<GazeRecord> samples = awaitSamples(input, 3);
  ASSERT_EQ(samples.size(), 3u);
  for (size_t i = 0; i < samples.size(); ++i) {
    EXPECT_EQ(samples[i].deviceTime, static_cast<double>(i + 1));
    EXPECT_GE(samples[i].nanoseconds, i == 0 ? before : samples[i - 1].nanoseconds);
    EXPECT_LE(samples[i].nanoseconds, steadyNanoseconds());
  }
  const GazeCounts counts = input.counts();
  EXPECT_EQ(counts.samples, 3);
  EXPECT_EQ(counts.valid, 2);
  EXPECT_EQ(counts.malformed, 1);
  EXPECT_EQ(counts.lost, 0);
}

TEST(UdpGaze, RefusesAPortThatIsTakenAndPlacesThatAreNone) {
  const int port = freePort();
  const std::string place = "udp:127.0.0.1:" + std::to_string(port);
  const auto first = openGazeBytes(place);
  EXPECT_THROW(openGazeBytes(place), WorkError);
  for (const char* text : {"udp", "udp:", "udp:5010", "udp:127.0.0.1:0", "udp::5", "radio:5", "file:", "file:,norm"}) {
    EXPECT_THROW(openGazeBytes(text), InputError) << text;
  }
  EXPECT_THROW(openGazeBytes("file:/no such folder/gaze.csv"), InputError);
}

TEST(GazeInputs, areDocumentedAndHaveUnits) {
  const std::string docs = readFile(OCELLI_SOURCE_DIR "/docs/gaze.md", 1'000'000);
  for (const GazeInputKind& kind : gazeInputKinds()) {
    EXPECT_THAT(docs, HasSubstr("| `" + kind.form + "` |"));
  }
  EXPECT_EQ(gazeUnitOf("udp:127.0.0.1:5010"), GazeUnit::kPixels);
  EXPECT_EQ(gazeUnitOf("udp:127.0.0.1:5010,norm"), GazeUnit::kShares);
}

TEST(FileGaze, TakesLinesAsTheyAppear) {
  const TemporaryFolder folder;
  const std::filesystem::path path = folder / "gaze.csv";
  std::ofstream file(path);
  file << "1,10,20,1\n" << std::flush;
  GazeInput input(openGazeBytes("file:" + path.string()), pixelLines());
  EXPECT_EQ(awaitSamples(input, 1).size(), 1u);
  file << "2,10,20,1\n3,10," << std::flush;
  EXPECT_EQ(awaitSamples(input, 1).size(), 1u);
  file << "20,1\n" << std::flush;
  const std::vector<GazeRecord> samples = awaitSamples(input, 1);
  ASSERT_EQ(samples.size(), 1u);
  EXPECT_EQ(samples[0].deviceTime, 3) << "a line that came in two pieces";
  EXPECT_EQ(input.counts().malformed, 0);
}

/// As many samples as it is asked for, at once.
class ManyBytes : public GazeBytes {
 public:
  std::string read(int) override {
    if (std::exchange(done_, true)) {
      std::this_thread::sleep_for(std::chrono::milliseconds(5));
      return {};
    }
    std::string text;
    for (int i = 0; i < 100; ++i) {
      text += std::to_string(i) + ",1,1,1\n";
    }
    return text;
  }

 private:
  bool done_ = false;
};

TEST(GazeInput, KeepsTheFirstAndCountsTheRestWhereNobodyTakesThem) {
  GazeInput input(std::make_unique<ManyBytes>(), pixelLines(), 30);
  for (const int64_t end = steadyNanoseconds() + 2'000'000'000;
       input.counts().samples < 100 && steadyNanoseconds() < end;) {
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
  const std::vector<GazeRecord> samples = input.take();
  ASSERT_EQ(samples.size(), 30u);
  EXPECT_EQ(samples.back().deviceTime, 29);
  EXPECT_EQ(input.counts().samples, 100);
  EXPECT_EQ(input.counts().lost, 70);
}

}  // namespace
}  // namespace ocelli::test
