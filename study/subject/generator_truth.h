// What the effects of the data-only subject (data_generator.h) come to in the trials of a protocol: typical times, and
// how often answers are right among all subjects and cases.
#pragma once

#include <string>

#include "study/protocol/protocol.h"
#include "study/subject/data_generator.h"

namespace ocelli {

/// A trial as far as effects ask for it.
struct GeneratedTrial {
  std::string task;
  StudyView view = StudyView::kPinhole;
  CaseInfo info;
  int session = 0;  ///< from 0
};

/// Mean log seconds of "find", logit of a right answer of "count" and "path", of a subject and case without effects of
/// their own.
double fixedPart(const GeneratorEffects& effects, const GeneratedTrial& trial);

/// exp() of the mean of log seconds over all searches of the protocol, had they this view and no limit. Throws
/// InputError where it has none, as below.
double geometricMeanSeconds(const Protocol& protocol, const GeneratorEffects& effects, StudyView view);

/// The share of right answers of "count" or "path" over all trials of the protocol, had they this view, and over the
/// normal effects of subjects and cases.
double shareRight(const Protocol& protocol, const GeneratorEffects& effects, const std::string& task, StudyView view);

}  // namespace ocelli
