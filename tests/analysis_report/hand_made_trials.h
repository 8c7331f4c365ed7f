// Trials made by hand, for what sections of the report ask of them.
#pragma once

#include <deque>
#include <string>

#include "analysis/report/report_parts.h"

namespace ocelli::test {

inline constexpr TrialView kPpc = TrialView::kReference;
inline constexpr TrialView kGc = TrialView::kOther;

struct HandMadeTrial {
  std::string subject = "S1";
  int session = 1;
  int planIndex = 0;
  int caseIndex = 0;
  TrialView view = TrialView::kReference;
  bool correct = false;
  std::optional<double> exposure{};
  std::optional<bool> duplicates{};
  bool censored = false;
  int dropped = 0;
  double seconds = 1;
  int attempt = 1;
};

/// Keeps the trials, whose list stays good while it lives; trial ids count from 1.
class HandMadeTrials {
 public:
  explicit HandMadeTrials(std::string task = "count") : task_(std::move(task)) {}

  const Trial* add(const HandMadeTrial& made);
  const TrialList& list() const { return list_; }

 private:
  std::string task_;
  std::deque<Trial> trials_{};
  TrialList list_{};
};

/// Trial ids of a list, in order.
std::vector<int64_t> idsOf(const TrialList& trials);
/// nullptr where there is none.
const ReportTable* findTable(const ReportDocument& document, const std::string& id);
/// The cell with the row's label.
const ReportCell* findCell(const ReportTable& table, const std::string& label, size_t column);
std::vector<std::string> notesOf(const ReportDocument& document);

}  // namespace ocelli::test
