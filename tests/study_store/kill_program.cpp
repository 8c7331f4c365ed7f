// Kills running sessions many times and prints what became of them (scripts/kill_study.sh). Exit code 1 where anything
// was lost.
//
// Usage: study_store_kill_program KILLS [SEED]
#include <fmt/format.h>

#include <cstdio>
#include <string>

#include "tests/base/temporary_folder.h"
#include "tests/study_store/kill_harness.h"

int main(int count, char** arguments) {
  using namespace ocelli::test;
  if (count != 2 && count != 3) {
    fmt::print(stderr, "usage: {} KILLS [SEED]\n", arguments[0]);
    return 2;
  }
  const int kills = std::stoi(arguments[1]);
  const TemporaryFolder folder;
  const KillReport report =
      killSessions(OCELLI_KILL_CHILD, folder.path(), kills, count == 3 ? std::stoull(arguments[2]) : 1, [](int done) {
        if (done % 100 == 0) {
          fmt::print(stderr, "{} kills\n", done);
        }
      });
  for (const std::string& problem : report.problems) {
    fmt::print("PROBLEM {}\n", problem);
  }
  fmt::print(
      "kills                              {}\n"
      "  before there was a database      {}\n"
      "acknowledged trials                {}\n"
      "trials cut short by a kill         {}\n"
      "starts that went on with a session {}\n"
      "subjects who came to the end       {}\n"
      "problems                           {}\n",
      report.kills, report.killedBeforeFile, report.acknowledged, report.interrupted, report.resumed, report.subjects,
      report.problems.size());
  return report.problems.empty() ? 0 : 1;
}
