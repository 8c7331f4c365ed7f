#include "tests/remote_server/hostile_requests.h"

#include <gtest/gtest.h>
#include <malloc.h>

#include <algorithm>
#include <array>
#include <deque>

#include "oc_core/base/random.h"
#include "oc_core/base/sanitizer.h"
#include "tests/remote_server/fake_images.h"

namespace ocelli::test {
namespace {

constexpr const char* kBesiegedToken = "0123456789abcdef0123";

class Attacker {
 public:
  Attacker(int port, std::string token, uint64_t seed) : port_(port), token_(std::move(token)), random_(seed) {}

  size_t below(size_t limit) { return random_.below(limit); }
  bool chance(size_t one, size_t in) { return below(in) < one; }
  template <class List>
  const auto& oneOf(const List& list) {
    return list[below(std::size(list))];
  }
  std::string randomBytes(size_t maxCount) {
    std::string bytes(below(maxCount + 1), '\0');
    for (char& byte : bytes) {
      byte = static_cast<char>(below(256));
    }
    return bytes;
  }
  /// Some bytes of it are changed, left out or doubled.
  std::string mutated(std::string text) {
    for (size_t i = 0, changes = 1 + below(4); i < changes && !text.empty(); ++i) {
      const size_t at = below(text.size());
      switch (below(3)) {
        case 0:
          text[at] = static_cast<char>(below(256));
          break;
        case 1:
          text.erase(at, 1 + below(8));
          break;
        default:
          text.insert(at, text.substr(at, 1 + below(64)));
      }
    }
    return text;
  }
  std::string path() const { return "/ws?token=" + token_; }
  int port() const { return port_; }

  RawSocket connect() { return RawSocket(port_, "127.0.0." + std::to_string(2 + below(50))); }
  /// A client that the server takes, before it turns hostile.
  TestWebSocket webSocket() {
    TestWebSocket socket(port_, {.path = path()}, "127.0.0." + std::to_string(2 + below(50)));
    ++tried_;
    taken_ += socket.isOpen() ? 1 : 0;
    return socket;
  }
  /// Of those.
  double shareTaken() const { return static_cast<double>(taken_) / static_cast<double>(std::max<size_t>(tried_, 1)); }

  void sendRaw(const std::string& bytes) {
    RawSocket socket = connect();
    socket.send(bytes);
    leave(std::move(socket));
  }
  void sendFrames(const std::string& frames) {
    TestWebSocket socket = webSocket();
    socket.socket().send(frames);
    leave(std::move(socket.socket()));
  }
  /// In one of the ways in which clients go; some stay and say nothing for a while.
  void leave(RawSocket socket) {
    constexpr size_t kMaxHeld = 24;
    switch (below(8)) {
      case 0:
        socket.receive(1 << 12, std::chrono::milliseconds(below(4)));
        socket.close();
        break;
      case 1:
      case 2:
        socket.close();
        break;
      case 3:
        held_.push_back(std::move(socket));
        break;
      default:
        socket.reset();
    }
    if (held_.size() > kMaxHeld) {
      held_.front().reset();
      held_.pop_front();
    }
  }

