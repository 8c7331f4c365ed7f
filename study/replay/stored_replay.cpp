#include "study/replay/stored_replay.h"

#include <fmt/format.h>

#include <algorithm>
#include <mutex>
#include <nlohmann/json.hpp>

#include "oc_core/base/error.h"
#include "oc_core/base/parallel.h"
#include "study/session/trial_rows.h"

namespace ocelli {
namespace {

constexpr size_t kMaxDifferences = 20;

bool isChosen(const TrialRow& trial, const TrialChoice& choice) {
  return (!choice.session || trial.session == *choice.session) && (!trial.practice || choice.withPractice) &&
         (!choice.trial || (!trial.practice && trial.planIndex == *choice.trial));
}

}  // namespace

ReplayStudy::ReplayStudy(const std::filesystem::path& database)
    : database_(StudyDatabase::openForReading(database)),
      protocol_(protocolFromJsonText(database_.study().protocolText, database.string() + ", its protocol")) {}

std::vector<TrialRow> ReplayStudy::trials(const TrialChoice& choice) const {
  if (!choice.subject.empty() && !database_.subject(choice.subject)) {
    throw InputError(fmt::format("there is no subject {}", choice.subject), database_.path().string(),
                     "list them with: ocelli study subjects --db FILE");
  }
  std::vector<TrialRow> all = choice.subject.empty() ? database_.trials() : database_.trials(choice.subject);
  std::erase_if(all, [&](const TrialRow& trial) { return !isChosen(trial, choice); });
  if (all.empty()) {
    throw InputError("there are no such trials", database_.path().string(),
                     "sessions and trials count from 1; a trial that did not begin left nothing");
  }
  return all;
}

TrialLog ReplayStudy::logOf(const TrialRow& trial) const {
  return {recordOf(trial), database_.frames(trial.trialId), database_.inputs(trial.trialId),
          database_.gaze(trial.trialId)};
}

const TaskBlock& ReplayStudy::blockOf(const TrialRow& trial) const {
  const auto index = static_cast<size_t>(trial.blockIndex);
  if (index >= protocol_.blocks.size() || (trial.practice && !protocol_.blocks[index].practice)) {
    throw InputError(fmt::format("trial {} is of a block that the protocol does not have", trial.trialId),
                     database_.path().string(), "the file was changed: use a copy of it from before");
  }
  const ProtocolBlock& block = protocol_.blocks[index];
  return trial.practice ? *block.practice->task : *block.task;
}

std::string ReplayStudy::nameOf(const TrialRow& trial) const {
  const std::string which = trial.practice ? fmt::format("practice, number {} of its run", trial.trialNumber + 1)
                                           : fmt::format("trial {}", trial.planIndex + 1);
  const std::string again = trial.attempt > 1 ? fmt::format(", attempt {}", trial.attempt) : "";
  return fmt::format("{}, session {}, {}{} ({}, {}, {})", trial.subject, trial.session, which, again, trial.block,
                     protocol_.nameOf(trial.view), trial.caseLabel);
}

std::string ReplayStudy::rendererOf(const TrialRow& trial) const {
  for (const StoredRun& run : database_.runs(trial.subject, trial.session)) {
    if (run.id != trial.runId) {
      continue;
    }
    const bool isPerson = !trial.simulated;
    const nlohmann::json json =
        nlohmann::json::parse(isPerson ? run.record.environment : run.record.simulation, nullptr, false);
    const nlohmann::json& graphics =
        isPerson && json.is_object() && json.contains("graphics") ? json["graphics"] : json;
    return graphics.is_object() ? graphics.value("renderer", "") : "";
  }
  return "";
}

ReplaySummary ReplayStudy::check(const std::vector<TrialRow>& trials,
                                 const std::map<std::string, ViewPainter>& painters, const Progress& progress) const {
  ReplaySummary summary;
  std::mutex reading;  // one connection
  std::mutex counting;
  std::vector<std::string> differences(trials.size());
  size_t finished = 0;
  const auto replay = [&](size_t i) {
    const TrialRow& trial = trials[i];
    TrialLog log;
    ReplayOptions options;
    {
      const std::scoped_lock lock(reading);
      log = logOf(trial);
      if (const auto painter = painters.find(rendererOf(trial)); painter != painters.end()) {
        options.views = painter->second;
      }
    }
    if (log.frames.empty() || !trial.ending) {
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
