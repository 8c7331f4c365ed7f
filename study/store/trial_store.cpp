#include "study/store/trial_store.h"

#include <SQLiteCpp/Transaction.h>
#include <fmt/format.h>
#include <sqlite3.h>

#include <algorithm>
#include <chrono>
#include <condition_variable>
#include <deque>
#include <mutex>
#include <new>
#include <thread>

#include "oc_core/base/check.h"
#include "oc_core/base/error.h"
#include "study/session/utc_time.h"
#include "study/store/trial_writer.h"

namespace ocelli {
namespace {

/// A log of more pages than that is written back into the database, between trials.
constexpr int kCheckpointPages = 1000;

constexpr const char* kRecordRefused = "record_refused";

std::vector<std::string> blockNames(const Protocol& protocol) {
  std::vector<std::string> names;
  for (const ProtocolBlock& block : protocol.blocks) {
    names.push_back(block.name);
  }
  return names;
}

void insertSession(SQLite::Database& database, const RunRecord& run, const SessionSchedule& schedule,
                   const ViewConditions& conditions, int simulated) {
  SQLite::Statement insert(database,
                           "INSERT INTO session (subject_id, session_number, schedule_json, seed, planned_trials, "
                           "started_utc, simulated) VALUES (?, ?, ?, ?, ?, ?, ?) ON CONFLICT DO NOTHING");
  insert.bind(1, run.subject);
  insert.bind(2, run.session);
  insert.bind(3, jsonText(schedule, conditions));
  insert.bind(4, static_cast<int64_t>(schedule.seed));
  insert.bind(5, static_cast<int>(schedule.trials.size()));
  insert.bind(6, run.startedUtc);
  insert.bind(7, simulated);
  insert.exec();
}

/// The row of the run.
int64_t insertRun(SQLite::Database& database, const RunRecord& run, const SessionSchedule& schedule,
                  const ViewConditions& conditions) {
  const int simulated = run.kind == SubjectKind::kPerson ? 0 : 1;
  SQLite::Transaction transaction(database, SQLite::TransactionBehavior::IMMEDIATE);
  insertSession(database, run, schedule, conditions, simulated);
  SQLite::Statement insert(
      database,
      "INSERT INTO run (run_key, subject_id, session_number, run_number, started_utc, program_version, station, "
      "environment_json, timing_check_json, forced, simulation_json, simulated) VALUES (?1, ?2, ?3, (SELECT count(*) + "
      "1 FROM run WHERE subject_id = ?2 AND session_number = ?3), ?4, ?5, ?6, ?7, ?8, ?9, ?10, ?11)");
  insert.bind(1, randomKey());
  insert.bind(2, run.subject);
  insert.bind(3, run.session);
  insert.bind(4, run.startedUtc);
  insert.bind(5, run.programVersion);
  insert.bind(6, run.station);
  insert.bind(7, run.environment);
  insert.bind(8, run.timingCheck);
  insert.bind(9, run.forced ? 1 : 0);
  bindOptional(insert, 10, run.simulation.empty() ? std::nullopt : std::optional(run.simulation));
  insert.bind(11, simulated);
  insert.exec();
  const int64_t id = database.getLastInsertRowid();
  transaction.commit();
  return id;
}

bool isEndOfTrial(const StoreMessage& message) {
  return std::holds_alternative<TrialEnds>(message);
}

}  // namespace

struct TrialStore::State {
  State(const std::filesystem::path& path, const Protocol& protocol, const RunRecord& run,
        const SessionSchedule& schedule, const TrialStoreOptions& options)
      : blocks(static_cast<int>(protocol.blocks.size())),
        interval(options.flushSeconds),
        database(connectStudy(path, DatabaseAccess::kWrite)),
        writer(database, prepare(run, schedule, protocol.conditions.names, options, path), run, blockNames(protocol),
               protocol.conditions.names),
        thread([this] { work(); }) {}

  /// Calls from the session.
  void put(StoreMessage message, bool urgent);
  void checkBegun(int number) const;

  int64_t prepare(const RunRecord& run, const SessionSchedule& schedule, const ViewConditions& conditions,
                  const TrialStoreOptions& options, const std::filesystem::path& path);
  // On the thread.
  void work();
  bool storePending();
  bool storeBatch(size_t count);
  void refuse(size_t index, const std::string& reason);
  void checkpoint();

