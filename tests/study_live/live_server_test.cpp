#include "study/live/server/live_server.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <atomic>

#include "study/live/live_page.h"
#include "tests/local_server/local_request.h"

namespace ocelli::test {
namespace {

using testing::EndsWith;
using testing::HasSubstr;
using testing::StartsWith;

TEST(LiveServer, servesPageScriptAndStatus) {
  std::atomic<int> asked = 0;
  const LiveServer server(0, [&] {
    ++asked;
    return std::string(R"({"state":"running"})");
  });
  const auto get = [&](const std::string& path) { return askFor(server.port(), path); };
  EXPECT_EQ(server.address(), "http://127.0.0.1:" + std::to_string(server.port()) + "/");
  EXPECT_THAT(get("/"), StartsWith("HTTP/1.1 200"));
  EXPECT_THAT(get("/"), EndsWith(livePage()));
  EXPECT_THAT(get("/"), HasSubstr("img-src data:"));
  EXPECT_THAT(get("/live.js"), EndsWith(liveScript()));
  EXPECT_THAT(get("/status.json"), EndsWith("\r\n\r\n{\"state\":\"running\"}"));
  EXPECT_EQ(asked, 1);
  EXPECT_THAT(get("/other"), StartsWith("HTTP/1.1 404"));
  EXPECT_THAT(get("/../etc/passwd"), StartsWith("HTTP/1.1 404"));
  EXPECT_THAT(askFor(server.port(), "/status.json", "example.org"), StartsWith("HTTP/1.1 403"));
  EXPECT_EQ(asked, 1);
}

TEST(LiveServer, answersNothingWhereTheStatusFails) {
  const LiveServer server(0, []() -> std::string { throw std::runtime_error("no status"); });
  EXPECT_EQ(askFor(server.port(), "/status.json"), "");
  EXPECT_EQ(askFor(server.port(), "/status.json"), "") << "and goes on";
}

}  // namespace
}  // namespace ocelli::test
