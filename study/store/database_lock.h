// Keeps a second program from running sessions on the same database: two stations use two files.
//
// The lock is a file beside the database, NAME.lock, that tells who holds it. It ends with the process, however that
// ends. Readers need no lock.
#pragma once

#include <filesystem>
#include <optional>
#include <string>

namespace ocelli {

class DatabaseLock {
 public:
  /// Throws WorkError naming the process that holds it, or where the file cannot be made. Holders within one process
  /// exclude one another too.
  explicit DatabaseLock(std::filesystem::path database);
  ~DatabaseLock();
  DatabaseLock(DatabaseLock&& other) noexcept;
  DatabaseLock& operator=(DatabaseLock&&) = delete;

  static std::filesystem::path fileOf(const std::filesystem::path& database);
  /// Who holds the lock of that database, if anyone does. Leaves no trace.
  static std::optional<std::string> holderOf(const std::filesystem::path& database);

 private:
  std::filesystem::path file_;
  int descriptor_ = -1;
};

}  // namespace ocelli
