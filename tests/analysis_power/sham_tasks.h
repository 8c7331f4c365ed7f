// Tasks whose answers are estimates, of data alone: nobody can do them, but the data-only subject has their outcomes.
// "reach" is in metres, "bearing" in degrees; a case has its true value. For what an analysis makes of estimates.
#pragma once

#include <string>

#include "analysis/dataset/dataset.h"
#include "study/protocol/protocol.h"
#include "study/subject/generator_effects.h"

namespace ocelli::test {

/// Registers both, once.
void registerShamTasks();

/// 16 cases of each in each condition, in one session: "flat", "bent" and so on, of two to four conditions. Distances
/// from 2 to 12 m, directions around.
Protocol shamProtocol(int conditions = 2);

/// So many subjects by the generator.
Dataset shamStudy(const Protocol& protocol, const GeneratorEffects& effects, int subjects, uint64_t seed);

}  // namespace ocelli::test
