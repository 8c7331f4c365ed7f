#include "study/subject/simulate_study.h"

#include <fmt/format.h>

#include <algorithm>
#include <mutex>
#include <nlohmann/json.hpp>

#include "oc_core/base/error.h"
#include "oc_core/base/json_fields.h"
#include "oc_core/base/machine.h"
#include "oc_core/base/number_text.h"
#include "oc_core/base/parallel.h"
#include "study/store/program_version.h"
#include "study/store/resume.h"
#include "study/store/trial_store.h"
#include "study/subject/simulate_session.h"
#include "study/subject/skipping_sink.h"

namespace ocelli {
namespace {

constexpr int kMaxSubjects = 10'000;

/// A subject of the plan and what is there of it.
struct SubjectWork {
  StoredSubject subject;
  uint64_t seed = 1;
  int sessions = 0;
  std::string simulation;  ///< JSON
  std::vector<SessionDone> done;
  std::vector<bool> begun;
  std::vector<bool> complete;

  int open() const { return static_cast<int>(std::count(complete.begin(), complete.end(), false)); }
};

std::string simulationJson(const Protocol& protocol, const SimulationPlan& plan, uint64_t subjectSeed) {
  nlohmann::ordered_json json{{"subject", nameOf(plan.kind)}, {"study_seed", plan.seed}, {"subject_seed", subjectSeed}};
  if (plan.kind == SubjectKind::kGenerator) {
    json["effects"] = nlohmann::ordered_json::parse(jsonText(plan.effects, protocol));
  } else {
    json["renderer"] = plan.renderer;
    json["frame_width"] = plan.screen.width;
    json["frame_height"] = plan.screen.height;
    json["refresh_hertz"] = plan.screen.refreshHertz;
    json["hashes_frames"] = plan.hashFrames;
    json["factors"] = nlohmann::ordered_json::parse(jsonText(drawHumanFactors(subjectSeed, plan.factors)));
  }
  return textOfJson(json);
}

void requireSame(const StudyDatabase& database, const SubjectWork& work) {
  for (const StoredRun& run : database.runs(work.subject.id, 1)) {
    if (run.record.simulation != work.simulation) {
      throw InputError(
          fmt::format("subject {} was simulated with other settings", work.subject.id), database.path().string(),
          "give the same --seed, --kind, --frame, --renderer, --factors and --effects as before, another --first, or "
          "another file");
    }
  }
}

std::vector<SubjectWork> prepare(StudyDatabase& database, const Protocol& protocol, const SimulationPlan& plan) {
  std::vector<SubjectWork> all;
  for (size_t i = 0; i < plan.sessions.size(); ++i) {
    SubjectWork work;
    const std::string id = fmt::format("{}{:04}", plan.idPrefix, i + 1);
    const std::optional<StoredSubject> known = database.subject(id);
    work.subject = known ? *known : database.addSubject(id, plan.kind);
    if (work.subject.kind != plan.kind) {
      throw InputError(fmt::format("subject {} is there already, as a {}", id, nameOf(work.subject.kind)),
                       database.path().string(), "give another --first, or another file");
    }
    work.seed = seedOf(plan.seed, i);
    work.sessions = plan.sessions[i];
    work.simulation = simulationJson(protocol, plan, work.seed);
    requireSame(database, work);
    for (int session = 1; session <= work.sessions; ++session) {
      const std::optional<StoredSession> stored = database.session(id, session);
      work.begun.push_back(stored.has_value());
      work.complete.push_back(stored && stored->ending == SessionEnding::kCompleted);
      work.done.push_back(sessionDone(database, protocol, id, session));
    }
    all.push_back(std::move(work));
  }
  return all;
}

/// Sessions of one subject, one after the other.
class SubjectRunner {
 public:
  SubjectRunner(const Protocol& protocol, const StudyDatabase& database, const SimulationPlan& plan,
                const SubjectWork& work, const std::function<void()>& sessionDone)
      : protocol_(protocol), database_(database), plan_(plan), work_(work), sessionDone_(sessionDone) {}

  void run() const {
    std::optional<SessionObserver> observer;
    if (plan_.kind == SubjectKind::kObserver) {
      observer.emplace(protocol_, ObserverSetting{plan_.screen, plan_.makeRenderer(), plan_.hashFrames, plan_.factors},
                       work_.seed);
    }
    int open = work_.open();
    for (int session = 1; session <= work_.sessions && open > 0; ++session) {
      const auto index = static_cast<size_t>(session - 1);
      const SessionSchedule schedule = scheduleOf(protocol_, work_.subject.slot, session, work_.seed);
      if (work_.complete[index]) {
        if (observer) {
          NoSink nowhere;  // for what the subject learned in it
          simulateSession(protocol_, {schedule, plan_.screen}, *observer, nowhere);
        }
        continue;
      }
      TrialStore store(database_, protocol_, runRecord(session), schedule, {.durable = false});
      SkippingSink rest(store, work_.done[index]);
      SessionSink& sink = work_.begun[index] ? static_cast<SessionSink&>(rest) : store;
      if (observer) {
        simulateSession(protocol_, {schedule, plan_.screen}, *observer, sink);
      } else {
        generateSession(protocol_, {schedule, plan_.effects, plan_.seed, work_.seed}, sink);
      }
      store.flush();
      if (const std::optional<std::string> failure = store.failure()) {
        throw WorkError(*failure, database_.path().string(), "run it again: it goes on where it stopped");
      }
      --open;
      sessionDone_();
    }
  }

