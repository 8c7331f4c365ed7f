#include "study/trial/trial_check.h"

#include <fmt/format.h>

#include <utility>

namespace ocelli {
namespace {

constexpr size_t kLongestName = 1000;       // bytes; a protocol allows 200 characters
constexpr double kMaxSeconds = 1e6;         // more than eleven days
constexpr int64_t kMaxFrames = 1e9;         // so that sums over a study stay exact
constexpr double kRoundingSeconds = 0.005;  // times are in steps of 1/240 s
constexpr double kMaxOfMeasure = 1e9;       // metres, clicks, ...

template <class Number>
std::optional<TrialProblem> outside(const std::string& column, std::optional<Number> value, Number least, Number most) {
  // Also for what is not a number.
  if (value && !(*value >= least && *value <= most)) {
    return TrialProblem{column, fmt::format("is {}, but must be a number from {:.12g} to {:.12g}", *value,
                                            static_cast<double>(least), static_cast<double>(most))};
  }
  return std::nullopt;
}

}  // namespace

std::string problemOfName(const std::string& name) {
  return name.size() <= kLongestName
             ? ""
             : fmt::format("has {} bytes, but a name has at most {}", name.size(), kLongestName);
}

std::optional<TrialProblem> problemOf(const TrialRow& trial) {
  for (const auto& [column, name] : {std::pair("subject_id", &trial.subject), std::pair("block", &trial.block),
                                     std::pair("task", &trial.task), std::pair("case_label", &trial.caseLabel)}) {
    if (std::string problem = problemOfName(*name); !problem.empty()) {
      return TrialProblem{column, std::move(problem)};
    }
  }
  using Frames = std::optional<int64_t>;
  for (const auto& problem : {outside("response_s", trial.responseSeconds, 0.0, kMaxSeconds),
                              outside("exposure_s", trial.exposureSeconds, 0.0, kMaxSeconds),
                              outside("longest_s", trial.longestSeconds, 0.0, kMaxSeconds),
                              outside("frames", Frames(trial.frames), int64_t{0}, kMaxFrames),
                              outside("dropped_frames", Frames(trial.droppedFrames), int64_t{0}, kMaxFrames)}) {
    if (problem) {
      return problem;
    }
  }
  for (const auto& [name, value] : trial.measures) {
    if (auto problem = outside(name, std::optional(value), -kMaxOfMeasure, kMaxOfMeasure)) {
      return problem;
    }
  }
  return std::nullopt;
}

std::string contradictionOf(const TrialRow& trial, std::optional<double> limitSeconds) {
  const std::optional<double> limit = trial.longestSeconds ? trial.longestSeconds : limitSeconds;
  if (!limit || !trial.responseSeconds || trial.censored.value_or(false) ||
      *trial.responseSeconds <= *limit + kRoundingSeconds) {
    return "";
  }
  return fmt::format("it took {:.6g} s, beyond its limit of {:g} s, and is not marked as timed out",
                     *trial.responseSeconds, *limit);
}

}  // namespace ocelli
