// Forms that are asked before and after sessions and after blocks: what was answered, and the scores of questionnaires,
// as protocols/questionnaires/*.json say.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "analysis/report/report_parts.h"
#include "study/outline/questionnaire.h"

namespace ocelli {

inline constexpr const char* kScoresTable = "questionnaire-scores";

/// What a subject scored in a questionnaire that was asked at one place of a session.
struct SubjectScore {
  std::string form;           ///< "ssq after find moving"
  std::string questionnaire;  ///< "ssq"
  std::string subject;
  int session = 1;
  /// In which the trials were before it: of the block, or of the whole session; nothing where both were seen, or none.
  std::optional<TrialView> view{};
  std::string score;  ///< "nausea"
  std::string title;  ///< "SSQ nausea"
  /// Nothing where an item that counts was left open.
  std::optional<double> value{};
  std::vector<RowRef> rows{};  ///< answers that it is of
};

/// In the order of the protocol, then by session and subject.
std::vector<SubjectScore> scoresOf(const Dataset& data);
/// Whether a protocol of the data asks forms at these places.
bool hasOtherForms(const Dataset& data);

void addQuestionnaires(ReportWork& work);

/// tables/scores.csv: a row each.
std::string scoresCsv(const Dataset& data);

}  // namespace ocelli
