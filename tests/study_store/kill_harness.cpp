#include "tests/study_store/kill_harness.h"

#include <SQLiteCpp/SQLiteCpp.h>
#include <fcntl.h>
#include <fmt/format.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <csignal>
#include <map>
#include <set>
#include <sstream>
#include <thread>

#include "oc_core/base/random.h"
#include "study/session/trial_rows.h"
#include "study/store/study_database.h"
#include "tests/study_store/kill_study.h"

namespace ocelli::test {
namespace {

namespace fs = std::filesystem;

constexpr int kKillsOfDatabase = 100;
/// A start until its sessions end takes more than a second. A third of all kills come at any moment of half a second, a
/// third in the first moments, a third at an acknowledgement.
constexpr size_t kLongMicroseconds = 600'000;
constexpr size_t kShortMicroseconds = 60'000;

class Child {
 public:
  Child(const fs::path& program, const fs::path& database, const std::string& subject) {
    std::array<int, 2> ends{};
    if (pipe2(ends.data(), O_CLOEXEC) != 0) {
      return;
    }
    process_ = fork();
    if (process_ == 0) {
      dup2(ends[1], STDOUT_FILENO);
      execl(program.c_str(), program.c_str(), database.c_str(), subject.c_str(), nullptr);
      _exit(127);
    }
    close(ends[1]);
    output_ = ends[0];
  }
  void kill() const { ::kill(process_, SIGKILL); }
  /// Listens until it has said that so many trials are stored, or has ended.
  void awaitStored(size_t trials) {
    while (count("stored ") < trials && hear()) {
    }
  }
  /// All that it said, once it has ended. Sets `status` as waitpid() does.
  std::string finish(int& status) {
    while (hear()) {
    }
    close(output_);
    waitpid(process_, &status, 0);
    return std::move(said_);
  }

 private:
  bool hear() {
    std::array<char, 4096> bytes{};
    const ssize_t heard = read(output_, bytes.data(), bytes.size());
    if (heard > 0) {
      said_.append(bytes.data(), static_cast<size_t>(heard));
    }
    return heard > 0;
  }
  size_t count(const std::string& what) const {
    size_t found = 0;
    for (size_t at = said_.find(what); at != std::string::npos; at = said_.find(what, at + 1)) {
      ++found;
    }
    return found;
  }

  std::string said_;
  pid_t process_ = -1;
  int output_ = -1;
};

class Harness {
 public:
  Harness(fs::path child, fs::path folder, uint64_t seed)
      : child_(std::move(child)), folder_(std::move(folder)), random_(seed) {}

  KillReport run(int kills, const std::function<void(int)>& progress) {
    newDatabase();
    while (report_.kills < kills && report_.problems.empty()) {
      if (report_.kills > 0 && report_.kills % kKillsOfDatabase == 0 && killsOfDatabase_ > 0) {
        endDatabase();
        newDatabase();
      }
      killOnce();
      if (progress) {
        progress(report_.kills);
      }
    }
    endDatabase();
    return std::move(report_);
  }

 private:
  void newDatabase() {
    database_ = folder_ / fmt::format("study-{}.db", ++databases_);
    acknowledged_.clear();
    subject_ = 1;
    killsOfDatabase_ = 0;
  }
  std::string subjectName() const { return fmt::format("S{:02}", subject_); }

  void killOnce() {
    Child child(child_, database_, subjectName());
    switch (random_.below(3)) {
      case 0:
        sleep(kShortMicroseconds);
        break;
      case 1:
        sleep(kLongMicroseconds);
        break;
      default:
        // Right after a word that a trial is stored.
        child.awaitStored(1 + random_.below(6));
        break;
    }
    child.kill();
    int status = 0;
    listen(child.finish(status));
    if (WIFSIGNALED(status)) {
      ++report_.kills;
      ++killsOfDatabase_;
    } else if (!WIFEXITED(status) || WEXITSTATUS(status) != 0) {
      problem("the program failed");
    }
    if (!fs::exists(database_)) {
      ++report_.killedBeforeFile;
    } else if (random_.below(2) == 0) {
      look();
    }
  }

  void sleep(size_t maxMicroseconds) {
    std::this_thread::sleep_for(std::chrono::microseconds(random_.below(maxMicroseconds)));
  }

  /// Every subject that has begun comes to the end.
  void endDatabase() {
    if (!report_.problems.empty()) {
      return;
    }
    int status = 0;
    listen(Child(child_, database_, subjectName()).finish(status));
    if (!WIFEXITED(status) || WEXITSTATUS(status) != 0) {
      problem("the last start did not come to the end");
      return;
    }
    look();
    checkComplete();
  }

