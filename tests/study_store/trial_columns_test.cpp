// The columns of the table `trial` are those that a row names, and no others.
#include <SQLiteCpp/SQLiteCpp.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <set>

#include "study/store/trials_schema.h"
#include "study/trial/trial_row.h"

namespace ocelli::test {
namespace {

TEST(TrialColumns, AreThoseOfTheTable) {
  SQLite::Database database(":memory:", SQLite::OPEN_READWRITE | SQLite::OPEN_CREATE);
  database.exec(trialsSchema());
  std::set<std::string> ofTable;
  SQLite::Statement column(database, "SELECT name FROM pragma_table_info('trial')");
  while (column.executeStep()) {
    ofTable.insert(column.getColumn(0).getString());
  }
  // What rows of all tables have.
  std::set<std::string> ofRow{"trial_id", "run_id", "subject_id", "session_number", "simulated"};
  const TrialRow row;
  forEachTrialColumn(row, [&](const char* name, const auto&) { EXPECT_TRUE(ofRow.insert(name).second) << name; });
  EXPECT_THAT(ofRow, testing::ContainerEq(ofTable));
}

/// Whether the CHECK of a column lists the word.
bool lists(const std::string& table, const std::string& column, const std::string& word) {
  SQLite::Database database(":memory:", SQLite::OPEN_READWRITE | SQLite::OPEN_CREATE);
  database.exec(trialsSchema());
  SQLite::Statement sql(database, "SELECT sql FROM sqlite_schema WHERE name = ?");
  sql.bind(1, table);
  sql.executeStep();
  const std::string text = sql.getColumn(0).getString();
  const size_t list = text.find("CHECK (" + column + " IN (");
  return list != std::string::npos &&
         text.substr(list, text.find("))", list) - list).find("'" + word + "'") != std::string::npos;
}

TEST(TrialColumns, HaveTheWordsOfTheSchema) {
  for (const SubjectKind kind : kSubjectKinds) {
    EXPECT_TRUE(lists("subject", "kind", nameOf(kind))) << nameOf(kind);
  }
  for (const TrialEnding ending : kTrialEndings) {
    EXPECT_TRUE(lists("trial", "ending", nameOf(ending))) << nameOf(ending);
  }
  for (const SessionEnding ending : kSessionEndings) {
    EXPECT_TRUE(lists("run", "ending", nameOf(ending))) << nameOf(ending);
  }
  EXPECT_FALSE(lists("run", "ending", "redone"));
}

}  // namespace
}  // namespace ocelli::test
