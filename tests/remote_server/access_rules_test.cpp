#include "oc_core/remote/server/access_rules.h"

#include <gtest/gtest.h>

#include "oc_core/base/error.h"
#include "oc_core/remote/server/listening_socket.h"
#include "tests/base/temporary_folder.h"

namespace ocelli::test {
namespace {

TEST(AccessRules, knowsTheNamesOfThisComputer) {
  for (const char* host : {"127.0.0.1", "127.0.0.1:8080", "localhost", "LocalHost:1", "10.1.2.3:80", "[::1]",
                           "[::1]:80", "[fe80::1]:8080", "Lab.example.org:8080"}) {
    EXPECT_TRUE(isHostAllowed(host, {"lab.example.org"})) << host;
  }
  for (const char* host :
       {"", ":80", "example.org", "lab.example.org.attacker.net", "attacker.net:80", "127.0.0.1.nip.io",
        "127.0.0.1:", "127.0.0.1:80x", "127.0.0.1:808080", "[::1", "[::1]x", "[::1]x:80", "[127.0.0.1]", "::1",
        "localhost localhost", "127.0.0.1, 127.0.0.1", "127.1", "0x7f000001", "user@127.0.0.1"}) {
    EXPECT_FALSE(isHostAllowed(host, {"lab.example.org"})) << host;
  }
}

TEST(AccessRules, wantsTheOriginOfTheHost) {
  EXPECT_TRUE(isOriginAllowed("", "127.0.0.1:80")) << "no browser";
  EXPECT_TRUE(isOriginAllowed("http://127.0.0.1:80", "127.0.0.1:80"));
  EXPECT_TRUE(isOriginAllowed("http://localhost:9000", "LOCALHOST:9000"));
  for (const char* origin : {"null", "http://127.0.0.1", "http://127.0.0.1:81", "https://127.0.0.1:80", "127.0.0.1:80",
                             "http://127.0.0.1:80.attacker.net", "http://attacker.net"}) {
    EXPECT_FALSE(isOriginAllowed(origin, "127.0.0.1:80")) << origin;
  }
}

TEST(AccessRules, comparesTokensWhole) {
  EXPECT_TRUE(isTokenRight("", ""));
  EXPECT_TRUE(isTokenRight("anything", "")) << "none is asked for";
  EXPECT_TRUE(isTokenRight("abc", "abc"));
  for (const char* given : {"", "ab", "abcd", "abd", "Abc"}) {
    EXPECT_FALSE(isTokenRight(given, "abc")) << given;
  }
}

TEST(AccessRules, findsTheTokenOfAQuery) {
  EXPECT_EQ(tokenOfQuery("token=abc"), "abc");
  EXPECT_EQ(tokenOfQuery("a=b&token=abc&c"), "abc");
  EXPECT_EQ(tokenOfQuery(""), "");
  EXPECT_EQ(tokenOfQuery("&&"), "");
  EXPECT_EQ(tokenOfQuery("mytoken=abc"), "");
  EXPECT_EQ(tokenOfQuery("token=abc&token=abd"), "") << "which one is meant?";
}

TEST(AccessRules, makesTokensThatDiffer) {
  const std::string token = newToken();
  EXPECT_EQ(token.size(), 32u);
  EXPECT_EQ(token.find_first_not_of("0123456789abcdef"), std::string::npos);
  EXPECT_NE(token, newToken());
}

TEST(AccessRules, readsTokensFromFiles) {
  const TemporaryFolder folder;
  const auto read = [&](const std::string& text) {
    const auto path = folder.path() / "token.txt";
    std::ofstream(path) << text;
    return readTokenFile(path);
  };
  EXPECT_EQ(read("0123456789-abcd_EF\nsecond line"), "0123456789-abcd_EF");
  EXPECT_EQ(read("0123456789abcdef\r\n"), "0123456789abcdef");
  EXPECT_THROW(read(""), InputError);
  EXPECT_THROW(read("short\n"), InputError);
  EXPECT_THROW(read("0123456789abcdef&x=y"), InputError);
  EXPECT_THROW(read(std::string(129, 'a')), InputError);
  EXPECT_THROW(readTokenFile(folder.path() / "none"), InputError);
}

TEST(ListeningSocket, knowsWhatIsLoopback) {
  for (const char* address : {"127.0.0.1", "127.1.2.3", "::1"}) {
    EXPECT_TRUE(isLoopbackAddress(address)) << address;
  }
  for (const char* address : {"0.0.0.0", "::", "128.0.0.1", "10.0.0.1", "::2", "localhost", ""}) {
    EXPECT_FALSE(isLoopbackAddress(address)) << address;
  }
}

}  // namespace
}  // namespace ocelli::test
