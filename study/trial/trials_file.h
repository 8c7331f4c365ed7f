// The file that holds the trials of a study: an SQLite database (protocols/trials.schema.sql), as it is read by whoever
// reads it. study/store/ makes and writes it. For .cpp files: it shows SQLiteCpp.
#pragma once

#include <SQLiteCpp/Database.h>
#include <SQLiteCpp/Exception.h>

#include <cstdint>
#include <filesystem>
#include <string>

namespace ocelli {

/// `application_id` of these files: "Ocel".
inline constexpr int32_t kTrialsApplicationId = 0x4f63656c;
/// `user_version` of files that this program writes, and the oldest that it reads as they are. An analysis asks for
/// nothing that these do not have.
inline constexpr int kTrialsSchemaVersion = 4;
inline constexpr int kOldestTrialsSchemaVersion = 1;

/// Milliseconds for which a connection waits for a program that writes.
inline constexpr int kBusyMilliseconds = 10'000;

/// How to open a database so that reading changes nothing and leaves no file behind: the log of a program that runs or
/// was killed stays as it is; without one, the files that SQLite makes go when it is closed; in a folder that cannot be
/// written none are made.
std::string uriForReading(const std::filesystem::path& path);

/// A connection that cannot write, to any database. Throws InputError where there is no such file or it is none.
SQLite::Database openForReading(const std::filesystem::path& path);

/// `user_version` of a database. Throws InputError where it is empty, another program's or of a newer version.
int trialsVersionOf(SQLite::Database& database, const std::filesystem::path& path);

/// openForReading() of a study's database of a known version. Throws InputError for any other.
SQLite::Database openTrials(const std::filesystem::path& path);

/// Throws InputError where rows of the tables are damaged, or break the rules of the schema. Logs of frames and inputs
/// are by far the largest, and are not looked at.
void checkIntegrity(SQLite::Database& database, const std::filesystem::path& path);

/// What is thrown for an error of SQLite while doing something ("store a trial") to that file: InputError where the
/// file is damaged or none of a study, WorkError for the rest.
[[noreturn]] void throwSqliteError(const SQLite::Exception& error, const std::string& doing,
                                   const std::filesystem::path& path);
/// What SQLite's error means, and what to do about it, in one line.
std::string describeSqliteError(const SQLite::Exception& error);

/// The same while reading: InputError too for a file that lacks tables or columns of a study.
[[noreturn]] void throwReadingError(const SQLite::Exception& error, const std::filesystem::path& path);

/// Calls `work()`, turning errors of SQLite into ours.
template <class Work>
auto withSqliteErrors(const std::string& doing, const std::filesystem::path& path, const Work& work) {
  try {
    return work();
  } catch (const SQLite::Exception& error) {
    throwSqliteError(error, doing, path);
  }
}
template <class Work>
auto whileReading(const std::filesystem::path& path, const Work& work) {
  try {
    return work();
  } catch (const SQLite::Exception& error) {
    throwReadingError(error, path);
  }
}

}  // namespace ocelli
