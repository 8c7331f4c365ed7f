// Keeps a second program from running sessions on the same database: two stations use two files.
//
// The lock is a file beside the database, NAME.lock, that tells who holds it. It ends with the process, however that
// ends. Readers need no lock; exports have one of their own, NAME.export.lock, so that they can be made during sessions
// and not during a withdrawal. Names that are links stand for what they lead to.
#pragma once

#include <filesystem>
#include <optional>
#include <string>

namespace ocelli {

/// Without links, whether there is such a file or not: where SQLite keeps it and its log.
std::filesystem::path withoutLinks(const std::filesystem::path& database);

enum class DatabaseUse { kSessions, kExport };

class DatabaseLock {
 public:
  /// Throws WorkError naming the process that holds it, or where the file cannot be made. Holders within one process
  /// exclude one another too.
  explicit DatabaseLock(const std::filesystem::path& database, DatabaseUse use = DatabaseUse::kSessions);
  ~DatabaseLock();
  DatabaseLock(DatabaseLock&& other) noexcept;
  DatabaseLock& operator=(DatabaseLock&&) = delete;

  static std::filesystem::path fileOf(const std::filesystem::path& database, DatabaseUse use = DatabaseUse::kSessions);
  /// Who holds the lock for sessions of that database, if anyone does. Leaves no trace.
  static std::optional<std::string> holderOf(const std::filesystem::path& database);

 private:
  std::filesystem::path file_;
  int descriptor_ = -1;
};

}  // namespace ocelli
