// The statements by which a run of a session is stored. For .cpp files: it shows SQLiteCpp.
#pragma once

#include <functional>
#include <map>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "study/session/records.h"
#include "study/store/sqlite_connection.h"

namespace ocelli {

struct TrialBegins {
  int number = 0;
  TrialPlan plan;
  int attempt = 1;
};
struct TrialFrames {
  int number = 0;
  std::vector<FrameRecord> records;
};
struct TrialInputs {
  int number = 0;
  int64_t firstIndex = 0;  ///< of the trial
  std::vector<InputRecord> records;
};
struct TrialGaze {
  int number = 0;
  int64_t firstIndex = 0;  ///< of the trial
  std::vector<GazeRecord> records;
};
struct TrialEnds {
  int number = 0;
  TrialRecord record;
  std::function<void()> acknowledged;
};
struct SessionEnds {
  SessionEnding ending = SessionEnding::kCompleted;
  std::string utc;
};
using StoreMessage = std::variant<ConsentRecord, AnswerRecord, EventRecord, TrialBegins, TrialFrames, TrialInputs,
                                  TrialGaze, TrialEnds, SessionEnds>;

class TrialWriter {
 public:
  /// `blocks` are the names of the protocol's blocks, `conditions` its conditions.
  TrialWriter(SQLite::Database& database, int64_t runId, RunRecord run, std::vector<std::string> blocks,
              ViewConditions conditions);

  /// To be called within a transaction. A message of a transaction that failed may be written again. Frames, input and
  /// gaze of a trial whose beginning was refused are dropped; its end throws.
  void write(const StoreMessage& message);
  /// After an error: lets go of what the statements hold.
  void reset() noexcept;

 private:
  void write(const ConsentRecord& record);
  void write(const AnswerRecord& record);
  void write(const EventRecord& record);
  void write(const TrialBegins& message);
  void write(const TrialFrames& message);
  void write(const TrialInputs& message);
  void write(const TrialGaze& message);
  void write(const TrialEnds& message);
  void write(const SessionEnds& message);
  /// Nothing where its beginning was refused.
  std::optional<int64_t> idOf(int trial) const;
  /// Binds run, subject, session and mark to the first four parameters.
  void begin(SQLite::Statement& statement) const;

  SQLite::Database& database_;
  const int64_t runId_;
  const RunRecord run_;
  const int simulated_;
  const std::vector<std::string> blocks_;
  const ViewConditions conditions_;
  std::map<int, int64_t> trials_;  ///< their rows
  SQLite::Statement consent_;
  SQLite::Statement answer_;
  SQLite::Statement event_;
  SQLite::Statement trialBegins_;
  SQLite::Statement frame_;
  SQLite::Statement input_;
  SQLite::Statement gaze_;
  SQLite::Statement trialEnds_;
  SQLite::Statement sessionEnds_;
};

}  // namespace ocelli
