#include "study/replay/stored_replay.h"

#include <fmt/format.h>

#include <algorithm>
#include <mutex>
#include <nlohmann/json.hpp>

#include "oc_core/base/error.h"
#include "oc_core/base/parallel.h"

namespace ocelli {
namespace {

constexpr size_t kMaxDifferences = 20;

bool isChosen(const StoredTrial& trial, const TrialChoice& choice) {
  const TrialPlan& plan = trial.record.plan;
  return (!choice.session || trial.session == *choice.session) && (!plan.practice || choice.withPractice) &&
         (!choice.trial || (!plan.practice && plan.index == *choice.trial));
}

}  // namespace

ReplayStudy::ReplayStudy(const std::filesystem::path& database)
    : database_(StudyDatabase::openForReading(database)),
      protocol_(protocolFromJsonText(database_.study().protocolText, database.string() + ", its protocol")) {}

std::vector<StoredTrial> ReplayStudy::trials(const TrialChoice& choice) const {
  if (!choice.subject.empty() && !database_.subject(choice.subject)) {
    throw InputError(fmt::format("there is no subject {}", choice.subject), database_.path().string(),
                     "list them with: ocelli study subjects --db FILE");
  }
  std::vector<StoredTrial> all = choice.subject.empty() ? database_.trials() : database_.trials(choice.subject);
  std::erase_if(all, [&](const StoredTrial& trial) { return !isChosen(trial, choice); });
  if (all.empty()) {
    throw InputError("there are no such trials", database_.path().string(),
                     "sessions and trials count from 1; a trial that did not begin left nothing");
  }
  return all;
}

TrialLog ReplayStudy::logOf(const StoredTrial& trial) const {
  return {trial.record, database_.frames(trial.id), database_.inputs(trial.id)};
}

const TaskBlock& ReplayStudy::blockOf(const StoredTrial& trial) const {
  const auto index = static_cast<size_t>(trial.record.plan.block);
  if (index >= protocol_.blocks.size() || (trial.record.plan.practice && !protocol_.blocks[index].practice)) {
    throw InputError(fmt::format("trial {} is of a block that the protocol does not have", trial.id),
                     database_.path().string(), "the file was changed: use a copy of it from before");
  }
  const ProtocolBlock& block = protocol_.blocks[index];
  return trial.record.plan.practice ? *block.practice->task : *block.task;
}

std::string ReplayStudy::nameOf(const StoredTrial& trial) const {
  const TrialPlan& plan = trial.record.plan;
  const std::string which = plan.practice ? fmt::format("practice, number {} of its run", trial.number + 1)
                                          : fmt::format("trial {}", plan.index + 1);
  const std::string again = trial.record.attempt > 1 ? fmt::format(", attempt {}", trial.record.attempt) : "";
  return fmt::format("{}, session {}, {}{} ({}, {}, {})", trial.subject, trial.session + 1, which, again, trial.block,
                     protocol_.nameOf(plan.view), trial.record.info.label);
}

std::string ReplayStudy::rendererOf(const StoredTrial& trial) const {
  for (const StoredRun& run : database_.runs(trial.subject, trial.session)) {
    if (run.id != trial.run) {
      continue;
    }
    const bool isPerson = trial.kind == SubjectKind::kPerson;
    const nlohmann::json json =
        nlohmann::json::parse(isPerson ? run.record.environment : run.record.simulation, nullptr, false);
    const nlohmann::json& graphics =
        isPerson && json.is_object() && json.contains("graphics") ? json["graphics"] : json;
    return graphics.is_object() ? graphics.value("renderer", "") : "";
  }
  return "";
}

ReplaySummary ReplayStudy::check(const std::vector<StoredTrial>& trials,
                                 const std::map<std::string, ViewPainter>& painters, const Progress& progress) const {
  ReplaySummary summary;
  std::mutex reading;  // one connection
  std::mutex counting;
  std::vector<std::string> differences(trials.size());
  size_t finished = 0;
  const auto replay = [&](size_t i) {
    const StoredTrial& trial = trials[i];
    TrialLog log;
    ReplayOptions options;
    {
      const std::scoped_lock lock(reading);
      log = logOf(trial);
      if (const auto painter = painters.find(rendererOf(trial)); painter != painters.end()) {
        options.views = painter->second;
      }
    }
    if (log.frames.empty() || !trial.ended) {
      const std::scoped_lock lock(counting);
      ++summary.withoutLog;
      return;
    }
    const ReplayVerdict verdict = replayTrial(blockOf(trial), log, options);
    const std::scoped_lock lock(counting);
    ++summary.trials;
    summary.posesSame += verdict.samePoses == verdict.frames ? 1 : 0;
    summary.outcomesSame += verdict.sameOutcome ? 1 : 0;
    summary.frames += verdict.frames;
    summary.framesSame += verdict.samePoses;
    summary.hashes += verdict.hashes;
    summary.hashesSame += verdict.sameHashes;
    if (!verdict.isSame()) {
      differences[i] = nameOf(trial) + ": " + verdict.firstDifference;
    }
    report(progress, "replaying trials", static_cast<double>(++finished) / static_cast<double>(trials.size()));
  };
  parallelFor(trials.size(), 1, [&](size_t begin, size_t end) {
    for (size_t i = begin; i < end; ++i) {
      runAlone([&] { replay(i); });
    }
  });
  std::erase(differences, "");
  differences.resize(std::min(differences.size(), kMaxDifferences));
  summary.differences = std::move(differences);
  return summary;
}

}  // namespace ocelli
