// A task of one's own: registered under a name, named by a protocol, and done by simulated subjects, whose trials stand
// in a database like those of any study. The argument is the protocol, react.json.
#include <cstdio>
#include <cstdlib>
#include <filesystem>

#include "oc_core/base/error.h"
#include "react_task.h"
#include "study/protocol/protocol.h"
#include "study/session/trial_rows.h"
#include "study/store/study_database.h"
#include "study/subject/simulate_study.h"

using namespace ocelli;

namespace {

double reactionSeconds(const TrialOutcome& outcome) {
  for (const auto& [name, value] : outcome.measures) {
    if (name == "reaction_s") {
      return value;
    }
  }
  return 0;
}

bool run(const std::filesystem::path& protocolFile) {
  constexpr int kSubjects = 5;
  registerTask(reactTask());

  const Protocol protocol = readProtocol(protocolFile);
  std::filesystem::remove("react.db");
  simulateStudy(protocol, "react.db", {.sessions = std::vector<int>(kSubjects, 1)});

  int pressed = 0;
  double sum = 0;
  for (const TrialRow& trial : StudyDatabase::openForReading("react.db").trials()) {
    if (trial.correct.value_or(false)) {
      ++pressed;
      sum += reactionSeconds(recordOf(trial).outcome);
    }
  }
  const int trials = kSubjects * protocol.blocks.front().task->caseCount();
  std::printf("react.db: %d subjects pressed the key in %d of %d trials, %.0f ms after the button appeared\n",
              kSubjects, pressed, trials, pressed > 0 ? 1000 * sum / pressed : 0);
  return pressed > trials / 2 && sum / pressed > 0.1 && sum / pressed < 1;
}

}  // namespace

int main(int count, char** arguments) {
  try {
    if (count != 2) {
      std::fprintf(stderr, "usage: add_a_task react.json\n");
      return EXIT_FAILURE;
    }
    return run(arguments[1]) ? EXIT_SUCCESS : EXIT_FAILURE;
  } catch (const Error& error) {
    std::fprintf(stderr, "add_a_task: %s\n", error.what());
    return EXIT_FAILURE;
  }
}
