#include "analysis/dataset/row_digest.h"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <iterator>

namespace ocelli {

RowBytes& RowBytes::text(std::string_view value) {
  fmt::format_to(std::back_inserter(bytes_), "t{}:", value.size());
  bytes_ += value;
  return *this;
}

RowBytes& RowBytes::integer(int64_t value) {
  fmt::format_to(std::back_inserter(bytes_), "i{};", value);
  return *this;
}

RowBytes& RowBytes::integer(const std::optional<int64_t>& value) {
  if (value) {
    return integer(*value);
  }
  bytes_ += "n;";
  return *this;
}

RowBytes& RowBytes::real(double value) {
  fmt::format_to(std::back_inserter(bytes_), "r{:016x};", std::bit_cast<uint64_t>(value));
  return *this;
}

RowBytes& RowBytes::real(const std::optional<double>& value) {
  if (value) {
    return real(*value);
  }
  bytes_ += "n;";
  return *this;
}

Digest RowBytes::digest() const {
  return sha256Digest(bytes_);
}

Digest digestOf(const TrialRow& trial, const std::string& view) {
  const auto number = [](const auto& value) {
    return value ? std::optional<int64_t>(static_cast<int64_t>(*value)) : std::nullopt;
  };
  RowBytes row("trial");
  row.text(trial.subject).integer(trial.session).integer(trial.planIndex).integer(trial.blockIndex).text(trial.block);
  row.text(trial.task).integer(trial.caseIndex).text(trial.caseLabel).text(view).integer(trial.attempt);
  row.integer(trial.simulated ? 1 : 0).text(nameOf(trial.subjectKind)).integer(number(trial.moving));
  row.real(trial.exposureSeconds).integer(number(trial.objects)).integer(number(trial.duplicateColors));
  row.text(trial.answer).text(trial.expected).integer(number(trial.correct)).integer(number(trial.censored));
  row.real(trial.responseSeconds)
      .integer(trial.frames)
      .integer(trial.droppedFrames)
      .text(trial.timingVerdict ? nameOf(*trial.timingVerdict) : "");
  row.integer(static_cast<int64_t>(trial.measures.size()));
  for (const auto& [name, value] : trial.measures) {
    row.text(name).real(value);
  }
  row.integer(trial.trialNumber).integer(number(trial.trialSeed)).integer(trial.startedNs).integer(trial.endedNs);
  row.text(trial.startedUtc).text(trial.endedUtc).integer(trial.responseTicks).integer(trial.exposureFrames);
  row.integer(trial.medianIntervalNs).integer(trial.longestIntervalNs).integer(trial.screenWidth);
  row.integer(trial.screenHeight).real(trial.refreshHertz);
  if (trial.exposureRule) {  // rows of older tables keep their digests
    row.text(nameOf(*trial.exposureRule)).real(trial.exposureShownSeconds);
  }
  return row.digest();
}

Digest sha256OfRows(std::vector<Digest> rows) {
  std::sort(rows.begin(), rows.end());
  std::string bytes;
  bytes.reserve(rows.size() * sizeof(Digest));
  for (const Digest& row : rows) {
    bytes.append(row.begin(), row.end());
  }
  return sha256Digest(bytes);
}

}  // namespace ocelli
