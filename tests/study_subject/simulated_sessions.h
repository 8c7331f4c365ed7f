// Small studies for simulated subjects.
#pragma once

#include "study/protocol/schedule.h"
#include "study/subject/simulate_study.h"

namespace ocelli::test {

inline constexpr TrialScreen kSmallScreen{200, 125, 60};

/// All tasks, each with practice where `withPractice`, in short trials; consent, forms, breaks and a survey; two
/// sessions. It is read from its text, as databases hold it.
Protocol simulatedProtocol(bool withPractice = true);

/// What the observers of a plan of one session for each of `subjects` do.
SimulationPlan observers(int subjects, int sessions = 1);

}  // namespace ocelli::test
