// Sessions that are killed at random moments, again and again: is every trial there that was acknowledged?
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

namespace ocelli::test {

struct KillReport {
  int kills = 0;
  int acknowledged = 0;               ///< trials, before a kill or without
  int interrupted = 0;                ///< trials that a kill cut short
  int killedBeforeFile = 0;           ///< before there was a database
  int resumed = 0;                    ///< starts that found something done
  int subjects = 0;                   ///< that came to the end of both sessions
  std::vector<std::string> problems;  ///< empty where all is well
};

/// Kills the child, study_store_kill_child, `kills` times with SIGKILL, in databases in `folder`; a new one after each
/// 100 kills. After each kill the next start goes on; every second time the database is first looked at: SQLite finds
/// it sound, each acknowledged trial is there with all its frames and inputs, and no more than one trial lacks its end
/// for each run. In the end every subject comes to the end, with each plan completed. `progress` gets the kills so far.
KillReport killSessions(const std::filesystem::path& child, const std::filesystem::path& folder, int kills,
                        uint64_t seed, const std::function<void(int)>& progress = {});

}  // namespace ocelli::test
