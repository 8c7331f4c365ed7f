// How long it takes from a stimulus that a device answers by itself to the key that the program gets: a byte that a box
// sends back, or a flash that a photodiode wired to its button sees. People are no such device: they take 200 ms.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "study/responses/response_device.h"

namespace ocelli {

struct LatencyOptions {
  int trials = 50;
  /// Before each stimulus, evenly drawn between these, so that none keeps step with a screen or with USB.
  double minGapSeconds = 0.3;
  double maxGapSeconds = 0.7;
  double timeoutSeconds = 1;  ///< without an answer until then it is missed
  uint64_t seed = 1;          ///< of the gaps
  std::function<bool()> interrupted{};
};

struct LatencyReport {
  int trials = 0;                      ///< stimuli that were given
  int missed = 0;                      ///< of these, without an answer
  int unexpected = 0;                  ///< presses that came when none was due
  std::vector<double> milliseconds{};  ///< of each answer, in their order
};

/// Quantile of the latencies by nearest rank, as that of 95 % is the 48th of 50; nothing where there are none.
std::optional<double> latencyQuantile(const LatencyReport& report, double share);

/// `stimulus` gives one and returns when, of the steady clock; nothing where it could not be given, which ends the
/// test. `after` is called once the answer came, or did not. On the main thread.
LatencyReport measureLatency(ResponseDevice& device, const std::function<std::optional<int64_t>()>& stimulus,
                             const std::function<void()>& after, const LatencyOptions& options);

/// For people; and as JSON. `stimulus` says what was given, `unknown` what is not measured.
struct LatencyText {
  std::string device;
  std::string stimulus;
  std::vector<std::string> included;  ///< in the latencies, beside the device's own
  std::vector<std::string> unknown;
};
std::string describe(const LatencyReport& report, const LatencyText& text);
std::string jsonText(const LatencyReport& report, const LatencyText& text);

}  // namespace ocelli
