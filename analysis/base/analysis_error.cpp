#include "analysis/base/analysis_error.h"

#include <fmt/format.h>

#include <algorithm>

namespace ocelli {
namespace {

constexpr size_t kLongestBytes = 400;

/// Names in databases can hold anything: no line or command of a terminal is made of it.
std::string oneLine(std::string text) {
  std::replace_if(
      text.begin(), text.end(), [](char c) { return static_cast<unsigned char>(c) < 0x20 || c == 0x7f; }, '?');
  return text.size() <= kLongestBytes ? text : fmt::format("{}...", text.substr(0, kLongestBytes));
}

}  // namespace

AnalysisError::AnalysisError(Kind kind, const std::string& what, const std::string& where, const std::string& next)
    : std::runtime_error(fmt::format("{}: {}\n  try: {}", oneLine(where), oneLine(what), next)), kind_(kind) {}

}  // namespace ocelli
