// Whole studies with simulated subjects: who takes part in how many sessions, side by side on all threads, into a
// database like that of any study, in which every row is marked.
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "oc_core/base/progress.h"
#include "study/agent/human_factors.h"
#include "study/session/records.h"
#include "study/subject/data_generator.h"
#include "study/task/trial_image.h"

namespace ocelli {

struct SimulationPlan {
  std::vector<int> sessions;  ///< of each subject, how many it takes part in
  uint64_t seed = 1;
  SubjectKind kind = SubjectKind::kObserver;  ///< or kGenerator
  std::string idPrefix = "sim-";              ///< ids are PREFIX0001, PREFIX0002, ...
  GeneratorEffects effects{};                 ///< of generators
  TrialScreen screen{640, 400, 60};           ///< of observers, here and below
  std::string renderer = "raster";            ///< as it is recorded
  /// A renderer for the thread that calls it.
  std::function<StudyRenderer()> makeRenderer = [] { return StudyRenderer(rasterizeStudy); };
  bool hashFrames = false;
  FactorMeans factors{};  ///< of observers, other than the usual ones
  /// Of the subjects, which are all added, only `part`, `part` + `parts` and so on are simulated, counted from 0.
  int part = 0;
  int parts = 1;
};

struct SimulationResult {
  int sessions = 0;        ///< that were run now
  int sessionsBefore = 0;  ///< that were there already
  int trials = 0;          ///< of the plan of both
};

/// What "3x25,1x20" says: three sessions for 25 subjects, then one for 20. Throws InputError, naming `where`, for other
/// texts, for other than `subjects` subjects, and for more sessions than `most`.
std::vector<int> sessionsFromText(const std::string& text, int subjects, int most, const std::string& where);

/// Adds the subjects alone, whom simulateStudy() adds otherwise. The result is what there is to do, of all of them.
SimulationResult addSubjects(const Protocol& protocol, const std::filesystem::path& database,
                             const SimulationPlan& plan);

/// Sessions that are in the database already stay as they are; one that stopped half way goes on. The result is the
/// same for any number of threads, and for a run that was stopped and run again. Throws InputError where the database
/// is of another protocol, or has one of the subjects with other settings.
SimulationResult simulateStudy(const Protocol& protocol, const std::filesystem::path& database,
                               const SimulationPlan& plan, const Progress& progress = {});

}  // namespace ocelli
