// The server from outside: what it serves, and what it refuses.
#include "oc_core/remote/server/remote_server.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/resource.h>
#include <unistd.h>

#include <atomic>
#include <thread>

#include "oc_core/base/error.h"
#include "oc_core/remote/server/listening_socket.h"
#include "tests/remote_server/fake_images.h"

namespace ocelli::test {
namespace {

using testing::EndsWith;
using testing::HasSubstr;
using testing::Not;
using testing::StartsWith;

std::string ask(int port, const std::string& request) {
  RawSocket socket(port);
  EXPECT_TRUE(socket.isConnected());
  EXPECT_TRUE(socket.send(request));
  const std::string answer = socket.receiveAll();
  EXPECT_TRUE(socket.hasEnded());
  return answer;
}

class RemoteServerTest : public testing::Test {
 protected:
  std::string get(const std::string& path, const std::string& host = "", const std::string& method = "GET") const {
    return ask(server_.port(),
               method + " " + path + " HTTP/1.1\r\nHost: " + (host.empty() ? ours() : host) + "\r\n\r\n");
  }
  std::string ours() const { return "127.0.0.1:" + std::to_string(server_.port()); }
  int port() const { return server_.port(); }

  RemoteServer server_{fakeSetup()};
};

TEST_F(RemoteServerTest, ServesThePage) {
  EXPECT_EQ(server_.pageAddress(), "http://" + ours() + "/");
  EXPECT_THAT(get("/"), StartsWith("HTTP/1.1 200"));
  EXPECT_THAT(get("/"), EndsWith("<title>fake</title>"));
  EXPECT_THAT(get("/remote.js"), EndsWith("\r\n\r\n" + std::string(100'000, ';')));
  EXPECT_THAT(get("/", "", "HEAD"), EndsWith("\r\n\r\n"));
  EXPECT_THAT(get("/other"), StartsWith("HTTP/1.1 404"));
  EXPECT_THAT(get("/../etc/passwd"), StartsWith("HTTP/1.1 404"));
  EXPECT_THAT(get("/", "", "POST"), StartsWith("HTTP/1.1 405"));
}

TEST_F(RemoteServerTest, SendsHeadersThatKeepOthersOut) {
  const std::string answer = get("/");
  EXPECT_THAT(answer,
              HasSubstr("default-src 'none'; script-src 'self'; style-src 'self'; connect-src 'self' ws://" + ours()));
  EXPECT_THAT(answer, HasSubstr("frame-ancestors 'none'"));
  EXPECT_THAT(answer, HasSubstr("X-Content-Type-Options: nosniff"));
  EXPECT_THAT(answer, HasSubstr("Referrer-Policy: no-referrer"));
  EXPECT_THAT(answer, Not(HasSubstr("Access-Control")));
  EXPECT_THAT(answer, Not(HasSubstr("unsafe")));
}

TEST_F(RemoteServerTest, RefusesNamesThatAreNotItsOwn) {
  for (const char* host : {"example.org", "127.0.0.1.example.org", "example.org:80", "localhost.example.org", "[::1"}) {
    EXPECT_THAT(get("/", host), StartsWith("HTTP/1.1 403")) << host;
    EXPECT_THAT(TestWebSocket(port(), {.host = host}).answer(), StartsWith("HTTP/1.1 403")) << host;
  }
  EXPECT_THAT(ask(port(), "GET / HTTP/1.0\r\n\r\n"), StartsWith("HTTP/1.1 403")) << "no name at all";
  // `ssh -L 9000:127.0.0.1:PORT` makes browsers ask for another port.
  EXPECT_THAT(get("/", "localhost:9000"), StartsWith("HTTP/1.1 200"));
}

TEST_F(RemoteServerTest, RefusesPagesOfOtherSites) {
  for (const std::string& origin : {std::string("http://example.org"), "https://" + ours(), std::string("null"),
                                    std::string("http://127.0.0.1:1")}) {
    EXPECT_THAT(TestWebSocket(port(), {.origin = origin}).answer(), StartsWith("HTTP/1.1 403")) << origin;
  }
  EXPECT_TRUE(TestWebSocket(port(), {.origin = "http://" + ours()}).isOpen());
  EXPECT_TRUE(TestWebSocket(port(), {.host = "localhost:9000", .origin = "http://localhost:9000"}).isOpen());
}

TEST_F(RemoteServerTest, HasWebSocketsAtOnePathAlone) {
  EXPECT_THAT(TestWebSocket(port(), {.path = "/"}).answer(), StartsWith("HTTP/1.1 404"));
  EXPECT_THAT(get("/ws"), StartsWith("HTTP/1.1 404"));
  const std::string h2c = "GET / HTTP/1.1\r\nHost: " + ours() +
                          "\r\nConnection: Upgrade, HTTP2-Settings\r\nUpgrade: h2c\r\nHTTP2-Settings: AAMAAABk\r\n\r\n";
  EXPECT_THAT(ask(port(), h2c), Not(HasSubstr(" 101 ")));
}

TEST_F(RemoteServerTest, DrawsWhatAClientLooksAt) {
  TestWebSocket client(port());
  ASSERT_TRUE(client.isOpen()) << client.answer();
  ASSERT_TRUE(client.sendText(lookText(7)));
  std::vector<std::string> heard;
  const auto image = awaitImage(client, [&](const RemoteServerMessage& message) {
    heard.push_back(std::holds_alternative<RemoteHello>(message)     ? "hello"
                    : std::holds_alternative<RemoteQueued>(message)  ? "queued"
                    : std::holds_alternative<RemoteDrawing>(message) ? "drawing"
                    : std::holds_alternative<RemoteFailure>(message) ? "error"
                                                                     : "image");
  });
  ASSERT_TRUE(image);
  EXPECT_EQ(image->header.sequence, 7u);
  EXPECT_EQ(heard.front(), "hello");
  EXPECT_THAT(heard, testing::Contains("queued"));
  EXPECT_THAT(heard, testing::Contains("drawing"));
  EXPECT_EQ(heard.back(), "image");
  expectHonestService(port());
}

TEST_F(RemoteServerTest, TakesMessagesInFragmentsWithPingsBetween) {
  TestWebSocket client(port());
  const std::string look = lookText(3);
  ASSERT_TRUE(client.send({.payload = look.substr(0, 10), .isLast = false}));
  ASSERT_TRUE(client.send({.opcode = Frame::kPing, .payload = "?"}));
  ASSERT_TRUE(client.send({.opcode = Frame::kContinuation, .isLast = false}));
  ASSERT_TRUE(client.send({.opcode = Frame::kContinuation, .payload = look.substr(10)}));
  bool isAnswered = false;
  while (!isAnswered) {
    const auto frame = client.receive();
    ASSERT_TRUE(frame);
    isAnswered = frame->opcode == Frame::kPong && frame->payload == "?";
    if (frame->opcode == Frame::kText && frame->payload.find("\"sequence\":3") != std::string::npos) {
      break;
    }
  }
  EXPECT_TRUE(eventually([&] { return server_.counts().looks == 1; }));
}

TEST_F(RemoteServerTest, AnswersWhatItCannotReadAndEndsWhatIsTooMuch) {
  TestWebSocket client(port());
  ASSERT_TRUE(client.receive()) << "hello";
  for (int i = 1; i < 16; ++i) {
    ASSERT_TRUE(client.sendText("{\"type\":\"look\",\"sequence\":-1}"));
    const auto frame = client.receive();
    ASSERT_TRUE(frame);
    EXPECT_THAT(frame->payload, HasSubstr("\"type\":\"error\""));
  }
  ASSERT_TRUE(client.sendText("[]"));
  EXPECT_EQ(client.awaitClose(), 1008);
  EXPECT_TRUE(eventually([&] { return server_.counts().clientsNow == 0; }));
}

TEST_F(RemoteServerTest, ClosesWithTheCodeThatFits) {
  const auto codeFor = [&](const std::string& bytes) {
    TestWebSocket client(port());
    EXPECT_TRUE(client.socket().send(bytes));
    return client.awaitClose();
  };
  EXPECT_EQ(codeFor(bytesOf(Frame{.opcode = Frame::kBinary, .payload = "x"})), 1003);
  EXPECT_EQ(codeFor(bytesOf(Frame{.payload = std::string(20'000, ' ')})), 1009);
  EXPECT_EQ(codeFor(bytesOf(Frame{.opcode = 3})), 1002);
  EXPECT_EQ(codeFor(bytesOf(Frame{.payload = "x", .reservedBits = 4})), 1002);
  EXPECT_EQ(codeFor(bytesOf(Frame{.opcode = Frame::kContinuation, .payload = "x"})), 1002);
  EXPECT_EQ(codeFor(bytesOf(Frame{.payload = "\xff\xfe"})), 1007);
  EXPECT_EQ(codeFor(bytesOf(Frame{.opcode = Frame::kClose, .payload = "\x03\xe8"})), 1000);
  expectHonestService(port());
}

/// RFC 6455 wants such a client refused; libwebsockets 4.1 reads it and does not tell. A mask keeps bytes from proxies,
/// not from servers: what it says is checked like any other message.
TEST_F(RemoteServerTest, ReadsFramesWithoutAMaskAsAnyOther) {
  TestWebSocket client(port());
  ASSERT_TRUE(client.receive()) << "hello";
  ASSERT_TRUE(client.send({.payload = "x", .isMasked = false}));
  const auto frame = client.receive();
  ASSERT_TRUE(frame);
  EXPECT_THAT(frame->payload, HasSubstr("\"type\":\"error\""));
}

TEST(RemoteServer, ClosesAClientThatSaysTooMuch) {
  RemoteServerSetup setup = fakeSetup();
  setup.limits.looksPerSecond = 5;
  const RemoteServer server(std::move(setup));
  TestWebSocket client(server.port());
  // Not on and on: what a server leaves unread makes its kernel drop what it said.
  for (uint32_t i = 0; i < 50 && server.counts().refused == 0; ++i) {
    client.sendText(lookText(i));
  }
  EXPECT_EQ(client.awaitClose(), 1008);
}

TEST(RemoteServer, DrawsForScreensUpToItsLimit) {
  RemoteServerSetup setup = fakeSetup();
  setup.limits.screenPixels = 1000;
  const RemoteServer server(std::move(setup));
  TestWebSocket client(server.port());
  ASSERT_TRUE(client.receive()) << "hello";
  ASSERT_TRUE(client.sendText(lookText(1)));  // 1280 x 720
  const auto frame = client.receive();
  ASSERT_TRUE(frame);
  EXPECT_THAT(frame->payload, HasSubstr("at most 1000 pixels a side"));
  EXPECT_THAT(frame->payload, HasSubstr("\"sequence\":1")) << "its client waits for an answer to this one";
}

/// Where there is no descriptor for a connection, the server rests, and takes it when there is one again.
TEST(RemoteServer, RestsWhereItCanTakeNoConnection) {
  const RemoteServer server(fakeSetup());
  // From here on its threads open nothing of their own.
  expectHonestService(server.port());
  ASSERT_TRUE(eventually([&] { return server.counts().connectionsNow == 0; }));
  // UndefinedBehaviorSanitizer asks the kernel through a pipe about classes that it has not met: below it cannot.
  EXPECT_STRNE(WorkError("an error", "somewhere", "nothing").what(), "");
  rlimit before{};
  ASSERT_EQ(getrlimit(RLIMIT_NOFILE, &before), 0);
  const int next = dup(STDIN_FILENO);
  ASSERT_GE(next, 0);
  close(next);
  rlimit none = before;
  none.rlim_cur = static_cast<rlim_t>(next) + 1;  // for the socket of this client alone
  ASSERT_EQ(setrlimit(RLIMIT_NOFILE, &none), 0);
  RawSocket waiting(server.port());
  const bool hasRested = eventually([&] { return server.counts().rests > 0; });
  std::this_thread::sleep_for(std::chrono::milliseconds(600));
  const size_t rests = server.counts().rests;
  setrlimit(RLIMIT_NOFILE, &before);
  ASSERT_TRUE(waiting.isConnected());
  EXPECT_TRUE(hasRested);
  // It tries five times a second; without a rest it would be thousands of times.
  EXPECT_LT(rests, 20u);
  ASSERT_TRUE(waiting.send("GET / HTTP/1.1\r\nHost: localhost\r\n\r\n"));
  EXPECT_THAT(waiting.receiveAll(), StartsWith("HTTP/1.1 200"));
}

/// A note that throws is what it writes to that fails: clients are served all the same, or hear of it.
TEST(RemoteServer, GoesOnWhereItsNotesFail) {
  RemoteServerSetup setup = fakeSetup();
  std::atomic<bool> fails = false;
  setup.note = [&](const std::string&) {
    if (fails) {
      throw WorkError("the disk is full", "log", "wait");
    }
  };
  const RemoteServer server(std::move(setup));
  std::optional<TestWebSocket> client(std::in_place, server.port());
  ASSERT_TRUE(client->isOpen());
  fails = true;
  ASSERT_TRUE(client->sendText(lookText(1)));
  EXPECT_TRUE(awaitImage(*client));
  client.reset();
  EXPECT_TRUE(eventually([&] { return server.counts().connectionsNow == 0; }));
  fails = false;
  expectHonestService(server.port());
}

TEST(ListeningSocket, SaysWhereTooFewFilesMayBeOpen) {
  rlimit limit{};
  ASSERT_EQ(getrlimit(RLIMIT_NOFILE, &limit), 0);
  allowDescriptors(limit.rlim_cur);
  if (limit.rlim_max != RLIM_INFINITY) {
    EXPECT_THROW(allowDescriptors(limit.rlim_max + 1), WorkError);
  }
  rlimit now{};
  ASSERT_EQ(getrlimit(RLIMIT_NOFILE, &now), 0);
  EXPECT_EQ(now.rlim_cur, limit.rlim_cur);
}

TEST(RemoteServer, AsksForItsToken) {
  RemoteServerSetup setup = fakeSetup();
  setup.access.token = "0123456789abcdef";
  const RemoteServer server(std::move(setup));
  const int port = server.port();
  const std::string head = " HTTP/1.1\r\nHost: localhost\r\n\r\n";
  EXPECT_THAT(server.pageAddress(), EndsWith("/?token=0123456789abcdef"));
  EXPECT_THAT(ask(port, "GET /" + head), StartsWith("HTTP/1.1 403"));
  EXPECT_THAT(ask(port, "GET /?token=0123456789abcdee" + head), StartsWith("HTTP/1.1 403"));
  EXPECT_THAT(ask(port, "GET /?token=" + head), StartsWith("HTTP/1.1 403"));
  EXPECT_THAT(ask(port, "GET /?a=b&token=0123456789abcdef" + head), StartsWith("HTTP/1.1 200"));
  EXPECT_THAT(TestWebSocket(port).answer(), StartsWith("HTTP/1.1 403"));
  EXPECT_THAT(TestWebSocket(port, {.path = "/ws?token=wrong"}).answer(), StartsWith("HTTP/1.1 403"));
  EXPECT_TRUE(TestWebSocket(port, {.path = "/ws?token=0123456789abcdef"}).isOpen());
}

TEST(RemoteServer, AsksForATokenWhereOthersReachIt) {
  RemoteServerSetup setup = fakeSetup();
  setup.address = "0.0.0.0";
  EXPECT_THROW(RemoteServer{setup}, InputError);
  setup.access.token = "0123456789abcdef";
  EXPECT_NO_THROW(RemoteServer{setup});
  setup.address = "example.org";
  EXPECT_THROW(RemoteServer{setup}, InputError);
}

TEST_F(RemoteServerTest, ListensOnThisComputerAlone) {
  EXPECT_FALSE(RawSocket(port()).descriptor() < 0);
  RemoteServerSetup setup = fakeSetup();
  setup.port = port();
  try {
    const RemoteServer other(std::move(setup));
    FAIL() << "two servers on one port";
  } catch (const WorkError& error) {
    EXPECT_THAT(error.what(), HasSubstr("another program uses this port already"));
  }
}

TEST(RemoteServer, TakesSoManyClientsAndConnections) {
  RemoteServerSetup setup = fakeSetup();
  setup.limits.clients = 2;
  setup.limits.connectionsPerAddress = 4;
  const RemoteServer server(std::move(setup));
  TestWebSocket first(server.port());
  {
    const TestWebSocket second(server.port(), {}, "127.0.0.2");
    EXPECT_TRUE(first.isOpen() && second.isOpen());
    EXPECT_THAT(TestWebSocket(server.port()).answer(), StartsWith("HTTP/1.1 503"));
    EXPECT_EQ(server.counts().clientsNow, 2u);
  }
  EXPECT_TRUE(eventually([&] { return TestWebSocket(server.port()).isOpen(); })) << "there is room again";
  // Of one address so many; others are not in their way.
  std::vector<RawSocket> silent;
  for (int i = 0; i < 8; ++i) {
    silent.emplace_back(server.port(), "127.0.0.3");
  }
  EXPECT_TRUE(eventually([&] { return server.counts().refused >= 4; }));
  EXPECT_EQ(silent.back().receiveAll(), "");
  EXPECT_TRUE(silent.back().hasEnded());
  EXPECT_TRUE(eventually([&] { return TestWebSocket(server.port()).isOpen(); }));
}

TEST(RemoteServer, WaitsForASlowRequestOnlySoLong) {
  RemoteServerSetup setup = fakeSetup();
  setup.limits.handshakeSeconds = 1;
  const RemoteServer server(std::move(setup));
  RawSocket silent(server.port());
  RawSocket slow(server.port());
  ASSERT_TRUE(slow.send("GET / HT"));
  TestWebSocket client(server.port());
  ASSERT_TRUE(client.send({.payload = "{", .isLast = false}));
  EXPECT_EQ(silent.receiveAll(), "");
  EXPECT_TRUE(silent.hasEnded());
  slow.receiveAll();
  EXPECT_TRUE(slow.hasEnded());
  EXPECT_EQ(client.awaitClose(), 1008) << "the rest of its message does not come";
  EXPECT_TRUE(eventually([&] { return server.counts().connectionsNow == 0; }));
}

TEST(RemoteServer, TellsWhatFails) {
  RemoteServerSetup setup = fakeSetup();
  setup.draw = [](const RemoteRequest&, uint32_t, const std::function<bool()>&) -> std::optional<RemoteImage> {
    throw InputError("nothing to draw", "here", "wait");
  };
  const RemoteServer server(std::move(setup));
  TestWebSocket client(server.port());
  ASSERT_TRUE(client.sendText(lookText(9)));
  for (;;) {
    const auto frame = client.receive();
    ASSERT_TRUE(frame);
    const RemoteServerMessage message = remoteServerMessageFromJson(frame->payload);
    if (const auto* const failure = std::get_if<RemoteFailure>(&message)) {
      EXPECT_THAT(failure->message, HasSubstr("nothing to draw"));
      EXPECT_EQ(failure->sequence, 9u);
      break;
    }
  }
}

TEST(RemoteServer, EndsAlthoughSomebodyIsConnected) {
  std::optional<RemoteServer> server(fakeSetup());
  RawSocket silent(server->port());
  TestWebSocket client(server->port());
  ASSERT_TRUE(client.isOpen());
  server.reset();
  EXPECT_EQ(silent.receiveAll(), "");
  EXPECT_TRUE(silent.hasEnded());
  EXPECT_NE(client.awaitClose(), -1);
}

}  // namespace
}  // namespace ocelli::test
