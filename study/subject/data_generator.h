// Simulated subjects that see nothing: outcomes drawn from known effects, for tests of an analysis. Their trials have
// neither frames nor input.
//
//   find    log(seconds) = logSeconds + graph * [gc] + moving * [moving] + session * (session - 1)
//                          + subject + subjectGraph * [gc] + item + itemView * ([gc] - 1/2) + residual,
//                          censored at the limit of the task
//   count   logit(right) = right + graph * [gc] + duplicates * [duplicates] + doubledExposure * log2(exposure / 10 s)
//                          + session * (session - 1) + subject + item + itemView * ([gc] - 1/2);
//                          wrong answers are one off
//   path    logit(right) = right + graph * [gc] + session * (session - 1) + subject + item + itemView * ([gc] - 1/2)
//
// What is named "...Sd" is the standard deviation of a normal effect with mean 0. Items are the cases of a block in a
// session, the same for all subjects. "itemView" is by how much the effect of the view on an item differs from the mean
// effect; half of it counts for each view, so that without an effect of the view times and shares of all items are the
// same in both views.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>

#include "study/protocol/schedule.h"
#include "study/session/session_sink.h"

namespace ocelli {

/// Made-up numbers: nothing is known of people by them.
struct GeneratorEffects {
  struct Find {
    double logSeconds = 2.5;
    double graph = -0.3;
    double moving = -0.3;
    double session = -0.1;
    double subjectSd = 0.25;
    double subjectGraphSd = 0.1;
    double itemSd = 0.35;
    double itemViewSd = 0;
    double residualSd = 0.45;

    bool operator==(const Find&) const = default;
  } find{};
  struct Count {
    double right = 0.5;
    double graph = 1.5;
    double duplicates = -0.4;
    double doubledExposure = 0.3;
    double session = 0.2;
    double subjectSd = 0.5;
    double itemSd = 0.4;
    double itemViewSd = 0;

    bool operator==(const Count&) const = default;
  } count{};
  struct Path {
    double right = 1;
    double graph = 0.1;
    double session = 0.2;
    double subjectSd = 0.5;
    double itemSd = 0.4;
    double itemViewSd = 0;

    bool operator==(const Path&) const = default;
  } path{};

  bool operator==(const GeneratorEffects&) const = default;
};

/// From a JSON file with objects "find", "count" and "path"; what is missing stays as above. Throws InputError.
GeneratorEffects readGeneratorEffects(const std::filesystem::path& file);
/// As JSON text with the same fields.
std::string jsonText(const GeneratorEffects& effects);

struct GeneratedSession {
  const SessionSchedule& schedule;
  GeneratorEffects effects{};
  uint64_t studySeed = 1;  ///< of what subjects share
  uint64_t subjectSeed = 1;
  bool tellsAnswers = true;  ///< or only whether they are right: which turns are those of a path takes long to find out
};

/// Consent and forms included.
void generateSession(const Protocol& protocol, const GeneratedSession& session, SessionSink& sink);

}  // namespace ocelli