  /// A line that was cut off by a kill has not been said.
  void listen(const std::string& text) {
    std::istringstream lines(text.substr(0, text.rfind('\n') + 1));
    for (std::string line; std::getline(lines, line);) {
      if (line.starts_with("stored ")) {
        acknowledged_[subjectName()].push_back(fmt::format("{} {}", sessionNow_, line));
        ++report_.acknowledged;
      } else if (line.starts_with("resumes ")) {
        int completed = 0;
        std::istringstream(line.substr(8)) >> sessionNow_ >> completed;
        report_.resumed += completed > 0 ? 1 : 0;
      } else if (line == "done") {
        ++report_.subjects;
        ++subject_;
      }
    }
  }

  void look() {
    {
      SQLite::Database raw(database_.string(), SQLite::OPEN_READWRITE);
      const std::string verdict = raw.execAndGet("PRAGMA integrity_check").getString();
      if (verdict != "ok") {
        problem("SQLite says: " + verdict);
      }
      if (SQLite::Statement(raw, "PRAGMA foreign_key_check").executeStep()) {
        problem("rows do not fit together");
      }
      if (raw.execAndGet("SELECT count(*) FROM sqlite_schema WHERE name = 'study'").getInt() == 0) {
        return;  // killed before the tables were made
      }
    }
    const StudyDatabase database = StudyDatabase::openForReading(database_);
    for (const auto& [subject, lines] : acknowledged_) {
      std::set<std::string> stored;
      std::map<int64_t, int> openTrials;
      for (const TrialRow& trial : database.trials(subject)) {
        if (trial.ending) {
          stored.insert(fmt::format("{} {}", trial.session, lineOf(toldOf(database, trial))));
        } else if (++openTrials[trial.runId] > 1) {
          problem("two trials of a run lack their ends");
        }
      }
      for (const std::string& line : lines) {
        if (!stored.contains(line)) {
          problem(fmt::format("lost, though it was acknowledged: {} {}", subject, line));
        }
      }
    }
  }

  static AcknowledgedTrial toldOf(const StudyDatabase& database, const TrialRow& trial) {
    TrialDigest digest;
    for (const FrameRecord& frame : database.frames(trial.trialId)) {
      digest.add(frame);
    }
    for (const InputRecord& input : database.inputs(trial.trialId)) {
      digest.add(input);
    }
    for (const GazeRecord& sample : database.gaze(trial.trialId)) {
      digest.add(sample);
    }
    const TrialRecord record = recordOf(trial);
    return {record.plan.index,     record.attempt,        record.plan.practice,
            nameOf(record.ending), record.outcome.answer, digest.value()};
  }

  void checkComplete() {
    const StudyDatabase database = StudyDatabase::openForReading(database_);
    const auto sessions = static_cast<size_t>(killProtocol().sessions);
    for (const StoredSubject& subject : database.subjects()) {
      const std::vector<StoredSession> stored = database.sessions(subject.id);
      if (stored.size() != sessions) {
        problem(subject.id + " lacks a session");
      }
      for (const StoredSession& session : stored) {
        if (session.ending != SessionEnding::kCompleted || session.completedTrials != session.plannedTrials) {
          problem(fmt::format("session {} of {} is not complete", session.session, subject.id));
        }
      }
      for (const TrialRow& trial : database.trials(subject.id)) {
        report_.interrupted += trial.ending ? 0 : 1;
      }
    }
    SQLite::Database raw(database_.string());
    if (raw.execAndGet(
               "SELECT count(*) FROM (SELECT 1 FROM final_trial GROUP BY subject_id, session_number, plan_index "
               "HAVING count(*) <> 1)")
            .getInt() != 0) {
      problem("a plan counts twice");
    }
    if (raw.execAndGet("SELECT count(*) FROM (SELECT 1 FROM trial WHERE practice = 0 GROUP BY subject_id, "
                       "session_number, plan_index, attempt HAVING count(*) <> 1)")
            .getInt() != 0) {
      problem("an attempt has the number of an earlier one");
    }
  }

  void problem(const std::string& what) {
    report_.problems.push_back(fmt::format("{} after {} kills: {}", database_.string(), report_.kills, what));
  }

  fs::path child_;
  fs::path folder_;
  Random random_;
  KillReport report_;
  fs::path database_;
  int databases_ = 0;
  int subject_ = 1;
  int sessionNow_ = 0;
  int killsOfDatabase_ = 0;
  std::map<std::string, std::vector<std::string>> acknowledged_;  ///< of subjects
};

}  // namespace

KillReport killSessions(const fs::path& child, const fs::path& folder, int kills, uint64_t seed,
                        const std::function<void(int)>& progress) {
  return Harness(child, folder, seed).run(kills, progress);
}

}  // namespace ocelli::test
