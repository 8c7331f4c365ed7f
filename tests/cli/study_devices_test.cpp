// What `ocelli study` says of devices, as a shell sees it; `latency` with a box at a pseudo-terminal.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <poll.h>
#include <pty.h>
#include <unistd.h>

#include <array>
#include <atomic>
#include <nlohmann/json.hpp>
#include <thread>

#include "oc_core/base/file_bytes.h"
#include "tests/base/temporary_folder.h"
#include "tests/cli/run_program.h"

namespace ocelli::test {
namespace {

using testing::AnyOf;
using testing::HasSubstr;
using testing::Not;

constexpr int kWorkFailed = 1;
constexpr int kInputWrong = 2;

/// A box that sends each byte back after 10 milliseconds, or never.
class EchoBox {
 public:
  explicit EchoBox(bool answers = true) : answers_(answers) {
    std::array<char, 256> name{};
    EXPECT_EQ(openpty(&master_, &slave_, name.data(), nullptr, nullptr), 0);
    device_ = name.data();
    thread_ = std::thread([this] { run(); });
  }
  ~EchoBox() {
    ends_ = true;
    thread_.join();
    close(slave_);
    close(master_);
  }
  EchoBox(const EchoBox&) = delete;
  EchoBox& operator=(const EchoBox&) = delete;

  std::string place() const { return "serial:" + device_; }

 private:
  void run() const {
    while (!ends_) {
      pollfd watched{master_, POLLIN, 0};
      char byte = 0;
      if (::poll(&watched, 1, 10) == 1 && read(master_, &byte, 1) == 1 && answers_) {
        std::this_thread::sleep_for(std::chrono::milliseconds(10));
        EXPECT_EQ(write(master_, &byte, 1), 1);
      }
    }
  }

  bool answers_;
  int master_ = -1;
  int slave_ = -1;
  std::string device_;
  std::atomic<bool> ends_{false};
  std::thread thread_;
};

TEST(StudyLatency, MeasuresABoxThatAnswers) {
  const TemporaryFolder folder;
  const EchoBox box;
  const std::filesystem::path file = folder / "latency.json";
  const ProgramResult result =
      runProgram("study latency --trials 4 --byte 0x55 --responses " + box.place() + " -o " + file.string());
  EXPECT_EQ(result.exitCode, 0) << result.error;
  EXPECT_THAT(result.output, HasSubstr("4 stimuli, 0 missed, 0 presses that were not expected"));
  EXPECT_THAT(result.output, HasSubstr("not known what the contact of a button adds"));
  const auto json = nlohmann::json::parse(readFile(file, 100'000));
  ASSERT_EQ(json.at("samples_ms").size(), 4u);
  EXPECT_GE(json.at("least_ms").get<double>(), 10);
  EXPECT_EQ(json.at("stimulus"), "byte 0x55, which the device sends back");
}

TEST(StudyLatency, SaysThatADeviceIsSilent) {
  const EchoBox box(false);
  const ProgramResult result =
      runProgram("study latency --trials 1 --timeout 0.05 --byte U --responses " + box.place());
  EXPECT_EQ(result.exitCode, kWorkFailed);
  EXPECT_THAT(result.output, HasSubstr("1 stimuli, 1 missed"));
  EXPECT_THAT(result.error, HasSubstr("answered no stimulus"));
}

TEST(StudyLatency, SaysWhatIsWrong) {
  for (const char* arguments :
       {"", "--byte U", "--byte U --flash --responses serial:/dev/null", "--byte 0x100 --responses serial:/dev/null",
        "--byte U --responses radio:5", "--trials 0 --byte U --responses serial:/dev/null"}) {
    EXPECT_EQ(runProgram(std::string("study latency ") + arguments).exitCode, kInputWrong) << arguments;
  }
  EXPECT_EQ(runProgram("study latency --byte U --responses 'serial:/dev/no such box'").exitCode, kWorkFailed);
}

TEST(StudyCheck, TellsThatGazeMayBeRecordedAndThatNoConsentSaysSo) {
  const TemporaryFolder folder;
  auto protocol = nlohmann::json::parse(readFile(OCELLI_SOURCE_DIR "/tests/study_screen/tiny.json", 1'000'000));
  const auto checked = [&] {
    return runProgram("study check " + inQuotes(folder.write("tiny.json", protocol.dump()))).output;
  };
  EXPECT_THAT(checked(), HasSubstr("gaze      may be recorded: the consent must say so"));
  EXPECT_THAT(checked(), Not(HasSubstr("no consent tells them so")));
  protocol.erase("consent");
  EXPECT_THAT(checked(), HasSubstr("where subjects look may be recorded, and no consent tells them so"));
  protocol.erase("gaze");
  EXPECT_THAT(checked(), Not(HasSubstr("may be recorded")));
}

TEST(StudyRun, RefusesGazeWhereTheProtocolDoesNotTellOfIt) {
  const TemporaryFolder folder;
  const ProgramResult result = runProgram("study run " + std::string(OCELLI_SOURCE_DIR) +
                                          "/protocols/short.json --subject S01 --gaze udp:127.0.0.1:5010 --db " +
                                          (folder / "study.db").string());
  EXPECT_NE(result.exitCode, 0);
  EXPECT_THAT(result.error, AnyOf(HasSubstr("the protocol does not say that gaze is recorded"), HasSubstr("OpenGL")));
  EXPECT_FALSE(std::filesystem::exists(folder / "study.db"));
}

}  // namespace
}  // namespace ocelli::test
