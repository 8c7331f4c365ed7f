// A subject withdraws: everything of theirs is deleted, so that no byte of it remains in the database, in its log, in
// exports and reports that the database knows of, and, where that is named, in the identity key. The audit trail keeps
// that a withdrawal happened and when, and nothing that tells whose it was but to who has a copy of the subject's rows:
// withdrawals.h.
//
// Out of reach: exports and databases that were copied or moved, copies at stations that were merged, backups, and
// blocks of a disk that no file uses any more.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace ocelli {

struct WithdrawOptions {
  /// Deletes the files of exports that hold the subject; without, such an export is an InputError that lists them.
  bool deleteExports = false;
  std::optional<std::filesystem::path> keyFile{};  ///< identity_key.h
};

struct WithdrawReport {
  /// There was no such subject (any more), but an earlier withdrawal had left bytes, which are wiped now.
  bool onlyLeftovers = false;
  int sessions = 0;
  int trials = 0;
  std::vector<std::filesystem::path> deletedFiles{};  ///< of exports
  bool identityRemoved = false;
  /// Notes about other subjects that hold this id: they stay, and someone should look at them.
  int notesThatNameIt = 0;
};

/// Throws InputError where there is no such subject and nothing is left of one; WorkError where another program uses or
/// exports the database.
WithdrawReport withdrawSubject(const std::filesystem::path& database, const std::string& subject,
                               const WithdrawOptions& options);

/// Files of exports from that database that are still there and hold that id; of reports that hold it, all files.
std::vector<std::filesystem::path> exportsWith(const std::filesystem::path& database, const std::string& subject);

}  // namespace ocelli
