// Outputs of markers, with a receiver at the other end, and without one.
#include "study/markers/marker_output.h"

#include <arpa/inet.h>
#include <fcntl.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <netinet/in.h>
#include <poll.h>
#include <pty.h>
#include <sys/socket.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <set>
#include <utility>

#include "oc_core/base/error.h"
#include "oc_core/base/file_bytes.h"
#include "tests/base/temporary_folder.h"

namespace ocelli::test {
namespace {

using testing::HasSubstr;

Marker sample(int64_t sequence) {
  return {sequence, 1234567890, kAnsweredRight, 3, "gc", "left, or \"so\""};
}

/// A socket on a port of its own that waits for datagrams for a second at most.
class UdpReceiver {
 public:
  UdpReceiver() : socket_(::socket(AF_INET, SOCK_DGRAM | SOCK_CLOEXEC, 0)) {
    sockaddr_in address{};
    address.sin_family = AF_INET;
    address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    socklen_t size = sizeof(address);
    EXPECT_EQ(bind(socket_, reinterpret_cast<sockaddr*>(&address), size), 0);
    EXPECT_EQ(getsockname(socket_, reinterpret_cast<sockaddr*>(&address), &size), 0);
    port_ = ntohs(address.sin_port);
  }
  ~UdpReceiver() { close(); }
  UdpReceiver(const UdpReceiver&) = delete;
  UdpReceiver& operator=(const UdpReceiver&) = delete;

  void close() {
    if (socket_ >= 0) {
      ::close(std::exchange(socket_, -1));
    }
  }
  std::string place() const { return "udp:127.0.0.1:" + std::to_string(port_); }
  std::string receive() const {
    pollfd watched{socket_, POLLIN, 0};
    std::array<char, 1000> bytes{};
    if (poll(&watched, 1, 1000) != 1) {
      return "nothing";
    }
    const ssize_t count = recv(socket_, bytes.data(), bytes.size(), 0);
    return {bytes.data(), static_cast<size_t>(std::max<ssize_t>(count, 0))};
  }

 private:
  int socket_;
  int port_ = 0;
};

TEST(MarkerLines, AreCsv) {
  EXPECT_EQ(lineOf(sample(7)), "7,1234567890,20,answer_right,3,gc,\"left, or \"\"so\"\"\"");
  EXPECT_EQ(lineOf({0, 5, kSessionStarts}), "0,5,1,session_start,,,");
}

TEST(MarkerCodes, AreDifferentAndDocumented) {
  const std::string docs = readFile(OCELLI_SOURCE_DIR "/docs/markers.md", 1'000'000);
  std::set<int> codes;
  for (const MarkerCode& each : kMarkerCodes) {
    EXPECT_GT(each.code, 0);
    EXPECT_TRUE(codes.insert(each.code).second) << each.name;
    EXPECT_THAT(docs, HasSubstr("| " + std::to_string(each.code) + " | `" + each.name + "` | " + each.meaning + " |"));
  }
  EXPECT_THAT(docs, HasSubstr(kMarkerColumns));
  for (const MarkerOutputKind& kind : markerOutputKinds()) {
    EXPECT_THAT(docs, HasSubstr("| `" + kind.form + "` |"));
  }
}

TEST(UdpMarkers, comeAsDatagrams) {
  const UdpReceiver receiver;
  const auto output = openMarkerOutput(receiver.place());
  output->send(sample(0));
  output->send(sample(1));
  EXPECT_EQ(receiver.receive(), lineOf(sample(0)) + "\n");
  EXPECT_EQ(receiver.receive(), lineOf(sample(1)) + "\n");
  EXPECT_EQ(output->counts().sent, 2);
  EXPECT_EQ(output->counts().lost, 0);
}

/// The kernel of this computer says at once that nobody listens; a thousand markers must not wait for anybody.
TEST(UdpMarkers, areLostWithoutWaitingWhereNobodyListens) {
  UdpReceiver receiver;
  const auto output = openMarkerOutput(receiver.place());
  receiver.close();
  const auto before = std::chrono::steady_clock::now();
  for (int i = 0; i < 1000; ++i) {
    output->send(sample(i));
  }
  EXPECT_LT(std::chrono::steady_clock::now() - before, std::chrono::seconds(1)) << "a millisecond each is a wait";
  EXPECT_GT(output->counts().lost, 0);
}

TEST(SerialMarkers, areOneByteEach) {
  int master = -1;
  int slave = -1;
  std::array<char, 256> name{};
  ASSERT_EQ(openpty(&master, &slave, name.data(), nullptr, nullptr), 0);
  const auto output = openMarkerOutput(std::string("serial:") + name.data() + ",9600");
  output->send({0, 1, kSessionStarts});
  output->send({1, 2, kTrialInOther, 0});
  output->send({2, 3, kAnsweredRight, 0});
  std::array<uint8_t, 8> bytes{};
  // The kernel may hand them over one by one.
  for (size_t count = 0; count < 3;) {
    const ssize_t more = read(master, bytes.data() + count, bytes.size() - count);
    ASSERT_GT(more, 0);
    count += static_cast<size_t>(more);
  }
  EXPECT_EQ(bytes[0], 1);
  EXPECT_EQ(bytes[1], 11);
  EXPECT_EQ(bytes[2], 20) << "raw: no byte becomes another";
  EXPECT_EQ(output->counts().sent, 3);
  close(slave);
  close(master);  // it is pulled out
  output->send({3, 4, kTrialEnds, 0});
  EXPECT_EQ(output->counts().lost, 1);
}

/// Nobody reads: the buffer of the device fills up, and the rest is lost.
TEST(SerialMarkers, neverWait) {
  int master = -1;
  int slave = -1;
  std::array<char, 256> name{};
  ASSERT_EQ(openpty(&master, &slave, name.data(), nullptr, nullptr), 0);
  const auto output = openMarkerOutput(std::string("serial:") + name.data());
  constexpr int kMany = 100'000;  // more than a terminal holds
  for (int i = 0; i < kMany; ++i) {
    output->send({i, 1, kTrialEnds, 0});
  }
  EXPECT_EQ(output->counts().sent + output->counts().lost, kMany);
  EXPECT_GT(output->counts().lost, 0);
  close(slave);
  close(master);
}

TEST(FileMarkers, areLinesOfATable) {
  const TemporaryFolder folder;
  const std::string path = (folder / "markers.csv").string();
  const auto output = openMarkerOutput("file:" + path);
  output->send(sample(0));
  output->send(sample(1));
  output->finish();
  EXPECT_EQ(readFile(path, 10'000),
            std::string(kMarkerColumns) + "\r\n" + lineOf(sample(0)) + "\r\n" + lineOf(sample(1)) + "\r\n");
  EXPECT_EQ(output->counts().sent, 2);
  EXPECT_THROW(openMarkerOutput("file:" + path), InputError) << "it is not overwritten";
}

TEST(MarkerOutputs, saysWhatIsWrong) {
  for (const char* text : {"udp", "radio:7", "udp:localhost", "udp::5", "udp:localhost:0", "udp:localhost:65536",
                           "udp:localhost:5x", "serial:", "serial:/dev/null,7", "serial:/dev/null", "file:"}) {
    EXPECT_THROW(openMarkerOutput(text), InputError) << text;
  }
  EXPECT_THROW(openMarkerOutput("serial:/dev/no such device"), WorkError);
  EXPECT_THROW(openMarkerOutput("file:/no such folder/markers.csv"), WorkError);
  EXPECT_THAT(markerOutputForms(), HasSubstr("serial:DEVICE[,BAUD]"));
}

}  // namespace
}  // namespace ocelli::test
