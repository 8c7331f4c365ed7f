#include "study/subject/simulate_together.h"

#include <algorithm>
#include <system_error>

#include "oc_core/base/error.h"
#include "study/store/merge.h"

namespace ocelli {
namespace {

namespace fs = std::filesystem;

constexpr const char* kCopy = ".rank";

fs::path copyOfRank(const fs::path& database, int rank) {
  fs::path copy = database;
  copy += kCopy + std::to_string(rank);
  return copy;
}

bool isCopyOf(const fs::path& file, const fs::path& database) {
  const std::string prefix = database.filename().string() + kCopy;
  const std::string name = file.filename().string();
  return name.size() > prefix.size() && name.starts_with(prefix) &&
         std::all_of(name.begin() + static_cast<std::ptrdiff_t>(prefix.size()), name.end(),
                     [](char c) { return c >= '0' && c <= '9'; });
}

/// In the order of their names.
std::vector<fs::path> copiesOf(const fs::path& database) {
  std::vector<fs::path> copies;
  std::error_code ignored;
  const fs::path folder = database.has_parent_path() ? database.parent_path() : fs::path(".");
  for (const fs::directory_entry& entry : fs::directory_iterator(folder, ignored)) {
    if (isCopyOf(entry.path(), database)) {
      copies.push_back(entry.path());
    }
  }
  std::sort(copies.begin(), copies.end());
  return copies;
}

void removeDatabase(const fs::path& path) {
  std::error_code ignored;
  for (const char* beside : {"", "-wal", "-shm", ".lock"}) {
    fs::path file = path;
    file += beside;
    fs::remove(file, ignored);
  }
}

void mergeCopies(const fs::path& database) {
  const std::vector<fs::path> copies = copiesOf(database);
  if (copies.empty()) {
    return;
  }
  mergeDatabases(database, copies);
  std::for_each(copies.begin(), copies.end(), removeDatabase);
}

}  // namespace

SimulationResult simulateTogether(const Protocol& protocol, const fs::path& database, const SimulationPlan& plan,
                                  Ranks& ranks, const Progress& progress) {
  if (ranks.size() == 1) {
    return simulateStudy(protocol, database, plan, progress);
  }
  SimulationResult result;
  if (ranks.isFirst()) {
    mergeCopies(database);
    result = addSubjects(protocol, database, plan);
    for (int rank = 1; rank < ranks.size(); ++rank) {
      std::error_code error;
      fs::copy_file(database, copyOfRank(database, rank), fs::copy_options::overwrite_existing, error);
      if (error) {
        throw WorkError("cannot copy the database for a rank (" + error.message() + ")",
                        copyOfRank(database, rank).string(), "make room there, and run it again");
      }
    }
  }
  ranks.broadcast({});  // the copies are there
  SimulationPlan mine = plan;
  mine.part = ranks.rank();
  mine.parts = ranks.size();
  simulateStudy(protocol, ranks.isFirst() ? database : copyOfRank(database, ranks.rank()), mine, progress);
  ranks.gather({});  // all are finished
  if (ranks.isFirst()) {
    mergeCopies(database);
  }
  return result;
}

}  // namespace ocelli
