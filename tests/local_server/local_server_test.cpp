#include "oc_core/local_server/local_server.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/socket.h>
#include <unistd.h>

#include <atomic>
#include <cstring>
#include <stdexcept>

#include "oc_core/base/error.h"
#include "tests/local_server/local_request.h"

namespace ocelli::test {
namespace {

using testing::EndsWith;
using testing::HasSubstr;
using testing::Not;
using testing::StartsWith;

class LocalServerTest : public testing::Test {
 protected:
  std::string get(const std::string& path, const std::string& host = "", const std::string& method = "GET") const {
    return askFor(server_.port(), path, host, method);
  }
  std::string ours() const { return "127.0.0.1:" + std::to_string(server_.port()); }

  std::atomic<int> asked_{0};
  LocalServer server_{
      0, {.option = "--show"}, [this](std::string_view path) -> std::optional<LocalAnswer> {
        ++asked_;
        return path == "/a" ? std::optional(LocalAnswer{"text/plain", "what stands there"}) : std::nullopt;
      }};
};

TEST_F(LocalServerTest, servesWhatStandsAtAPath) {
  EXPECT_EQ(server_.address(), "http://" + ours() + "/");
  EXPECT_THAT(get("/a"), StartsWith("HTTP/1.1 200"));
  EXPECT_THAT(get("/a"), EndsWith("\r\n\r\nwhat stands there"));
  EXPECT_THAT(get("/a", "localhost:" + std::to_string(server_.port())), StartsWith("HTTP/1.1 200"));
  EXPECT_THAT(get("/a", "", "HEAD"), EndsWith("\r\n\r\n"));
  EXPECT_THAT(get("/other"), StartsWith("HTTP/1.1 404"));
}

/// A page of the network that reaches this server by a name of its own sends that name.
TEST_F(LocalServerTest, refusesOtherNames) {
  const std::string port = ":" + std::to_string(server_.port());
  for (const std::string host : {"example.org", "127.0.0.1", "localhost", "127.0.0.1:1", "127.0.0.1.example.org"}) {
    EXPECT_THAT(get("/a", host), StartsWith("HTTP/1.1 403")) << host;
  }
  EXPECT_THAT(get("/a", "example.org" + port), StartsWith("HTTP/1.1 403"));
  EXPECT_THAT(ask(server_.port(), "GET /a HTTP/1.0\r\n\r\n"), StartsWith("HTTP/1.1 403"));
  EXPECT_EQ(asked_, 0);
}

TEST_F(LocalServerTest, canOnlyBeRead) {
  for (const char* method : {"POST", "PUT", "DELETE", "OPTIONS", "PATCH"}) {
    const std::string answer = ask(server_.port(), std::string(method) + " /a HTTP/1.1\r\nHost: " + ours() +
                                                       "\r\nContent-Length: 3\r\nConnection: close\r\n\r\nabc");
    EXPECT_THAT(answer, StartsWith("HTTP/1.1 405")) << method;
    EXPECT_THAT(answer, HasSubstr("Allow: GET, HEAD"));
  }
  EXPECT_EQ(asked_, 0);
}

TEST_F(LocalServerTest, letsNoOtherPageReadIt) {
  const std::string answer = ask(server_.port(), "GET /a HTTP/1.1\r\nHost: " + ours() +
                                                     "\r\nOrigin: http://example.org\r\nConnection: close\r\n\r\n");
  EXPECT_THAT(answer, Not(HasSubstr("Access-Control")));
  EXPECT_THAT(answer, HasSubstr("Cross-Origin-Resource-Policy: same-origin"));
  EXPECT_THAT(answer, HasSubstr("default-src 'none'"));
  EXPECT_THAT(answer, HasSubstr("img-src 'self'"));
  EXPECT_THAT(answer, HasSubstr("frame-ancestors 'none'"));
}

TEST_F(LocalServerTest, listensOnThisComputerAlone) {
  EXPECT_EQ(connectTo("127.0.0.2", server_.port()), -1) << "it would listen on all addresses otherwise";
}

TEST_F(LocalServerTest, saysThatAPortIsTaken) {
  try {
    const LocalServer other(server_.port(), {.option = "--show"}, [](std::string_view) { return std::nullopt; });
    FAIL() << "two servers on one port";
  } catch (const WorkError& error) {
    EXPECT_THAT(error.what(), HasSubstr("another program uses this port already"));
    EXPECT_THAT(error.what(), HasSubstr("--show " + std::to_string(server_.port())));
  }
}

TEST(LocalServer, streamsPieceByPiece) {
  const LocalServer server(0, {.option = "--show", .hasThreads = true}, [](std::string_view) {
    return LocalAnswer{"text/plain", "", [left = 3](char* bytes, size_t) mutable {
                         std::memcpy(bytes, "again ", 6);
                         return left-- > 0 ? size_t{6} : size_t{0};
                       }};
  });
  const std::string request = "GET /a HTTP/1.0\r\nHost: 127.0.0.1:" + std::to_string(server.port()) + "\r\n\r\n";
  EXPECT_THAT(ask(server.port(), request), EndsWith("\r\n\r\nagain again again "));
  EXPECT_THAT(ask(server.port(), request), EndsWith("\r\n\r\nagain again again ")) << "each has its own stream";
}

TEST(LocalServer, endsTheConnectionWhereTheAnswerFails) {
  const LocalServer server(
      0, {}, [](std::string_view) -> std::optional<LocalAnswer> { throw std::runtime_error("no status"); });
  EXPECT_EQ(askFor(server.port(), "/"), "");
  EXPECT_EQ(askFor(server.port(), "/"), "") << "and goes on";
}

/// Whoever connects and says nothing must not keep a program from ending.
TEST(LocalServer, endsAlthoughSomebodyIsConnected) {
  int client = -1;
  {
    const LocalServer server(0, {}, [](std::string_view) { return std::nullopt; });
    client = connectTo("127.0.0.1", server.port());
    EXPECT_GE(client, 0);
  }
  char byte = 0;
  EXPECT_LE(recv(client, &byte, 1, 0), 0);
  close(client);
}

}  // namespace
}  // namespace ocelli::test
