#include "study/store/study_database.h"

#include <SQLiteCpp/Transaction.h>
#include <fmt/format.h>

#include <algorithm>
#include <system_error>

#include "oc_core/base/error.h"
#include "study/session/utc_time.h"
#include "study/store/database_state.h"
#include "study/store/leftovers.h"

namespace ocelli {
namespace {

namespace fs = std::filesystem;

fs::path folderOf(const fs::path& path) {
  const fs::path folder = fs::absolute(path).parent_path();
  return folder;
}

void checkSpace(const fs::path& path, uint64_t minFreeBytes) {
  std::error_code error;
  const fs::space_info space = fs::space(folderOf(path), error);
  if (!error && space.available < minFreeBytes) {
    throw WorkError(
        fmt::format("the disk has {} MB left, and sessions need {} MB", space.available >> 20, minFreeBytes >> 20),
        path.string(), "make room on it, or use a folder on another disk");
  }
}

/// Writes what is there already: what cannot be written is found out before a session begins.
void tryWrite(SQLite::Database& database, const fs::path& path) {
  withSqliteErrors("write to this database", path, [&] {
    SQLite::Transaction transaction(database, SQLite::TransactionBehavior::IMMEDIATE);
    database.exec(fmt::format("PRAGMA user_version = {}", kTrialsSchemaVersion));
    transaction.commit();
  });
}

void checkProtocol(SQLite::Database& database, const Protocol& protocol, const fs::path& path) {
  SQLite::Transaction transaction(database, SQLite::TransactionBehavior::IMMEDIATE);
  SQLite::Statement row(database, "SELECT protocol_name, protocol_sha256 FROM study");
  if (!row.executeStep()) {
    insertStudy(database, protocol.name, protocol.sha256, protocol.text);
    transaction.commit();
    return;
  }
  if (textOf(row, 1) != protocol.sha256) {
    throw InputError(
        fmt::format("this database is of the protocol \"{}\" with SHA-256 {}..., and \"{}\" is {}...", textOf(row, 0),
                    textOf(row, 1).substr(0, 12), protocol.name, protocol.sha256.substr(0, 12)),
        path.string(), "a new database for a changed protocol, or the protocol as it was");
  }
}

}  // namespace

StudyDatabase StudyDatabase::openForSessions(const fs::path& path, const Protocol& protocol,
                                             const DatabaseOptions& options) {
  checkSpace(path, options.minFreeBytes);
  auto state = std::make_unique<State>(path, DatabaseAccess::kCreate, DatabaseLock(path));
  withSqliteErrors("open this database", path, [&] { checkProtocol(state->database, protocol, path); });
  tryWrite(state->database, path);
  wipeLeftovers(state->database, path);
  return StudyDatabase(std::move(state));
}

StudyDatabase StudyDatabase::openForReading(const fs::path& path) {
  return StudyDatabase(std::make_unique<State>(path, DatabaseAccess::kRead, std::nullopt));
}

StudyDatabase::StudyDatabase(std::unique_ptr<State> state) : state_(std::move(state)) {}
StudyDatabase::~StudyDatabase() = default;
StudyDatabase::StudyDatabase(StudyDatabase&&) noexcept = default;

const fs::path& StudyDatabase::path() const {
  return state_->path;
}

StoredSubject StudyDatabase::addSubject(const std::string& id, SubjectKind kind, int firstSlot) {
  if (!isSubjectId(id)) {
    throw InputError("this is no id of a subject", "\"" + id + "\"",
                     "a pseudonym such as S01: 1 to 64 letters, digits, - and _, the first a letter or a digit");
  }
  return withSqliteErrors("add a subject", state_->path, [&] {
    SQLite::Database& database = state_->database;
    SQLite::Transaction transaction(database, SQLite::TransactionBehavior::IMMEDIATE);
    if (subject(id)) {
      throw InputError("this database has that subject already", id,
                       "`ocelli study resume` goes on with a subject's sessions; or choose another id");
    }
    const int simulated = kind == SubjectKind::kPerson ? 0 : 1;
    SQLite::Statement used(database,
                           "SELECT DISTINCT slot FROM subject WHERE simulated = ? AND slot >= ? ORDER BY slot");
    used.bind(1, simulated);
    used.bind(2, firstSlot);
    int slot = firstSlot;
    while (used.executeStep() && used.getColumn(0).getInt() == slot) {
      ++slot;
    }
    const StoredSubject added{id, kind, slot, utcNow()};
    SQLite::Statement insert(database,
                             "INSERT INTO subject (subject_id, subject_key, slot, kind, simulated, created_utc) "
                             "VALUES (?, ?, ?, ?, ?, ?)");
    insert.bind(1, id);
    insert.bind(2, randomKey());
    insert.bind(3, slot);
    insert.bind(4, nameOf(kind));
    insert.bind(5, simulated);
    insert.bind(6, added.createdUtc);
    insert.exec();
    used.reset();
    transaction.commit();
    return added;
  });
}

bool isSubjectId(const std::string& id) {
  const auto isLetterOrDigit = [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9');
  };
  // A first - would be an option, or a formula of a spreadsheet.
  return !id.empty() && id.size() <= 64 && isLetterOrDigit(id.front()) &&
         std::all_of(id.begin(), id.end(), [&](char c) { return isLetterOrDigit(c) || c == '-' || c == '_'; });
}

}  // namespace ocelli