 private:
  int port_;
  std::string token_;
  Random random_;
  std::deque<RawSocket> held_;
  size_t tried_ = 0;
  size_t taken_ = 0;
};

void sendGarbage(Attacker& attacker) {
  attacker.sendRaw(attacker.randomBytes(2000));
}

void sendBrokenHttp(Attacker& attacker) {
  static const std::array<std::string, 16> kRequests{"GET",
                                                     "GET /",
                                                     "GET / HTTP/9.9\r\n\r\n",
                                                     "\r\n\r\n\r\n",
                                                     "GET  / HTTP/1.1\r\n\r\n",
                                                     "get / http/1.1\r\n\r\n",
                                                     "BREW /pot HTTP/1.1\r\nHost: localhost\r\n\r\n",
                                                     "PRI * HTTP/2.0\r\n\r\nSM\r\n\r\n",
                                                     "GET http://example.org/ HTTP/1.1\r\nHost: localhost\r\n\r\n",
                                                     "OPTIONS * HTTP/1.1\r\nHost: localhost\r\n\r\n",
                                                     "CONNECT localhost:80 HTTP/1.1\r\nHost: localhost\r\n\r\n",
                                                     "GET /%00%ff%zz/../.. HTTP/1.1\r\nHost: localhost\r\n\r\n",
                                                     "GET / HTTP/1.1\nHost: localhost\n\n",
                                                     "GET / HTTP/1.1\r\nHost localhost\r\n: x\r\n\r\n",
                                                     "GET / HTTP/1.1\r\nHost: localhost\r\n folded: x\r\n\r\n",
                                                     std::string("GET /\0 HTTP/1.1\r\nHost: localhost\r\n\r\n", 37)};
  attacker.sendRaw(attacker.chance(1, 2) ? attacker.oneOf(kRequests) : attacker.mutated(attacker.oneOf(kRequests)));
}

void sendLongHeaders(Attacker& attacker) {
  std::string request =
      "GET /" + std::string(attacker.chance(1, 2) ? attacker.below(20'000) : 0, 'a') + " HTTP/1.1\r\n";
  for (size_t i = 0, lines = attacker.below(200); i < lines; ++i) {
    request += "X-" + std::to_string(i) + ": " + std::string(attacker.below(300), 'b') + "\r\n";
  }
  attacker.sendRaw(request + (attacker.chance(1, 2) ? "Host: localhost\r\n\r\n" : ""));
}

void sendBodies(Attacker& attacker) {
  static const std::array<std::string, 5> kHeads{"Content-Length: 99999999999999999999\r\n\r\n",
                                                 "Content-Length: -1\r\n\r\n",
                                                 "Transfer-Encoding: chunked\r\n\r\nFFFFFFFFFFFFFFFF\r\n",
                                                 "Content-Length: 10\r\nTransfer-Encoding: chunked\r\n\r\n",
                                                 "Expect: 100-continue\r\nContent-Length: 1000000\r\n\r\n"};
  attacker.sendRaw("POST / HTTP/1.1\r\nHost: localhost\r\n" + attacker.oneOf(kHeads) + attacker.randomBytes(3000));
}

void sendWrongNames(Attacker& attacker) {
  static const std::array<std::string, 5> kHosts{"example.org", "127.0.0.1.example.org",
                                                 "localhost\r\nHost: example.org", "[::1", "\xff\xfe"};
  static const std::array<std::string, 4> kOrigins{"http://example.org", "null", "https://localhost", "file://"};
  Handshake handshake{.path = attacker.path()};
  (attacker.chance(1, 2) ? handshake.host : handshake.origin) =
      attacker.chance(1, 2) ? attacker.oneOf(kHosts) : attacker.oneOf(kOrigins);
  TestWebSocket socket(attacker.port(), handshake);
  EXPECT_FALSE(socket.isOpen()) << handshake.host << handshake.origin;
}

void sendWrongTokens(Attacker& attacker) {
  static const std::array<std::string, 6> kTokens{"",
                                                  "?token=",
                                                  "?token=0123456789abcdef0124",
                                                  "?token=0123456789abcdef012",
                                                  "?token=%30123456789abcdef0123x",
                                                  "?TOKEN=0123456789abcdef0123"};
  const std::string token = attacker.oneOf(kTokens);
  if (attacker.chance(1, 2)) {
    TestWebSocket socket(attacker.port(), {.path = "/ws" + token});
    EXPECT_FALSE(socket.isOpen()) << token;
  } else {
    RawSocket socket = attacker.connect();
    socket.send("GET /" + token + " HTTP/1.1\r\nHost: localhost\r\n\r\n");
    const std::string answer = socket.receiveAll();
    EXPECT_FALSE(answer.starts_with("HTTP/1.1 200")) << token;
  }
}

void sendBrokenHandshakes(Attacker& attacker) {
  static const std::array<std::string, 6> kMore{
      "Sec-WebSocket-Protocol: a, b, c\r\n",
      "Sec-WebSocket-Extensions: permessage-deflate; client_max_window_bits\r\n",
      "Sec-WebSocket-Key: x\r\n",
      "Upgrade: h2c\r\n",
      "Connection: close\r\n",
      "Sec-WebSocket-Version: 8\r\n"};
  const std::string right = bytesOf(Handshake{.path = attacker.path(), .more = attacker.oneOf(kMore)}, attacker.port());
  attacker.sendRaw(attacker.chance(1, 4) ? right : attacker.mutated(right));
}

std::string randomFrame(Attacker& attacker) {
  Frame frame;
  frame.opcode = static_cast<int>(attacker.below(16));
  frame.payload = attacker.randomBytes(attacker.chance(1, 10) ? 3000 : 130);
  frame.isLast = attacker.chance(2, 3);
  frame.reservedBits = attacker.chance(1, 4) ? static_cast<int>(attacker.below(8)) : 0;
  frame.isMasked = attacker.chance(3, 4);
  return bytesOf(frame);
}

void sendRandomFrames(Attacker& attacker) {
  std::string frames;
  for (size_t i = 0, count = 1 + attacker.below(5); i < count; ++i) {
    frames += randomFrame(attacker);
  }
  attacker.sendFrames(frames);
}

void sendHugeLengths(Attacker& attacker) {
  static constexpr std::array<uint64_t, 7> kLengths{
      16'385, 65'535, 65'536, (1ULL << 31U) - 1, 1ULL << 32U, (1ULL << 63U) - 1, ~0ULL};
  attacker.sendFrames(bytesOf(Frame{.opcode = static_cast<int>(attacker.below(11)),
                                    .payload = attacker.randomBytes(5000),
                                    .saidLength = attacker.oneOf(kLengths)}));
}

void sendFragments(Attacker& attacker) {
  std::string frames = bytesOf(Frame{.payload = "{", .isLast = false});
  const size_t bytes = attacker.chance(1, 2) ? 0 : 200;
  for (size_t i = 0, count = attacker.below(200); i < count; ++i) {
    frames += bytesOf(Frame{.opcode = attacker.chance(1, 20) ? Frame::kPing : Frame::kContinuation,
                            .payload = std::string(bytes / 2, ' '),
                            .isLast = false});
  }
  attacker.sendFrames(frames);
}

void sendWrongText(Attacker& attacker) {
  static const std::array<std::string, 8> kTexts{
      "\xc0\xaf", "\xed\xa0\x80",   "\xf5\x80\x80\x80",   "{\"type\":\"\xff\"}",
      "\xe2\x82", "\xef\xbb\xbf{}", std::string("\0", 1), "\xf0\x9f\x98"};
  attacker.sendFrames(bytesOf(Frame{.payload = attacker.oneOf(kTexts) + (attacker.chance(1, 2) ? "x" : "")}));
}

void sendBombs(Attacker& attacker) {
  const size_t depth = attacker.below(16'000);
  static const std::array<std::string, 4> kParts{"[", "{\"a\":", "[{\"a\":[", "1e999,"};
  const std::string& part = attacker.oneOf(kParts);
  std::string bomb;
  while (bomb.size() + part.size() <= depth) {
    bomb += part;
  }
  attacker.sendFrames(bytesOf(Frame{.payload = bomb}));
}

void sendWrongLooks(Attacker& attacker) {
  static const std::array<std::pair<const char*, const char*>, 12> kChanges{{{"\"sequence\":1", "\"sequence\":-1"},
                                                                             {"\"sequence\":1", "\"sequence\":1e30"},
                                                                             {"\"sequence\":1", "\"sequence\":\"1\""},
                                                                             {"1280", "1"},
                                                                             {"1280", "99999999999"},
                                                                             {"1280", "NaN"},
                                                                             {"\"look\"", "\"Look\""},
                                                                             {"\"look\"", "7"},
                                                                             {"\"eye\"", "\"EYE\""},
                                                                             {"\"view\"", "\"view\":null,\"v\""},
                                                                             {"[0.0,", "[null,"},
                                                                             {"[0.0,", "[1e400,"}}};
  TestWebSocket socket = attacker.webSocket();
  for (size_t i = 0, count = 1 + attacker.below(4); i < count; ++i) {
    std::string look = lookText(1);
    const auto& [from, to] = attacker.oneOf(kChanges);
    if (const size_t at = look.find(from); at != std::string::npos) {
      look.replace(at, std::string_view(from).size(), to);
    } else {
      look = attacker.mutated(look);
    }
    socket.sendText(look);
  }
  attacker.leave(std::move(socket.socket()));
}

void looksAndGoes(Attacker& attacker) {
  TestWebSocket socket = attacker.webSocket();
  for (uint32_t i = 0; i < 1 + attacker.below(5); ++i) {
    socket.sendText(lookText(i));
  }
  attacker.leave(std::move(socket.socket()));
}

void stopsInTheMiddle(Attacker& attacker) {
  const std::string request = attacker.chance(1, 2) ? bytesOf(Handshake{.path = attacker.path()}, attacker.port())
                                                    : bytesOf(Handshake{.path = attacker.path()}, attacker.port()) +
                                                          bytesOf(Frame{.payload = lookText(1)});
  attacker.sendRaw(request.substr(0, attacker.below(request.size())));
}

void sendControlFrames(Attacker& attacker) {
  std::string frames;
  for (size_t i = 0, count = 1 + attacker.below(60); i < count; ++i) {
    frames += bytesOf(
        Frame{.opcode = attacker.chance(3, 4) ? Frame::kPing : Frame::kPong, .payload = attacker.randomBytes(125)});
  }
  frames += attacker.chance(1, 2) ? bytesOf(Frame{.opcode = Frame::kClose, .payload = attacker.randomBytes(125)}) : "";
  attacker.sendFrames(frames);
}

void sendManyAtOnce(Attacker& attacker) {
  std::string requests;
  for (size_t i = 0, count = 2 + attacker.below(20); i < count; ++i) {
    requests += attacker.chance(1, 2) ? "GET /remote.js HTTP/1.1\r\nHost: localhost\r\n\r\n"
                                      : bytesOf(Handshake{.path = attacker.path()}, attacker.port());
  }
  attacker.sendRaw(requests);
}

struct HostileKind {
  const char* name;
  void (*send)(Attacker&);
};
constexpr std::array<HostileKind, 17> kHostileKinds{{{"garbage", sendGarbage},
                                                     {"broken HTTP", sendBrokenHttp},
                                                     {"long headers", sendLongHeaders},
                                                     {"bodies", sendBodies},
                                                     {"wrong names", sendWrongNames},
                                                     {"wrong tokens", sendWrongTokens},
                                                     {"broken handshakes", sendBrokenHandshakes},
                                                     {"random frames", sendRandomFrames},
                                                     {"huge lengths", sendHugeLengths},
                                                     {"fragments", sendFragments},
                                                     {"invalid UTF-8", sendWrongText},
                                                     {"bombs", sendBombs},
                                                     {"wrong looks", sendWrongLooks},
                                                     {"looks and goes", looksAndGoes},
                                                     {"stops in the middle", stopsInTheMiddle},
                                                     {"control frames", sendControlFrames},
                                                     {"many at once", sendManyAtOnce}}};

size_t bytesInUse() {
  malloc_trim(0);
  return mallinfo2().uordblks;
}

}  // namespace

RemoteServerSetup besiegedSetup() {
  RemoteServerSetup setup = fakeSetup();
  setup.access.token = kBesiegedToken;
  setup.limits.clients = 100;
  setup.limits.connectionsPerAddress = 100;
  setup.limits.handshakeSeconds = 2;
  setup.drawThreads = 2;
  return setup;
}

void sendHostileRequests(int port, const std::string& token, size_t count, uint64_t seed) {
  Attacker attacker(port, token, seed);
  for (size_t i = 0; i < count; ++i) {
    kHostileKinds[i % kHostileKinds.size()].send(attacker);
  }
  // Not turned away at the door: what they send as clients is read.
  EXPECT_GE(attacker.shareTaken(), 0.95);
}

void expectToSurvive(size_t count, uint64_t seed) {
  const RemoteServer server(besiegedSetup());
  const auto waitUntilAllAreGone = [&] {
    return eventually([&] {
      const RemoteServerCounts counts = server.counts();
      return counts.connectionsNow == 0 && counts.imageBytesNow == 0;
    });
  };
  constexpr size_t kWarmUp = 500;
  sendHostileRequests(server.port(), kBesiegedToken, kWarmUp, seed + 1);
  ASSERT_TRUE(waitUntilAllAreGone());
  const size_t before = bytesInUse();
  sendHostileRequests(server.port(), kBesiegedToken, count, seed);
  ASSERT_TRUE(waitUntilAllAreGone());
  if (!kAddressSanitizer) {  // which looks for leaks itself
    // What stays of a connection would be seen by the thousand: one byte a request is less than any object.
    EXPECT_LE(bytesInUse(), before + 65'536 + count);
  }
  // All that have a wrong name or a wrong token, which are two of the kinds.
  EXPECT_GE(server.counts().refused, 2 * (count / kHostileKinds.size()));
  TestWebSocket client(server.port(), {.path = std::string("/ws?token=") + kBesiegedToken});
  ASSERT_TRUE(client.isOpen()) << client.answer();
  ASSERT_TRUE(client.sendText(lookText(77)));
  const auto image = awaitImage(client);
  ASSERT_TRUE(image);
  EXPECT_EQ(image->header.sequence, 77u);
}

}  // namespace ocelli::test
