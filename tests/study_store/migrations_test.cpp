// Databases of older versions are brought up to date with all their rows, or left as they are.
#include "study/store/migrations.h"

#include <SQLiteCpp/SQLiteCpp.h>
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>
#include <map>
#include <regex>
#include <set>
#include <sstream>

#include "oc_core/base/error.h"
#include "study/store/study_database.h"
#include "study/store/trials_schema.h"
#include "study/trial/trials_file.h"
#include "tests/base/temporary_folder.h"
#include "tests/study_store/made_study.h"
#include "tests/study_store/study_checks.h"

namespace ocelli::test {
namespace {

using testing::HasSubstr;

// A made-up future: version N + 1 has another column and N + 2 a table made anew, which is what SQLite needs to change
// a constraint.
const std::vector<Migration> kSteps{
    {kTrialsSchemaVersion, "ALTER TABLE consent ADD COLUMN language TEXT"},
    {kTrialsSchemaVersion + 1,
     "CREATE TABLE audit_new (audit_id INTEGER PRIMARY KEY, at_utc TEXT NOT NULL, action TEXT NOT NULL CHECK (action "
     "<> ''), detail_json TEXT NOT NULL, program_version TEXT NOT NULL, station TEXT NOT NULL) STRICT;"
     "INSERT INTO audit_new SELECT * FROM audit; DROP TABLE audit; ALTER TABLE audit_new RENAME TO audit;"}};

class MigrationsTest : public testing::Test {
 protected:
  MigrationsTest() {
    StudyDatabase database = StudyDatabase::openForSessions(file_, madeProtocol());
    database.addSubject("S01", SubjectKind::kPerson);
  }
  int version() const {
    return SQLite::Database(file_.string(), SQLite::OPEN_READONLY).execAndGet("PRAGMA user_version").getInt();
  }

  TemporaryFolder folder_;
  const std::filesystem::path file_ = folder_ / "study.db";
};

TEST_F(MigrationsTest, TakeEveryStepAndKeepAllRows) {
  SQLite::Database database(file_.string(), SQLite::OPEN_READWRITE);
  migrate(database, kSteps, kTrialsSchemaVersion + 2, file_);
  EXPECT_EQ(database.execAndGet("PRAGMA user_version").getInt(), kTrialsSchemaVersion + 2);
  EXPECT_EQ(database.execAndGet("SELECT subject_id FROM subject").getString(), "S01");
  EXPECT_EQ(database.execAndGet("SELECT count(*) FROM pragma_table_info('consent') WHERE name = 'language'").getInt(),
            1);
  EXPECT_EQ(database.execAndGet("SELECT group_concat(action) FROM audit").getString(), "created,migrated");
  EXPECT_THAT(database.execAndGet("SELECT detail_json FROM audit WHERE action = 'migrated'").getString(),
              HasSubstr(fmt::format(R"("from": {}, "to": {})", kTrialsSchemaVersion, kTrialsSchemaVersion + 2)));
}

TEST_F(MigrationsTest, StartWhereTheDatabaseIs) {
  SQLite::Database database(file_.string(), SQLite::OPEN_READWRITE);
  migrate(database, kSteps, kTrialsSchemaVersion + 1, file_);
  migrate(database, kSteps, kTrialsSchemaVersion + 2, file_);
  migrate(database, kSteps, kTrialsSchemaVersion + 2, file_);
  EXPECT_EQ(database.execAndGet("SELECT group_concat(action) FROM audit").getString(), "created,migrated,migrated");
}

TEST_F(MigrationsTest, LeaveTheDatabaseAsItWasWhereAStepFails) {
  SQLite::Database database(file_.string(), SQLite::OPEN_READWRITE);
  const std::vector<Migration> broken{kSteps[0],
                                      {kTrialsSchemaVersion + 1, "DROP VIEW final_trial; NO SUCH STATEMENT"}};
  EXPECT_THROW(migrate(database, broken, kTrialsSchemaVersion + 2, file_), WorkError);
  EXPECT_EQ(version(), kTrialsSchemaVersion);
  EXPECT_EQ(database.execAndGet("SELECT count(*) FROM final_trial").getInt(), 0);
  EXPECT_EQ(database.execAndGet("SELECT count(*) FROM pragma_table_info('consent') WHERE name = 'language'").getInt(),
            0);
}

TEST_F(MigrationsTest, RefuseRowsThatWouldNoLongerFitTogether) {
  SQLite::Database database(file_.string(), SQLite::OPEN_READWRITE);
  database.exec(
      "INSERT INTO session (subject_id, session_number, schedule_json, seed, planned_trials, started_utc, simulated) "
      "VALUES ('S01', 1, '{}', 1, 0, '', 0)");
  const std::vector<Migration> broken{{kTrialsSchemaVersion, "DROP TRIGGER subject_delete; DELETE FROM subject"}};
  EXPECT_THROW(migrate(database, broken, kTrialsSchemaVersion + 1, file_), WorkError);
  EXPECT_EQ(database.execAndGet("SELECT count(*) FROM subject").getInt(), 1);
}

TEST_F(MigrationsTest, RefuseAVersionThatIsNoLongerKnown) {
  SQLite::Database database(file_.string(), SQLite::OPEN_READWRITE);
  database.exec("PRAGMA user_version = 0");
  EXPECT_THAT(messageOf<InputError>([&] { migrate(database, kSteps, kTrialsSchemaVersion + 2, file_); }),
              HasSubstr("version 0, which is no longer known"));
  EXPECT_EQ(version(), 0);
}

// What protocols/trials.schema.sql makes must be what the migrations make of older tables: where the number in one is
// raised without the other, this fails.
TEST_F(MigrationsTest, LeadToTheVersionThatNewDatabasesHave) {
  EXPECT_EQ(version(), kTrialsSchemaVersion);
  for (int from = 1; from < kTrialsSchemaVersion; ++from) {
    EXPECT_TRUE(std::any_of(migrations().begin(), migrations().end(), [&](const Migration& m) {
      return m.from == from;
    })) << from;
  }
  EXPECT_EQ(migrations().size(), static_cast<size_t>(kTrialsSchemaVersion - 1));
}

struct OldFile {
  int version = 1;
  size_t frames = 0;  ///< of its six trials
};

/// A file of an older version, with the rows that a program of that version wrote.
class OldVersion : public testing::TestWithParam<OldFile> {
 protected:
  OldVersion() {
    std::ifstream in(fmt::format("{}/tests/study_store/version_{}.sql", OCELLI_SOURCE_DIR, GetParam().version));
    std::ostringstream sql;
    sql << in.rdbuf();
    SQLite::Database database(file_.string(), SQLite::OPEN_READWRITE | SQLite::OPEN_CREATE);
    database.exec(sql.str());
    database.exec(
        fmt::format("PRAGMA application_id = {}; PRAGMA user_version = {}", kTrialsApplicationId, GetParam().version));
    before_ = rowsOf(database);
  }

