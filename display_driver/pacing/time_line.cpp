#include "display_driver/pacing/time_line.h"

#include <fmt/format.h>

#include <algorithm>

namespace ocelli {
namespace {

constexpr HostTime kUnknown{};

float millisecondsBetween(HostTime from, HostTime to) {
  return std::chrono::duration<float, std::milli>(to - from).count();
}

Spread spreadOf(std::vector<float> times) {
  if (times.empty()) {
    return {};
  }
  std::sort(times.begin(), times.end());
  // The smallest that as many as 95 % do not exceed.
  const size_t within95 = (times.size() * 95 + 99) / 100 - 1;
  return {.count = times.size(),
          .median = static_cast<double>(times[times.size() / 2]),
          .within95 = static_cast<double>(times[within95]),
          .worst = static_cast<double>(times.back())};
}

std::string cell(HostTime time, HostTime start) {
  return time == kUnknown ? std::string()
                          : fmt::format("{:.3f}", std::chrono::duration<double, std::milli>(time - start).count());
}

/// As one cell whatever it holds.
std::string quoted(const std::string& text) {
  std::string cell;
  for (const char c : text) {
    cell += c == '"' ? "\"\"" : c == '\n' ? "; " : std::string(1, c);
  }
  return text.empty() ? "" : "\"" + cell + "\"";
}

}  // namespace

const char* nameOf(RefreshOutcome outcome) {
  switch (outcome) {
    case RefreshOutcome::kShown:
      return "shown";
    case RefreshOutcome::kUnchanged:
      return "unchanged";
    case RefreshOutcome::kSourceLate:
      return "source late";
    case RefreshOutcome::kLinkLate:
      return "link late";
    case RefreshOutcome::kRefused:
      return "refused";
    case RefreshOutcome::kNotConnected:
      return "not connected";
  }
  return "";
}

bool isMiss(RefreshOutcome outcome) {
  return outcome != RefreshOutcome::kShown && outcome != RefreshOutcome::kUnchanged;
}

void TimeLine::add(const RefreshRecord& record) {
  if (!first_) {
    first_ = record.due;
  }
  ++summary_.refreshes;
  ++summary_.outcomes[static_cast<size_t>(record.outcome)];
  summary_.misses += isMiss(record.outcome) ? 1 : 0;
  summary_.seconds = std::chrono::duration<double>(record.due - *first_).count();
  if (record.frame == 0) {
    return;
  }
  making_.push_back(millisecondsBetween(record.makingBegan, record.makingEnded));
  submitting_.push_back(millisecondsBetween(record.makingEnded, record.submitted));
  const HostTime sent = record.sent == kUnknown ? record.arrived : record.sent;
  if (sent != kUnknown) {
    sending_.push_back(std::max(0.0f, millisecondsBetween(record.submitted, sent)));
  }
  if (record.shown != kUnknown) {
    ++summary_.framesShown;
    summary_.smallerImages += record.imageScale < 1 ? 1 : 0;
    summary_.leastImageScale = std::min(summary_.leastImageScale, record.imageScale);
    imageScales_.push_back(record.imageScale);
    latency_.push_back(millisecondsBetween(record.makingBegan, record.shown));
  }
}

TimeLineSummary TimeLine::summary() const {
  TimeLineSummary summary = summary_;
  summary.making = spreadOf(making_);
  summary.submitting = spreadOf(submitting_);
  summary.sending = spreadOf(sending_);
  summary.latency = spreadOf(latency_);
  if (!imageScales_.empty()) {
    summary.medianImageScale = static_cast<float>(spreadOf(imageScales_).median);
  }
  return summary;
}

std::string timeLineHeader() {
  return "refresh,due_ms,frame,outcome,making_began_ms,making_ended_ms,submitted_ms,sent_ms,arrived_ms,shown_ms,"
         "shown_refresh,late,image_scale,problem\n";
}

std::string timeLineRow(const RefreshRecord& record, HostTime start) {
  const bool shown = record.shown != kUnknown;
  return fmt::format("{},{},{},{},{},{},{},{},{},{},{},{},{},{}\n", record.refresh, cell(record.due, start),
                     record.frame == 0 ? "" : std::to_string(record.frame), nameOf(record.outcome),
                     cell(record.makingBegan, start), cell(record.makingEnded, start), cell(record.submitted, start),
                     cell(record.sent, start), cell(record.arrived, start), cell(record.shown, start),
                     shown ? std::to_string(record.shownRefresh) : "", record.late ? 1 : 0,
                     record.frame == 0 ? "" : fmt::format("{:.3g}", record.imageScale), quoted(record.problem));
}

}  // namespace ocelli
