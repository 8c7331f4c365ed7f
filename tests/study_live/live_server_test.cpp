// Requests by hand, as browsers and worse send them.
#include "study/live/server/live_server.h"

#include <arpa/inet.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <netinet/in.h>
#include <sys/socket.h>
#include <unistd.h>

#include <array>
#include <atomic>
#include <thread>

#include "oc_core/base/error.h"
#include "study/live/live_page.h"

namespace ocelli::test {
namespace {

using testing::EndsWith;
using testing::HasSubstr;
using testing::Not;
using testing::StartsWith;

/// Connects to an address of this computer; -1 where nobody listens there.
int connectTo(const char* host, int port) {
  const int client = socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0);
  sockaddr_in address{};
  address.sin_family = AF_INET;
  address.sin_port = htons(static_cast<uint16_t>(port));
  inet_pton(AF_INET, host, &address.sin_addr);
  if (connect(client, reinterpret_cast<const sockaddr*>(&address), sizeof(address)) != 0) {
    close(client);
    return -1;
  }
  return client;
}

/// All that the server sends until it closes the connection.
std::string ask(int port, const std::string& request) {
  const int client = connectTo("127.0.0.1", port);
  EXPECT_GE(client, 0);
  EXPECT_EQ(send(client, request.data(), request.size(), MSG_NOSIGNAL), static_cast<ssize_t>(request.size()));
  std::string answer;
  std::array<char, 4096> bytes{};
  for (ssize_t count = 1; count > 0;) {
    count = recv(client, bytes.data(), bytes.size(), 0);
    answer.append(bytes.data(), static_cast<size_t>(std::max<ssize_t>(count, 0)));
  }
  close(client);
  return answer;
}

class LiveServerTest : public testing::Test {
 protected:
  std::string get(const std::string& path, const std::string& host = "", const std::string& method = "GET") const {
    return ask(server_.port(), method + " " + path + " HTTP/1.1\r\nHost: " + (host.empty() ? ours() : host) +
                                   "\r\nConnection: close\r\n\r\n");
  }
  std::string ours() const { return "127.0.0.1:" + std::to_string(server_.port()); }

  std::atomic<int> asked_{0};
  LiveServer server_{0, [this] {
                       ++asked_;
                       return std::string(R"({"state":"running"})");
                     }};
};

TEST_F(LiveServerTest, ServesPageScriptAndStatus) {
  EXPECT_EQ(server_.address(), "http://" + ours() + "/");
  EXPECT_THAT(get("/"), StartsWith("HTTP/1.1 200"));
  EXPECT_THAT(get("/"), EndsWith(livePage()));
  EXPECT_THAT(get("/live.js"), EndsWith(liveScript()));
  EXPECT_THAT(get("/status.json"), EndsWith("\r\n\r\n{\"state\":\"running\"}"));
  EXPECT_EQ(asked_, 1);
  EXPECT_THAT(get("/status.json", "localhost:" + std::to_string(server_.port())), StartsWith("HTTP/1.1 200"));
  EXPECT_THAT(get("/other"), StartsWith("HTTP/1.1 404"));
  EXPECT_THAT(get("/../etc/passwd"), StartsWith("HTTP/1.1 404"));
}

/// A page of the network that reaches this server by a name of its own sends that name.
TEST_F(LiveServerTest, RefusesOtherNames) {
  const std::string port = ":" + std::to_string(server_.port());
  for (const std::string host : {"example.org", "127.0.0.1", "localhost", "127.0.0.1:1", "127.0.0.1.example.org"}) {
    EXPECT_THAT(get("/status.json", host), StartsWith("HTTP/1.1 403")) << host;
  }
  EXPECT_THAT(get("/status.json", "example.org" + port), StartsWith("HTTP/1.1 403"));
  EXPECT_THAT(ask(server_.port(), "GET /status.json HTTP/1.0\r\n\r\n"), StartsWith("HTTP/1.1 403"));
  EXPECT_EQ(asked_, 0);
}

TEST_F(LiveServerTest, CanOnlyBeRead) {
  for (const char* method : {"POST", "PUT", "DELETE", "OPTIONS", "PATCH"}) {
    const std::string answer = ask(server_.port(), std::string(method) + " /status.json HTTP/1.1\r\nHost: " + ours() +
                                                       "\r\nContent-Length: 3\r\nConnection: close\r\n\r\nabc");
    EXPECT_THAT(answer, StartsWith("HTTP/1.1 405")) << method;
    EXPECT_THAT(answer, HasSubstr("Allow: GET, HEAD"));
  }
  EXPECT_EQ(asked_, 0);
  EXPECT_THAT(get("/status.json", "", "HEAD"), EndsWith("\r\n\r\n"));
}

TEST_F(LiveServerTest, LetsNoOtherPageReadIt) {
  const std::string answer = ask(server_.port(), "GET /status.json HTTP/1.1\r\nHost: " + ours() +
                                                     "\r\nOrigin: http://example.org\r\nConnection: close\r\n\r\n");
  EXPECT_THAT(answer, Not(HasSubstr("Access-Control")));
  EXPECT_THAT(answer, HasSubstr("Cross-Origin-Resource-Policy: same-origin"));
  EXPECT_THAT(get("/"), HasSubstr("default-src 'none'"));
  EXPECT_THAT(get("/"), HasSubstr("frame-ancestors 'none'"));
}

TEST_F(LiveServerTest, ListensOnThisComputerAlone) {
  EXPECT_EQ(connectTo("127.0.0.2", server_.port()), -1) << "it would listen on all addresses otherwise";
}

TEST_F(LiveServerTest, SaysThatAPortIsTaken) {
  try {
    const LiveServer other(server_.port(), [] { return std::string(); });
    FAIL() << "two servers on one port";
  } catch (const WorkError& error) {
    EXPECT_THAT(error.what(), HasSubstr("another program uses this port already"));
    EXPECT_THAT(error.what(), HasSubstr("--live " + std::to_string(server_.port())));
  }
}

TEST(LiveServer, answersNothingWhereTheStatusFails) {
  const LiveServer server(0, []() -> std::string { throw std::runtime_error("no status"); });
  const std::string request =
      "GET /status.json HTTP/1.1\r\nHost: 127.0.0.1:" + std::to_string(server.port()) + "\r\nConnection: close\r\n\r\n";
  EXPECT_EQ(ask(server.port(), request), "");
  EXPECT_EQ(ask(server.port(), request), "") << "and goes on";
}

/// Whoever connects and says nothing must not keep a session from ending.
TEST(LiveServer, endsAlthoughSomebodyIsConnected) {
  int client = -1;
  {
    const LiveServer server(0, [] { return std::string(); });
    client = connectTo("127.0.0.1", server.port());
    EXPECT_GE(client, 0);
  }
  char byte = 0;
  EXPECT_LE(recv(client, &byte, 1, 0), 0);
  close(client);
}

}  // namespace
}  // namespace ocelli::test