  // Of the session's thread.
  const int blocks;
  std::vector<int64_t> inputsOfTrial;  ///< so far, of each trial that began
  std::vector<int64_t> gazeOfTrial;    ///< likewise

  mutable std::mutex mutex;
  std::condition_variable wake;
  std::condition_variable settled;
  // Guarded by `mutex`.
  std::vector<StoreMessage> queue;
  bool urgent = false;
  bool stopping = false;
  uint64_t put_ = 0;           ///< messages that came
  uint64_t stored = 0;         ///< messages that are on the disk, or given up
  uint64_t tries = 0;          ///< rounds of storing that ended
  std::string failureNow;      ///< of the last round
  std::string failureForever;  ///< a record that cannot be stored

  // Of the storing thread.
  const std::chrono::duration<double> interval;
  std::deque<StoreMessage> pending;
  int logPages = 0;
  SQLite::Database database;
  TrialWriter writer;
  std::thread thread;
};

int64_t TrialStore::State::prepare(const RunRecord& run, const SessionSchedule& schedule,
                                   const ViewConditions& conditions, const TrialStoreOptions& options,
                                   const std::filesystem::path& path) {
  return withSqliteErrors("store that a session begins", path, [&] {
    database.exec("PRAGMA wal_autocheckpoint = 0");
    if (!options.durable) {
      database.exec("PRAGMA synchronous = NORMAL");
    }
    sqlite3_wal_hook(
        database.getHandle(),
        [](void* pages, sqlite3*, const char*, int count) {
          *static_cast<int*>(pages) = count;
          return SQLITE_OK;
        },
        &logPages);
    return insertRun(database, run, schedule, conditions);
  });
}

void TrialStore::State::put(StoreMessage message, bool isUrgent) {
  {
    const std::lock_guard lock(mutex);
    queue.push_back(std::move(message));
    ++put_;
    urgent = urgent || isUrgent;
  }
  if (isUrgent) {
    wake.notify_one();
  }
}

void TrialStore::State::checkBegun(int number) const {
  OC_CHECK(number >= 0 && number < static_cast<int>(inputsOfTrial.size()), "records are of a trial that began");
}

void TrialStore::State::work() {
  for (bool last = false; !last;) {
    {
      std::unique_lock lock(mutex);
      wake.wait_for(lock, interval, [this] { return urgent || stopping; });
      pending.insert(pending.end(), std::make_move_iterator(queue.begin()), std::make_move_iterator(queue.end()));
      queue.clear();
      urgent = false;
      last = stopping;
    }
    const bool allStored = storePending();
    {
      const std::lock_guard lock(mutex);
      ++tries;
    }
    settled.notify_all();
    if (allStored && logPages > kCheckpointPages) {
      checkpoint();
    }
  }
}

bool TrialStore::State::storePending() {
  while (!pending.empty()) {
    const auto end = std::find_if(pending.begin(), pending.end(), isEndOfTrial);
    const size_t count = end == pending.end() ? pending.size() : static_cast<size_t>(end - pending.begin()) + 1;
    if (!storeBatch(count)) {
      return false;
    }
  }
  return true;
}

bool TrialStore::State::storeBatch(size_t count) {
  size_t written = 0;
  try {
    SQLite::Transaction transaction(database, SQLite::TransactionBehavior::IMMEDIATE);
    try {
      for (; written < count; ++written) {
        writer.write(pending[written]);
      }
    } catch (...) {
      writer.reset();
      throw;
    }
    transaction.commit();
  } catch (const SQLite::Exception& error) {
    if (error.getErrorCode() == SQLITE_CONSTRAINT && written < count) {
      refuse(written, error.what());
      return true;
    }
    const std::lock_guard lock(mutex);
    failureNow = fmt::format("trials are not being stored: {}", describeSqliteError(error));
    return false;
  } catch (const std::bad_alloc&) {
    const std::lock_guard lock(mutex);
    failureNow = "trials are not being stored: no memory is left: close other programs";
    return false;
  } catch (const std::exception& error) {
    if (written >= count) {
      const std::lock_guard lock(mutex);
      failureNow = fmt::format("trials are not being stored: {}", error.what());
      return false;
    }
    refuse(written, error.what());
    return true;
  }
  const StoreMessage last = std::move(pending[count - 1]);
  pending.erase(pending.begin(), pending.begin() + static_cast<std::ptrdiff_t>(count));
  {
    const std::lock_guard lock(mutex);
    stored += count;
    failureNow.clear();
  }
  if (const TrialEnds* trial = std::get_if<TrialEnds>(&last); trial != nullptr && trial->acknowledged) {
    trial->acknowledged();
  }
  return true;
}

// One record that contradicts others must not keep all that follow from being stored: an event tells of it instead.
// Where not even that can be stored, the record is dropped.
void TrialStore::State::refuse(size_t index, const std::string& reason) {
  const EventRecord* event = std::get_if<EventRecord>(&pending[index]);
  const bool isRefusal = event != nullptr && event->what == kRecordRefused;
  if (isRefusal) {
    pending.erase(pending.begin() + static_cast<std::ptrdiff_t>(index));
  } else {
    pending[index] = EventRecord{0, utcNow(), kRecordRefused, reason};
  }
  const std::lock_guard lock(mutex);
  stored += isRefusal ? 1 : 0;
  failureForever = fmt::format("a record cannot be stored ({}); the others are", reason);
}

void TrialStore::State::checkpoint() {
  try {
    database.exec("PRAGMA wal_checkpoint(PASSIVE)");
  } catch (const SQLite::Exception&) {
    // The log stays as it is, and grows: the next trial tries again.
  }
}

TrialStore::TrialStore(const StudyDatabase& database, const Protocol& protocol, const RunRecord& run,
                       const SessionSchedule& schedule, const TrialStoreOptions& options)
    : state_(std::make_unique<State>(database.path(), protocol, run, schedule, options)) {}

TrialStore::~TrialStore() {
  {
    const std::lock_guard lock(state_->mutex);
    state_->stopping = true;
  }
  state_->wake.notify_one();
  state_->thread.join();
}

void TrialStore::consent(const ConsentRecord& record) {
  state_->put(record, false);
}

void TrialStore::answer(const AnswerRecord& record) {
  state_->put(record, false);
}

void TrialStore::trialBegins(int number, const TrialPlan& plan, int attempt) {
  OC_CHECK(number == static_cast<int>(state_->inputsOfTrial.size()), "trials are numbered one after another");
  OC_CHECK(plan.block >= 0 && plan.block < state_->blocks, "a trial is of a block of the protocol");
  state_->inputsOfTrial.push_back(0);
  state_->gazeOfTrial.push_back(0);
  state_->put(TrialBegins{number, plan, attempt}, false);
}

void TrialStore::frames(int number, std::span<const FrameRecord> records) {
  state_->checkBegun(number);
  state_->put(TrialFrames{number, {records.begin(), records.end()}}, false);
}

void TrialStore::inputs(int number, std::span<const InputRecord> records) {
  state_->checkBegun(number);
  int64_t& count = state_->inputsOfTrial[static_cast<size_t>(number)];
  state_->put(TrialInputs{number, count, {records.begin(), records.end()}}, false);
  count += static_cast<int64_t>(records.size());
}

void TrialStore::gaze(int number, std::span<const GazeRecord> records) {
  state_->checkBegun(number);
  int64_t& count = state_->gazeOfTrial[static_cast<size_t>(number)];
  state_->put(TrialGaze{number, count, {records.begin(), records.end()}}, false);
  count += static_cast<int64_t>(records.size());
}

void TrialStore::trialEnds(int number, const TrialRecord& record, std::function<void()> acknowledged) {
  state_->checkBegun(number);
  state_->put(TrialEnds{number, record, std::move(acknowledged)}, true);
}

void TrialStore::event(const EventRecord& record) {
  state_->put(record, false);
}

void TrialStore::sessionEnds(SessionEnding ending, const std::string& utc) {
  state_->put(SessionEnds{ending, utc}, true);
}

void TrialStore::flush() {
  std::unique_lock lock(state_->mutex);
  const uint64_t target = state_->put_;
  const uint64_t triesBefore = state_->tries;
  state_->urgent = true;
  state_->wake.notify_one();
  // A round that runs already may not have what came last, and so fail without telling of it.
  state_->settled.wait(lock, [&] {
    return state_->stored >= target || (!state_->failureNow.empty() && state_->tries >= triesBefore + 2);
  });
}

std::optional<std::string> TrialStore::failure() const {
  const std::lock_guard lock(state_->mutex);
  if (!state_->failureNow.empty()) {
    return state_->failureNow;
  }
  return state_->failureForever.empty() ? std::nullopt : std::optional(state_->failureForever);
}

}  // namespace ocelli
