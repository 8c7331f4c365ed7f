// Simulated subjects that see nothing: outcomes drawn from known effects, for tests of an analysis. Their trials have
// neither frames nor input. How an outcome comes of the effects is in study/tasks/generator_model.h; what effects a
// task has, in its row.
//
// A task whose outcome is a time is censored at its limit. Of one whose outcome is an answer the row says what wrong
// answers are like.
#pragma once

#include <cstdint>

#include "study/protocol/schedule.h"
#include "study/session/session_sink.h"
#include "study/subject/generator_effects.h"

namespace ocelli {

struct GeneratedSession {
  const SessionSchedule& schedule;
  GeneratorEffects effects{};
  uint64_t studySeed = 1;  ///< of what subjects share
  uint64_t subjectSeed = 1;
  bool tellsAnswers = true;  ///< or only whether they are right: which turns are those of a path takes long to find out
};

/// Consent and forms included. Throws InputError for a task that is unknown.
void generateSession(const Protocol& protocol, const GeneratedSession& session, SessionSink& sink);

}  // namespace ocelli
