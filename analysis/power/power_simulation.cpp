#include "analysis/power/power_simulation.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <mutex>

#include "analysis/base/failure.h"
#include "analysis/power/simulated_dataset.h"
#include "analysis/report/view_test.h"
#include "oc_core/base/machine.h"
#include "oc_core/base/parallel.h"
#include "oc_core/ranks/packed_bytes.h"
#include "oc_core/ranks/shared_tasks.h"
#include "study/agent/chance.h"

namespace ocelli {
namespace {

using Question = PowerCurve::Question;
using Test = PowerCurve::Test;

/// What one study says by one test.
struct StudyResult {
  bool found = false;
  bool warned = false;
  double estimate = kNotKnown;  ///< log ratio, or difference of errors or shares
  std::string reason{};         ///< why there is none
};

struct StudyResults {
  int analysed = 0;  ///< subjects
  StudyResult view;
  StudyResult equivalence;
};

Bytes packed(const StudyResults& results) {
  BytePacker packer;
  packer.add(results.analysed);
  for (const StudyResult* result : {&results.view, &results.equivalence}) {
    packer.add(result->found);
    packer.add(result->warned);
    packer.add(result->estimate);
    packer.add(result->reason);
  }
  return packer.take();
}

StudyResults unpacked(const Bytes& bytes) {
  ByteUnpacker unpacker(bytes);
  StudyResults results;
  results.analysed = unpacker.value<int>();
  for (StudyResult* result : {&results.view, &results.equivalence}) {
    result->found = unpacker.value<bool>();
    result->warned = unpacker.value<bool>();
    result->estimate = unpacker.value<double>();
    result->reason = unpacker.text();
  }
  return results;
}

/// A test that fails is one without a result.
void take(StudyResult& result, const std::function<void(StudyResult&)>& test) {
  StudyResult tested;
  const std::optional<std::string> failure = failureOf([&] { test(tested); });
  result = failure ? StudyResult{} : tested;
  if (failure) {
    result.reason = fmt::format("the computation failed: {}", *failure);
  }
}

StudyResults analyseStudy(const PowerWork& work, const Truth& truth, int subjects, uint64_t seed) {
  SimulationPlan simulation;
  simulation.kind = SubjectKind::kGenerator;
  simulation.seed = seed;
  simulation.effects = truth.effects;
  simulation.sessions = sessionsOf(work.protocol, subjects, work.dropOut, seed);
  const AnalysisData analysis = applyPlan(simulatedDatasetWithoutAnswers(work.protocol, simulation), work.plan);
  StudyResults results;
  results.analysed = analysis.flow.analysed;
  if (truth.kind != Truth::Kind::kAtBound) {
    take(results.view, [&](StudyResult& result) {
      const ViewTest test = work.contrast == nullptr ? testOfView(analysis, work.model)
                                                     : testOfContrast(analysis, work.model, *work.contrast);
      result.warned = test.warned;
      if (test.view && std::isfinite(test.view->pValue)) {
        result.found = test.view->pValue <= work.alpha;
        result.estimate = test.view->value;
      } else {
        result.reason = test.view ? "the model has no standard error" : test.view.reason();
      }
    });
  }
  if (work.bounds != nullptr) {
    take(results.equivalence, [&](StudyResult& result) {
      const Estimable<EquivalenceTest> test = testOfEquivalence(analysis, *work.bounds, work.alpha);
      if (test) {
        result.found = test->equivalent;
        result.estimate = test->difference.value;
      } else {
        result.reason = test.reason();
      }
    });
  }
  return results;
}

/// Studies of one size.
PowerSize sizeOf(int subjects, const StudyResults* first, int studies, Test test, bool isDifference) {
  PowerSize size;
  size.subjects = subjects;
  size.found.trials = studies;
  double sum = 0;
  double analysed = 0;
  for (int i = 0; i < studies; ++i) {
    const StudyResult& result = test == Test::kView ? first[i].view : first[i].equivalence;
    analysed += first[i].analysed;
    size.found.successes += result.found ? 1 : 0;
    size.warned += result.warned ? 1 : 0;
    if (std::isfinite(result.estimate)) {
      sum += result.estimate;
    } else {
      size.reason = size.notEstimable++ == 0 ? result.reason : size.reason;
    }
  }
  size.analysed = analysed / studies;
  if (size.notEstimable < studies) {
    const double mean = sum / (studies - size.notEstimable);
    size.estimate = test == Test::kView && !isDifference ? std::exp(mean) : mean;
  }
  return size;
}

PowerCurve emptyCurve(const PowerWork& work, const Truth& truth, Test test) {
  PowerCurve curve;
  curve.test = test;
  curve.truth = truth.label;
  curve.contrast = work.contrast == nullptr || test != Test::kView ? "" : work.contrast->name;
  const double difference = truth.other - truth.reference;
  curve.trueValue = test == Test::kView ? truth.effect : difference;
  const bool isThere = test == Test::kView ? truth.kind != Truth::Kind::kNone
                                           : truth.kind != Truth::Kind::kAtBound && difference > work.bounds->lower &&
                                                 difference < work.bounds->upper;
  curve.question = isThere ? Question::kPower : Question::kFalseAlarm;
  return curve;
}

}  // namespace

std::vector<int> sessionsOf(const Protocol& protocol, int subjects, double dropOut, uint64_t seed) {
  std::vector<int> sessions(static_cast<size_t>(subjects), protocol.sessions);
  Random random(seedOf(seed, 0x64726f70));  // of its own: subjects are the same with and without
  for (int& count : sessions) {
    for (int session = 1; session < protocol.sessions; ++session) {
      if (happens(random, dropOut)) {
        count = std::min(count, session);
      }
    }
  }
  return sessions;
}

std::vector<PowerCurve> simulatePower(const PowerWork& work, const std::vector<Truth>& truths,
                                      const Progress& progress) {
  const std::unique_ptr<Ranks> alone = serialRanks();
  return simulatePower(work, truths, *alone, progress);
}

std::vector<PowerCurve> simulatePower(const PowerWork& work, const std::vector<Truth>& truths, Ranks& ranks,
                                      const Progress& progress) {
  keepFreedMemory();
  const size_t sizes = work.subjects.size();
  const auto studies = static_cast<size_t>(work.simulations);
  const size_t count = truths.size() * sizes * studies;
  const std::vector<size_t> tasks = tasksOfRank(ranks, count);
  std::vector<Bytes> mine(tasks.size());
  std::mutex mutex;
  size_t finished = 0;
  report(progress, "simulating studies", 0);
  parallelFor(tasks.size(), 1, [&](size_t begin, size_t end) {
    for (size_t task = begin; task < end; ++task) {
      const size_t i = tasks[task];
      const int subjects = work.subjects[i / studies % sizes];
      // Truths are compared with the same subjects, cases and chances.
      const uint64_t seed = seedOf(seedOf(work.seed, static_cast<uint64_t>(subjects)), i % studies);
      runAlone([&] { mine[task] = packed(analyseStudy(work, truths[i / studies / sizes], subjects, seed)); });
      const std::scoped_lock lock(mutex);
      report(progress, "simulating studies", static_cast<double>(++finished) / static_cast<double>(tasks.size()));
    }
  });
  std::vector<StudyResults> results;
  for (const Bytes& result : gatherTasks(ranks, count, mine)) {
    results.push_back(unpacked(result));
  }
  if (!ranks.isFirst()) {
    return {};
  }
  std::vector<PowerCurve> curves;
  for (size_t t = 0; t < truths.size(); ++t) {
    for (const Test test : {Test::kView, Test::kEquivalence}) {
      const bool isTested = test == Test::kView ? truths[t].kind != Truth::Kind::kAtBound : work.bounds != nullptr;
      if (isTested) {
        PowerCurve curve = emptyCurve(work, truths[t], test);
        for (size_t s = 0; s < sizes; ++s) {
          curve.sizes.push_back(sizeOf(work.subjects[s], &results[(t * sizes + s) * studies], work.simulations, test,
                                       truths[t].isDifference));
        }
        curves.push_back(std::move(curve));
      }
    }
  }
  return curves;
}

}  // namespace ocelli