  static inline const std::set<std::string> kLaterColumns{"exposure_rule", "exposure_shown_s"};
  static inline const std::set<std::string> kLaterTables{"gaze"};
  /// All rows of all tables but the audit trail, to which the migration adds one; without tables and columns that came
  /// later, which must be empty.
  static std::map<std::string, std::vector<std::string>> rowsOf(SQLite::Database& database) {
    std::map<std::string, std::vector<std::string>> rows;
    SQLite::Statement tables(database, "SELECT name FROM sqlite_schema WHERE type = 'table' AND name <> 'audit'");
    while (tables.executeStep()) {
      const std::string name = tables.getColumn(0).getString();
      SQLite::Statement all(database, fmt::format("SELECT * FROM {}", name));
      std::vector<std::string>& list = rows[name];
      while (all.executeStep()) {
        std::string row;
        for (int i = 0; i < all.getColumnCount(); ++i) {
          if (GetParam().version == 1 && kLaterColumns.contains(all.getColumnName(i))) {
            EXPECT_TRUE(all.getColumn(i).isNull());
            continue;
          }
          row += fmt::format("{}={}|", all.getColumnName(i), all.getColumn(i).getString());
        }
        list.push_back(row);
      }
      if (kLaterTables.contains(name)) {
        EXPECT_TRUE(list.empty());
        rows.erase(name);
      }
    }
    return rows;
  }
  /// Everything that SQLite knows of tables, views, triggers and indices, without comments and spaces.
  static std::map<std::string, std::string> schemaOf(SQLite::Database& database) {
    std::map<std::string, std::string> schema;
    SQLite::Statement all(database, "SELECT type || ' ' || name, coalesce(sql, '') FROM sqlite_schema");
    while (all.executeStep()) {
      const std::string sql = std::regex_replace(all.getColumn(1).getString(), std::regex("--[^\n]*"), "");
      schema[all.getColumn(0).getString()] = std::regex_replace(sql, std::regex("[\\s\"]+"), "");
    }
    return schema;
  }

  TemporaryFolder folder_;
  const std::filesystem::path file_ = folder_ / "old.db";
  std::map<std::string, std::vector<std::string>> before_;
};

TEST_P(OldVersion, OpensWithAllItsRows) {
  const StudyDatabase study = StudyDatabase::openForReading(file_);
  const std::vector<TrialRow> trials = study.trials();
  ASSERT_EQ(trials.size(), 6u);
  EXPECT_EQ(std::count_if(trials.begin(), trials.end(),
                          [](const TrialRow& trial) { return trial.view == TrialView::kOther; }),
            3);
  SQLite::Database database(file_.string(), SQLite::OPEN_READONLY);
  EXPECT_EQ(rowsOf(database), before_);
  EXPECT_EQ(before_.at("trial").size(), 6u);
  EXPECT_EQ(before_.at("frame").size(), GetParam().frames);
  EXPECT_EQ(database.execAndGet("SELECT count(*) FROM final_trial").getInt(), 6);
  EXPECT_EQ(database.execAndGet("SELECT group_concat(action) FROM audit").getString(), "created,migrated");
}

TEST_P(OldVersion, BecomesWhatNewFilesAre) {
  StudyDatabase::openForReading(file_);
  const std::filesystem::path fresh = folder_ / "new.db";
  StudyDatabase::openForSessions(fresh, madeProtocol());
  SQLite::Database migrated(file_.string(), SQLite::OPEN_READONLY);
  SQLite::Database made(fresh.string(), SQLite::OPEN_READONLY);
  EXPECT_EQ(schemaOf(migrated), schemaOf(made));
}

TEST_P(OldVersion, StillKeepsWhatIsRecorded) {
  StudyDatabase::openForReading(file_);
  SQLite::Database database(file_.string(), SQLite::OPEN_READWRITE);
  EXPECT_THROW(database.exec("UPDATE trial SET answer = 'x'"), SQLite::Exception);
  EXPECT_THROW(database.exec("UPDATE trial SET view = 'x'"), SQLite::Exception);
  EXPECT_THROW(database.exec("DELETE FROM trial"), SQLite::Exception);
  EXPECT_THROW(database.exec("DELETE FROM frame"), SQLite::Exception);
}

INSTANTIATE_TEST_SUITE_P(Migrations, OldVersion, testing::Values(OldFile{1, 110}, OldFile{3, 503}),
                         [](const auto& old) { return fmt::format("from{}", old.param.version); });

}  // namespace
}  // namespace ocelli::test
