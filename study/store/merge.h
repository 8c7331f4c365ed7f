// Databases of several stations, joined into one.
#pragma once

#include <filesystem>
#include <set>
#include <string>
#include <vector>

namespace ocelli {

struct MergeReport {
  int subjects = 0;  ///< that the target did not have
  int runs = 0;
  int runsThatWentOn = 0;  ///< since the target got them
  int trials = 0;
  int knownSubjects = 0;  ///< that the target had before
  /// That the sources still have, and that withdrew from the target or another source: left out.
  std::set<std::string> withdrawnSubjects{};
  /// That the target still has, and that withdrew from a source: they stay until they are withdrawn here too.
  std::set<std::string> withdrewElsewhere{};
};

/// Adds all subjects of the sources to `target`, which is made where there is none. Merging a source again adds only
/// what it has got since, to runs that went on too. Who withdrew from the target or a source is left out, and the
/// target remembers it. The sources are only read. Throws InputError, before anything is changed, where a source is of
/// another protocol or version, runs a session, or has a subject whose id the target or another source uses for someone
/// else: the message lists these.
MergeReport mergeDatabases(const std::filesystem::path& target, const std::vector<std::filesystem::path>& sources);

/// How many subjects have each slot: of people, or of simulated subjects. Every slot up to the highest is there.
std::vector<int> slotUse(const std::filesystem::path& database, bool simulated);

}  // namespace ocelli
