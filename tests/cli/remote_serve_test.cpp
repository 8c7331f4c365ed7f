// `ocelli remote serve` as a script starts it, and a client that looks.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <csignal>
#include <cstdio>
#include <nlohmann/json.hpp>

#include "oc_core/remote/remote_plan.h"
#include "tests/base/temporary_folder.h"
#include "tests/cli/run_program.h"
#include "tests/remote_server/fake_images.h"

namespace ocelli::test {
namespace {

using testing::HasSubstr;

/// The program in the background, with what it prints.
class ServingProgram {
 public:
  explicit ServingProgram(const std::string& arguments)
      : pipe_(popen(("echo $$; exec " + inQuotes(OCELLI_PROGRAM) + " remote serve " + arguments).c_str(), "r")) {
    process_ = std::stoi(line());
  }
  ~ServingProgram() {
    if (pipe_ != nullptr) {
      end();
    }
  }
  ServingProgram(const ServingProgram&) = delete;
  ServingProgram& operator=(const ServingProgram&) = delete;

  /// The next one that it prints; empty at the end.
  std::string line() {
    std::array<char, 4096> text{};
    return std::fgets(text.data(), text.size(), pipe_) != nullptr ? text.data() : "";
  }
  /// Once: a second one ends a program at once.
  void interrupt() {
    if (!isInterrupted_) {
      kill(process_, SIGINT);
    }
    isInterrupted_ = true;
  }
  int end() {
    interrupt();
    const int status = pclose(std::exchange(pipe_, nullptr));
    return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
  }

 private:
  std::FILE* pipe_;
  pid_t process_ = 0;
  bool isInterrupted_ = false;
};

TEST(RemoteServe, ServesAScene) {
  ServingProgram program("builtin:statues --port 0 --json --for 120 --samples 1 --color png --quiet");
  const auto first = nlohmann::json::parse(program.line());
  const int port = first.at("port");
  EXPECT_EQ(first.at("address"), "http://127.0.0.1:" + std::to_string(port) + "/");
  {
    RawSocket page(port);
    ASSERT_TRUE(page.send("GET / HTTP/1.1\r\nHost: localhost\r\n\r\n"));
    EXPECT_THAT(page.receiveAll(), HasSubstr("<script type=\"module\" src=\"remote.js\">"));
  }
  TestWebSocket client(port);
  ASSERT_TRUE(client.isOpen()) << client.answer();
  RemoteRequest look;
  look.sequence = 1;
  look.screen = {64, 48};
  ASSERT_TRUE(client.sendText(jsonText(look)));
  std::string scene;
  RemoteSettings settings;
  const auto received = awaitImage(client, [&](const RemoteServerMessage& message) {
    if (const auto* const hello = std::get_if<RemoteHello>(&message)) {
      scene = hello->scene;
      EXPECT_FALSE(hello->box.empty());
      settings = hello->settings;
      EXPECT_EQ(settings.color, "png");
    }
  });
  EXPECT_EQ(scene, "builtin:statues");
  ASSERT_TRUE(received);
  const ReferenceImage image = decodeRemoteImage(jsonText(received->header), received->color, received->depth);
  const PinholeCamera planned = planRemoteImage(look, settings).reference;
  EXPECT_EQ(image.color.width(), planned.width());
  EXPECT_EQ(image.color.height(), planned.height());
  program.interrupt();
  const auto last = nlohmann::json::parse(program.line());
  EXPECT_EQ(last.at("clients"), 1);
  EXPECT_EQ(last.at("looks"), 1);
  EXPECT_EQ(last.at("images"), 1);
  EXPECT_GT(last.at("bytes_sent"), 1000);
  EXPECT_EQ(program.end(), 0);
}

TEST(RemoteServe, AsksOthersForAToken) {
  const TemporaryFolder folder;
  const auto file = folder.write("token.txt", "secret-of-16-chars\n");
  const ProgramResult made = runProgram("remote serve builtin:statues --port 0 --bind 0.0.0.0 --for 0");
  EXPECT_EQ(made.exitCode, 0) << made.error;
  EXPECT_THAT(made.output, testing::ContainsRegex("http://127.0.0.1:[0-9]+/\\?token=[0-9a-f]+\n"));
  const ProgramResult given =
      runProgram("remote serve builtin:statues --port 0 --for 0 --token-file " + inQuotes(file.string()));
  EXPECT_EQ(given.exitCode, 0) << given.error;
  EXPECT_THAT(given.output, HasSubstr("/?token=secret-of-16-chars\n"));
  EXPECT_THAT(given.output, HasSubstr("0 clients, 0 looks, 0 images"));
}

TEST(RemoteServe, SaysWhatIsWrong) {
  const auto expectError = [](const std::string& options, int code, const std::string& text) {
    const ProgramResult result = runProgram("remote serve builtin:statues --for 0 " + options);
    EXPECT_EQ(result.exitCode, code) << options << result.error;
    EXPECT_THAT(result.error, HasSubstr(text));
    EXPECT_EQ(result.output, "");
  };
  expectError("--bind example.org", 2, "is no address of IPv4 or IPv6");
  expectError("--bind 192.0.2.1", 1, "this computer does not have this address");
  expectError("--port 70000", 2, "--port");
  expectError("--clients 0", 2, "--clients");
  expectError("--color gif", 2, "--color");
  expectError("--token-file /none", 2, "/none");
  ServingProgram other("builtin:statues --port 0 --json --for 120 --quiet");
  const int port = nlohmann::json::parse(other.line()).at("port");
  expectError("--port " + std::to_string(port), 1, "another program uses this port already");
}

TEST(RemoteServe, DoctorKnowsIt) {
  EXPECT_EQ(nlohmann::json::parse(runProgram("doctor --json").output).at("remote").at("built"), true);
}

}  // namespace
}  // namespace ocelli::test