 private:
  RunRecord runRecord(int session) const {
    RunRecord run;
    run.subject = work_.subject.id;
    run.kind = plan_.kind;
    run.slot = work_.subject.slot;
    run.session = session;
    run.startedUtc = simulatedUtc(session, 0);
    run.programVersion = programVersion();
    run.station = "simulation";
    run.environment = R"({"simulated": true, "not_measured": ["screen", "input latency", "frame times"]})";
    run.timingCheck = R"({"simulated": true, "verdict": "simulated_clock"})";
    run.simulation = work_.simulation;
    return run;
  }

  const Protocol& protocol_;
  const StudyDatabase& database_;
  const SimulationPlan& plan_;
  const SubjectWork& work_;
  const std::function<void()>& sessionDone_;
};

/// What there is to do.
SimulationResult workIn(const std::vector<SubjectWork>& all, const Protocol& protocol) {
  SimulationResult result;
  int total = 0;
  for (const SubjectWork& work : all) {
    total += work.sessions;
    result.sessions += work.open();
    for (int session = 1; session <= work.sessions; ++session) {
      result.trials += static_cast<int>(scheduleOf(protocol, work.subject.slot, session, work.seed).trials.size());
    }
  }
  result.sessionsBefore = total - result.sessions;
  return result;
}

}  // namespace

std::vector<int> sessionsFromText(const std::string& text, int subjects, int most, const std::string& where) {
  std::vector<int> sessions;
  std::string_view left = text;
  while (!left.empty()) {
    const size_t comma = std::min(left.find(','), left.size());
    const std::string_view part = left.substr(0, comma);
    left.remove_prefix(std::min(comma + 1, left.size()));
    const size_t times = part.find('x');
    const std::optional<int> count = numberFromText<int>(part.substr(0, times));
    const std::optional<int> each = times == part.npos ? subjects : numberFromText<int>(part.substr(times + 1));
    if (!count || !each || *count < 1 || *count > most || *each < 1 || *each > kMaxSubjects) {
      throw InputError(fmt::format("\"{}\" does not say how many sessions for how many subjects, or the protocol has "
                                   "but {} sessions",
                                   text, most),
                       where, "write SESSIONSxSUBJECTS, such as 3x25,1x20, or SESSIONS for all");
    }
    sessions.insert(sessions.end(), static_cast<size_t>(*each), *count);
  }
  if (static_cast<int>(sessions.size()) != subjects) {
    throw InputError(fmt::format("\"{}\" is for {} subjects, but there are to be {}", text, sessions.size(), subjects),
                     where, "let the numbers of subjects add up to that of --subjects");
  }
  return sessions;
}

SimulationResult addSubjects(const Protocol& protocol, const std::filesystem::path& path, const SimulationPlan& plan) {
  StudyDatabase database = StudyDatabase::openForSessions(path, protocol);
  return workIn(prepare(database, protocol, plan), protocol);
}

SimulationResult simulateStudy(const Protocol& protocol, const std::filesystem::path& path, const SimulationPlan& plan,
                               const Progress& progress) {
  keepFreedMemory();
  StudyDatabase database = StudyDatabase::openForSessions(path, protocol);
  std::vector<SubjectWork> all = prepare(database, protocol, plan);
  std::vector<SubjectWork> mine;
  for (auto i = static_cast<size_t>(plan.part); i < all.size(); i += static_cast<size_t>(plan.parts)) {
    mine.push_back(std::move(all[i]));
  }
  const SimulationResult result = workIn(mine, protocol);
  const int total = result.sessions + result.sessionsBefore;
  std::mutex mutex;
  int finished = result.sessionsBefore;
  const std::function<void()> sessionFinished = [&] {
    const std::scoped_lock lock(mutex);
    report(progress, "simulating sessions", static_cast<double>(++finished) / std::max(total, 1));
  };
  report(progress, "simulating sessions", static_cast<double>(finished) / std::max(total, 1));
  parallelFor(mine.size(), 1, [&](size_t begin, size_t end) {
    for (size_t i = begin; i < end; ++i) {
      runAlone([&] { SubjectRunner(protocol, database, plan, mine[i], sessionFinished).run(); });
    }
  });
  return result;
}

}  // namespace ocelli
