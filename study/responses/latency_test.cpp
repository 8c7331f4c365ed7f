#include "study/responses/latency_test.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <nlohmann/json.hpp>
#include <thread>

#include "oc_core/base/random_numbers.h"
#include "oc_core/base/steady_time.h"

namespace ocelli {
namespace {

/// As often as a session asks what must be asked.
constexpr auto kLookEvery = std::chrono::milliseconds(2);

/// The first press until then; all of them are taken off the device.
std::optional<int64_t> awaitPress(ResponseDevice& device, int64_t until, bool stopsAtFirst, int& presses,
                                  const LatencyOptions& options) {
  std::optional<int64_t> first;
  while (steadyNanoseconds() < until && !(options.interrupted && options.interrupted())) {
    device.poll();
    for (const KeyChange& change : device.take()) {
      if (change.pressed) {
        ++presses;
        first = first ? first : change.nanoseconds;
      }
    }
    if (first && stopsAtFirst) {
      break;
    }
    std::this_thread::sleep_for(kLookEvery);
  }
  return first;
}

int64_t nanosecondsOfSeconds(double seconds) {
  return std::llround(seconds * 1e9);
}

}  // namespace

std::optional<double> latencyQuantile(const LatencyReport& report, double share) {
  if (report.milliseconds.empty()) {
    return std::nullopt;
  }
  std::vector<double> sorted = report.milliseconds;
  std::ranges::sort(sorted);
  const double rank = std::ceil(share * static_cast<double>(sorted.size()));
  return sorted[static_cast<size_t>(std::clamp(rank, 1.0, static_cast<double>(sorted.size()))) - 1];
}

LatencyReport measureLatency(ResponseDevice& device, const std::function<std::optional<int64_t>()>& stimulus,
                             const std::function<void()>& after, const LatencyOptions& options) {
  LatencyReport report;
  RandomNumbers random(options.seed);
  for (int trial = 0; trial < options.trials; ++trial) {
    const double gap = options.minGapSeconds + (options.maxGapSeconds - options.minGapSeconds) * random.uniform();
    awaitPress(device, steadyNanoseconds() + nanosecondsOfSeconds(gap), false, report.unexpected, options);
    if ((options.interrupted && options.interrupted()) || !device.isConnected()) {
      break;
    }
    const std::optional<int64_t> given = stimulus();
    if (!given) {
      break;
    }
    ++report.trials;
    int presses = 0;
    const std::optional<int64_t> press =
        awaitPress(device, *given + nanosecondsOfSeconds(options.timeoutSeconds), true, presses, options);
    after();
    if (press) {
      report.milliseconds.push_back(static_cast<double>(*press - *given) * 1e-6);
      report.unexpected += presses - 1;
    } else {
      ++report.missed;
    }
  }
  return report;
}

std::string describe(const LatencyReport& report, const LatencyText& text) {
  std::string lines = fmt::format("{}\nstimulus  {}\n{} stimuli, {} missed, {} presses that were not expected\n",
                                  text.device, text.stimulus, report.trials, report.missed, report.unexpected);
  if (!report.milliseconds.empty()) {
    const auto [least, most] = std::ranges::minmax(report.milliseconds);
    lines += fmt::format("latency   median {:.2f} ms, 95 % within {:.2f} ms, from {:.2f} to {:.2f} ms\n",
                         *latencyQuantile(report, 0.5), *latencyQuantile(report, 0.95), least, most);
  }
  for (const std::string& part : text.included) {
    lines += "included  " + part + "\n";
  }
  for (const std::string& part : text.unknown) {
    lines += "not known " + part + "\n";
  }
  return lines;
}

std::string jsonText(const LatencyReport& report, const LatencyText& text) {
  const auto number = [](const std::optional<double>& value) {
    return value ? nlohmann::ordered_json(*value) : nlohmann::ordered_json();
  };
  return nlohmann::ordered_json{{"device", text.device},
                                {"stimulus", text.stimulus},
                                {"trials", report.trials},
                                {"missed", report.missed},
                                {"unexpected", report.unexpected},
                                {"median_ms", number(latencyQuantile(report, 0.5))},
                                {"quantile_95_ms", number(latencyQuantile(report, 0.95))},
                                {"least_ms", number(latencyQuantile(report, 0))},
                                {"most_ms", number(latencyQuantile(report, 1))},
                                {"samples_ms", report.milliseconds},
                                {"included", text.included},
                                {"not_known", text.unknown}}
             .dump(2, ' ', false, nlohmann::json::error_handler_t::replace) +
         "\n";
}

}  // namespace ocelli
