#include "study/responses/latency_test.h"

#include <gmock/gmock.h>
#include <poll.h>

#include <atomic>
#include <nlohmann/json.hpp>

#include "oc_core/base/steady_time.h"
#include "tests/study_responses/pseudo_box.h"

namespace ocelli::test {
namespace {

using testing::HasSubstr;

/// A box that sends each byte back after a time, but for some of them.
class AnsweringBox {
 public:
  AnsweringBox(int delayMilliseconds, int missesEvery)
      : delay_(delayMilliseconds), missesEvery_(missesEvery), thread_([this] { run(); }) {}
  ~AnsweringBox() {
    ends_ = true;
    thread_.join();
  }
  AnsweringBox(const AnsweringBox&) = delete;
  AnsweringBox& operator=(const AnsweringBox&) = delete;

  const PseudoBox& box() const { return box_; }

 private:
  void run() {
    for (int count = 1; !ends_;) {
      pollfd watched{box_.master(), POLLIN, 0};
      char byte = 0;
      if (::poll(&watched, 1, 10) != 1 || read(box_.master(), &byte, 1) != 1) {
        continue;
      }
      if (missesEvery_ == 0 || count++ % missesEvery_ != 0) {
        std::this_thread::sleep_for(std::chrono::milliseconds(delay_));
        box_.send(std::string(1, byte));
      }
    }
  }

  PseudoBox box_;
  int delay_;
  int missesEvery_;
  std::atomic<bool> ends_{false};
  std::thread thread_;
};

LatencyOptions quick(int trials) {
  LatencyOptions options;
  options.trials = trials;
  options.minGapSeconds = 0.01;
  options.maxGapSeconds = 0.02;
  options.timeoutSeconds = 0.3;
  return options;
}

LatencyReport measured(const AnsweringBox& answering, const LatencyOptions& options) {
  const auto device = openResponseDevice("serial:" + answering.box().device(), {});
  return measureLatency(
      *device,
      [&]() -> std::optional<int64_t> {
        const int64_t sent = steadyNanoseconds();
        return device->send('U') ? std::optional(sent) : std::nullopt;
      },
      [] {}, options);
}

/// A terminal passes bytes on within microseconds; what is over the delay is what a busy machine takes to wake threads.
TEST(LatencyTest, MeasuresTheDelayOfABox) {
  const AnsweringBox answering(20, 0);
  const LatencyReport report = measured(answering, quick(15));
  EXPECT_EQ(report.trials, 15);
  EXPECT_EQ(report.missed, 0);
  EXPECT_EQ(report.unexpected, 0);
  EXPECT_GE(*latencyQuantile(report, 0), 20) << "no answer comes before the box sends it";
  EXPECT_LT(*latencyQuantile(report, 0.5), 35);
}

TEST(LatencyTest, CountsWhatIsMissed) {
  const AnsweringBox answering(1, 3);
  LatencyOptions options = quick(6);
  const LatencyReport report = measured(answering, options);
  EXPECT_EQ(report.trials, 6);
  EXPECT_EQ(report.missed, 2);
  EXPECT_EQ(report.milliseconds.size(), 4u);
}

TEST(LatencyTest, CountsPressesThatNothingAsked) {
  const PseudoBox box;
  const auto device = openResponseDevice("serial:" + box.device(), {});
  LatencyOptions options = quick(1);
  options.minGapSeconds = options.maxGapSeconds = 0.1;
  box.send("1");
  const LatencyReport report = measureLatency(
      *device, [] { return std::optional(steadyNanoseconds()); }, [] {}, options);
  EXPECT_EQ(report.unexpected, 1);
  EXPECT_EQ(report.missed, 1);
}

TEST(LatencyTest, EndsWhereNoStimulusCanBeGiven) {
  const PseudoBox box;
  const auto device = openResponseDevice("serial:" + box.device(), {});
  EXPECT_EQ(measureLatency(
                *device, [] { return std::optional<int64_t>(); }, [] {}, quick(5))
                .trials,
            0);
  LatencyOptions options = quick(5);
  options.interrupted = [] { return true; };
  EXPECT_EQ(measureLatency(
                *device, [] { return std::optional(steadyNanoseconds()); }, [] {}, options)
                .trials,
            0);
}

TEST(LatencyReport, HasQuantilesByRank) {
  LatencyReport report;
  EXPECT_FALSE(latencyQuantile(report, 0.5).has_value());
  for (int i = 50; i >= 1; --i) {
    report.milliseconds.push_back(i);
  }
  EXPECT_EQ(latencyQuantile(report, 0), 1);
  EXPECT_EQ(latencyQuantile(report, 0.5), 25);
  EXPECT_EQ(latencyQuantile(report, 0.95), 48);
  EXPECT_EQ(latencyQuantile(report, 1), 50);
}

TEST(LatencyReport, IsTextAndJson) {
  const LatencyReport report{4, 1, 2, {3, 1, 2}};
  const LatencyText text{"box", "a byte", {"the way out"}, {"the contact"}};
  EXPECT_THAT(describe(report, text), HasSubstr("4 stimuli, 1 missed, 2 presses that were not expected"));
  EXPECT_THAT(describe(report, text), HasSubstr("median 2.00 ms, 95 % within 3.00 ms, from 1.00 to 3.00 ms"));
  const auto json = nlohmann::json::parse(jsonText(report, text));
  EXPECT_EQ(json.at("median_ms"), 2);
  EXPECT_EQ(json.at("samples_ms").size(), 3u);
  EXPECT_EQ(json.at("not_known")[0], "the contact");
  EXPECT_TRUE(nlohmann::json::parse(jsonText({}, text)).at("median_ms").is_null());
}

}  // namespace
}  // namespace ocelli::test
