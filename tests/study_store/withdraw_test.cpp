// A subject who withdraws leaves no byte in any file.
#include "study/store/withdraw.h"

#include <SQLiteCpp/SQLiteCpp.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstring>

#include "oc_core/base/error.h"
#include "study/store/database_lock.h"
#include "study/store/export_record.h"
#include "study/store/identity_key.h"
#include "study/store/sqlite_connection.h"
#include "study/store/trial_store.h"
#include "study/store/word_search.h"
#include "tests/base/temporary_folder.h"
#include "tests/study_store/made_study.h"
#include "tests/study_store/study_checks.h"

namespace ocelli::test {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

constexpr const char* kWho = "Zebra42";
constexpr const char* kNote = "wears a yellow raincoat";
constexpr const char* kAnswer = "plays nine instruments";
constexpr double kPlace = 1234.56789012345;      // x of a frame: its eight bytes are in no other row
constexpr int64_t kTime = 0x123456789abcde;      // of an input
constexpr uint64_t kHash = 0x5ca1ab1edeadbea7u;  // of an image

/// A number as SQLite stores it: eight bytes, the most significant first.
std::string storedBytes(uint64_t bits) {
  std::string bytes;
  for (int shift = 56; shift >= 0; shift -= 8) {
    bytes += static_cast<char>((bits >> shift) & 0xff);
  }
  return bytes;
}
std::string storedBytes(double value) {
  uint64_t bits = 0;
  std::memcpy(&bits, &value, sizeof bits);
  return storedBytes(bits);
}

const std::vector<std::pair<std::string, std::string>>& traces() {
  static const std::vector<std::pair<std::string, std::string>> all{
      {"id", kWho},
      {"note", kNote},
      {"answer", kAnswer},
      {"place", storedBytes(kPlace)},
      // Whole numbers of seven bytes take eight.
      {"time", storedBytes(static_cast<uint64_t>(kTime)).substr(1)},
      {"hash", storedBytes(kHash)}};
  return all;
}

class WithdrawTest : public testing::Test {
 protected:
  WithdrawTest() {
    StudyDatabase database = StudyDatabase::openForSessions(file_, protocol_);
    // Others before and after, so that theirs lies between.
    storeSession(database, "S01");
    storeSession(database, kWho);
    storeSession(database, "S03");
  }

  void storeSession(StudyDatabase& database, const std::string& subject) {
    database.addSubject(subject, SubjectKind::kPerson);
    const SessionSchedule schedule = madeSchedule(0, 1, 3);
    TrialStore store(database, protocol_, madeRun(subject, 1), schedule);
    const bool isThem = subject == kWho;
    store.answer({"demographics", "age_band", isThem ? kAnswer : "18-24", ""});
    store.event({1, "", "note", isThem ? kNote : "fine"});
    for (const TrialPlan& plan : schedule.trials) {
      store.trialBegins(plan.index, plan, 1);
      std::vector<FrameRecord> frames = madeFrames(0, 300, plan.index);
      std::vector<InputRecord> inputs = madeInputs();
      std::vector<GazeRecord> gaze = madeGaze();
      if (isThem) {
        frames[150].pose.x = kPlace;
        frames[151].pixelHash = kHash;
        inputs[3].nanoseconds = kTime;
        gaze[0].x = kPlace;
      }
      store.frames(plan.index, frames);
      store.inputs(plan.index, inputs);
      store.gaze(plan.index, gaze);
      store.trialEnds(plan.index, madeTrial(plan, 1, plan.index));
    }
    store.sessionEnds(SessionEnding::kCompleted, "2026-03-01T13:00:00.000Z");
  }

  /// Names of traces that a file of the folder holds.
  std::vector<std::string> tracesLeft() const {
    std::vector<std::string> left;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(folder_.path())) {
      const std::string bytes = entry.is_regular_file() ? fileBytes(entry.path()) : std::string();
      for (const auto& [name, trace] : traces()) {
        if (bytes.find(trace) != std::string::npos || entry.path().string().find(trace) != std::string::npos) {
          left.push_back(name + " in " + entry.path().filename().string());
        }
      }
    }
    return left;
  }
  void addAuditOfExport(const std::string& folder, const std::string& file) const {
    SQLite::Database database = connectStudy(file_, DatabaseAccess::kWrite);
    addAudit(database, "exported", R"({"folder": ")" + folder + R"(", "files": [")" + file + R"("]})");
  }

  TemporaryFolder folder_;
  const std::filesystem::path file_ = folder_ / "study.db";
  const Protocol protocol_ = madeProtocol();
};

TEST_F(WithdrawTest, LeavesNoByteInAnyFile) {
  EXPECT_EQ(tracesLeft().size(), traces().size());  // the search finds what is there
  const std::string key =
      SQLite::Database(file_.string())
          .execAndGet(std::string("SELECT subject_key FROM subject WHERE subject_id = '") + kWho + "'")
          .getString();
  const WithdrawReport report = withdrawSubject(file_, kWho, {});
  EXPECT_EQ(report.sessions, 1);
  EXPECT_EQ(report.trials, 6);
  EXPECT_THAT(tracesLeft(), testing::IsEmpty());
  EXPECT_THAT(fileBytes(file_), Not(HasSubstr(key)));

  const StudyDatabase database = StudyDatabase::openForReading(file_);
  EXPECT_EQ(database.subjects().size(), 2u);
  for (const char* other : {"S01", "S03"}) {
    const std::vector<TrialRow> trials = database.trials(other);
    ASSERT_EQ(trials.size(), 6u);
    for (const TrialRow& trial : trials) {
      EXPECT_EQ(database.frames(trial.trialId), madeFrames(0, 300, trial.trialNumber));
    }
  }
  ASSERT_EQ(database.audit().size(), 2u);
  EXPECT_EQ(database.audit()[1].action, "withdrawn");
  EXPECT_THAT(database.audit()[1].detailJson,
              testing::MatchesRegex(R"(\{"salt":"[0-9a-f]{32}","subject_key_sha256":"[0-9a-f]{64}"\})"));
  SQLite::Database raw(file_.string());
  EXPECT_EQ(raw.execAndGet("PRAGMA integrity_check").getString(), "ok");
  EXPECT_FALSE(SQLite::Statement(raw, "PRAGMA foreign_key_check").executeStep());
}

TEST_F(WithdrawTest, LeavesNoByteInTheLogOfAProgramThatWasKilled) {
  // A log that is not written back, as after a kill: copies are taken while the database is open.
  const std::filesystem::path copy = folder_ / "copy.db";
  {
    StudyDatabase database = StudyDatabase::openForSessions(file_, protocol_);
    {
      const SessionSchedule schedule = madeSchedule(0, 2, 1);
      TrialStore store(database, protocol_, madeRun(kWho, 2), schedule);
      store.event({1, "", "note", kNote});
      storeTrial(store, 0, madeTrial(schedule.trials[0], 1, 0), 30, 0);
    }
    std::filesystem::copy_file(file_, copy);
    std::filesystem::copy_file(folder_ / "study.db-wal", folder_ / "copy.db-wal");
  }
  for (const char* name : {"study.db", "study.db-wal", "study.db-shm"}) {
    std::filesystem::remove(folder_ / name);
  }
  EXPECT_THAT(fileBytes(folder_ / "copy.db-wal"), HasSubstr(kNote));
  withdrawSubject(copy, kWho, {});
  EXPECT_THAT(tracesLeft(), testing::IsEmpty());
}

TEST_F(WithdrawTest, WipesLaterWhatAReaderKeptItFromWiping) {
  {
    SQLite::Database reader(file_.string());
    SQLite::Statement open(reader, "SELECT * FROM frame");
    open.executeStep();
    reader.setBusyTimeout(0);
    EXPECT_THAT(messageOf<WorkError>([&] { withdrawSubject(file_, kWho, {}); }), HasSubstr("close that program"));
  }
  EXPECT_EQ(StudyDatabase::openForReading(file_).subject(kWho), std::nullopt);
  StudyDatabase::openForSessions(file_, protocol_);
  EXPECT_THAT(tracesLeft(), testing::IsEmpty());
}

TEST_F(WithdrawTest, GoesOnToExportsAndKeyWhereRowsAreDeletedAlready) {
  const std::filesystem::path key = folder_ / "key.csv";
  addIdentity(key, kWho, "Someone Else");
  {
    SQLite::Database reader(file_.string());
    SQLite::Statement open(reader, "SELECT * FROM frame");
    open.executeStep();
    EXPECT_THROW(withdrawSubject(file_, kWho, {}), WorkError);
  }
  const std::filesystem::path data = folder_.write("trials.csv.partial", std::string("1,") + kWho + "\r\n");
  addAuditOfExport(folder_.path().string(), "trials.csv");
  const WithdrawReport report = withdrawSubject(file_, kWho, {.deleteExports = true, .keyFile = key});
  EXPECT_TRUE(report.onlyLeftovers);
  EXPECT_TRUE(report.identityRemoved);
  EXPECT_EQ(report.deletedFiles, std::vector<std::filesystem::path>{data});
  EXPECT_THAT(tracesLeft(), testing::IsEmpty());
  EXPECT_THROW(withdrawSubject(file_, kWho, {}), InputError);
}

TEST_F(WithdrawTest, RefusesWhileAnExportIsUnderWay) {
  const DatabaseLock exporting(file_, DatabaseUse::kExport);
  EXPECT_THAT(messageOf<WorkError>([&] { withdrawSubject(file_, kWho, {}); }), HasSubstr("an export"));
  EXPECT_EQ(StudyDatabase::openForReading(file_).trials(kWho).size(), 6u);
}

TEST_F(WithdrawTest, TakesExportsWithIt) {
  const std::filesystem::path data =
      folder_.write("trials.csv", std::string("row_id,subject_id\r\n1,") + kWho + "\r\n");
  const std::filesystem::path readme = folder_.write("README.md", "about the data");
  addAuditOfExport(folder_.path().string(), "trials.csv");
  addAuditOfExport(folder_.path().string(), "README.md");
  addAuditOfExport((folder_ / ("export_" + std::string(kWho))).string(), "gone.csv");

  EXPECT_EQ(exportsWith(file_, kWho), std::vector<std::filesystem::path>{data});
  EXPECT_THAT(messageOf<InputError>([&] { withdrawSubject(file_, kWho, {}); }),
              AllOf(HasSubstr(data.string()), HasSubstr("--delete-exports"), Not(HasSubstr("README"))));
  EXPECT_EQ(StudyDatabase::openForReading(file_).trials(kWho).size(), 6u);  // nothing has happened

  const WithdrawReport report = withdrawSubject(file_, kWho, {.deleteExports = true});
  EXPECT_EQ(report.deletedFiles, std::vector<std::filesystem::path>{data});
  EXPECT_FALSE(std::filesystem::exists(data));
  EXPECT_TRUE(std::filesystem::exists(readme));
  EXPECT_THAT(tracesLeft(), testing::IsEmpty());
  // The names that held the id are gone; the others are still known.
  const std::vector<AuditEntry> audit = StudyDatabase::openForReading(file_).audit();
  EXPECT_THAT(audit[2].detailJson, HasSubstr("README.md"));
  EXPECT_EQ(audit[3].detailJson, R"({"removed": true})");
}

TEST_F(WithdrawTest, TakesReportsThatNameTheSubjectAsAWhole) {
  const std::filesystem::path report = folder_ / "report";
  const std::filesystem::path other = folder_ / "other";
  std::filesystem::create_directories(report / "tables");
  std::filesystem::create_directories(other);
  folder_.write("report/tables/trials.csv", std::string("subject_id\r\n") + kWho + "\r\n");
  folder_.write("report/report.pdf", "compressed");
  folder_.write("other/report.pdf", "compressed");
  EXPECT_TRUE(recordReport(file_, report, {"report.pdf", "tables/trials.csv"}));
  EXPECT_TRUE(recordReport(file_, report, {"report.pdf", "tables/trials.csv"}));  // made anew, known already
  EXPECT_TRUE(recordReport(file_, other, {"report.pdf"}));
  EXPECT_EQ(StudyDatabase::openForReading(file_).audit().size(), 3u);
  EXPECT_THAT(
      messageOf<InputError>([&] { withdrawSubject(file_, kWho, {}); }),
      AllOf(HasSubstr(report.string() + " (a report)"), HasSubstr("--delete-exports"), Not(HasSubstr("other"))));
  EXPECT_EQ(withdrawSubject(file_, kWho, {.deleteExports = true}).deletedFiles.size(), 2u);
  EXPECT_FALSE(std::filesystem::exists(report)) << "a folder without its report.json could not be written again";
  EXPECT_TRUE(std::filesystem::exists(other / "report.pdf"));
  EXPECT_THAT(tracesLeft(), testing::IsEmpty());
}

TEST_F(WithdrawTest, AReportThatCannotBeNotedIsSaidToBeSo) {
  EXPECT_FALSE(recordReport(folder_ / "none.db", folder_ / "report", {}));
  EXPECT_FALSE(recordReport(folder_.write("text.db", "no database"), folder_ / "report", {}));
  EXPECT_FALSE(recordReport(file_, folder_ / "\xff", {}));
  const DatabaseLock exporting(file_, DatabaseUse::kExport);
  EXPECT_FALSE(recordReport(file_, folder_ / "report", {}));
}

TEST_F(WithdrawTest, TakesTheLineOfTheIdentityKeyOut) {
  const std::filesystem::path key = folder_ / "key.csv";
  addIdentity(key, "S01", "Ada, Countess of \"L.\"");
  addIdentity(key, kWho, "Someone Else");
  EXPECT_TRUE(withdrawSubject(file_, kWho, {.keyFile = key}).identityRemoved);
  EXPECT_THAT(tracesLeft(), testing::IsEmpty());
  EXPECT_EQ(fileBytes(key), "subject_id,name\r\nS01,\"Ada, Countess of \"\"L.\"\"\"\r\n");
}

TEST_F(WithdrawTest, CountsNotesAboutOthersThatHoldTheId) {
  {
    StudyDatabase database = StudyDatabase::openForSessions(file_, protocol_);
    TrialStore store(database, protocol_, madeRun("S01", 2), madeSchedule(0, 2, 1));
    store.event({1, "", "note", std::string("came with ") + kWho});
    store.event({1, "", "note", std::string("came with ") + kWho + "0"});
  }
  EXPECT_EQ(withdrawSubject(file_, kWho, {}).notesThatNameIt, 1);
}

TEST_F(WithdrawTest, GivesTheSlotToTheNextSubject) {
  const int slot = StudyDatabase::openForReading(file_).subject(kWho)->slot;
  withdrawSubject(file_, kWho, {});
  StudyDatabase database = StudyDatabase::openForSessions(file_, protocol_);
  EXPECT_EQ(database.addSubject("S04", SubjectKind::kPerson).slot, slot);
}

TEST_F(WithdrawTest, RefusesWhoIsNotThereAndADatabaseInUse) {
  EXPECT_THAT(messageOf<InputError>([&] { withdrawSubject(file_, "S99", {}); }), HasSubstr("no such subject"));
  const StudyDatabase held = StudyDatabase::openForSessions(file_, protocol_);
  EXPECT_THAT(messageOf<WorkError>([&] { withdrawSubject(file_, kWho, {}); }), HasSubstr("another program"));
}

TEST(WordSearch, FindsWholeWordsAlone) {
  EXPECT_TRUE(holdsWord("S01", "S01"));
  EXPECT_TRUE(holdsWord("1,S01,2", "S01"));
  EXPECT_TRUE(holdsWord("/data/S01_old.db", "S01"));
  EXPECT_TRUE(holdsWord("S011 S01", "S01"));
  EXPECT_FALSE(holdsWord("S011", "S01"));
  EXPECT_FALSE(holdsWord("XS01", "S01"));
  EXPECT_FALSE(holdsWord("", "S01"));
  // Across the pieces in which files are read.
  const TemporaryFolder folder;
  for (const size_t before : {(size_t{1} << 20) - 1, (size_t{1} << 20) - 3, size_t{1} << 20}) {
    EXPECT_TRUE(fileHoldsWord(folder.write("a", std::string(before, '.') + "S01."), "S01")) << before;
    EXPECT_FALSE(fileHoldsWord(folder.write("a", std::string(before, '.') + "S02."), "S01")) << before;
  }
}

TEST(IdentityKey, HoldsOneLineASubject) {
  const TemporaryFolder folder;
  const std::filesystem::path key = folder / "key.csv";
  addIdentity(key, "S01", "Ada");
  EXPECT_THROW(addIdentity(key, "S01", "Grace"), InputError);
  addIdentity(key, "S02", "Grace");
  EXPECT_FALSE(removeIdentity(key, "S03"));
  EXPECT_EQ(fileBytes(key), "subject_id,name\r\nS01,Ada\r\nS02,Grace\r\n");
  EXPECT_EQ(std::filesystem::status(key).permissions() & std::filesystem::perms::mask,
            std::filesystem::perms::owner_read | std::filesystem::perms::owner_write);
  // Saved by a spreadsheet.
  const std::filesystem::path saved =
      folder.write("saved.csv", "\xef\xbb\xbfsubject_id,name\r\nS01,Ada\r\nS02,Grace\r\n");
  EXPECT_TRUE(removeIdentity(saved, "S01"));
  EXPECT_EQ(fileBytes(saved), "subject_id,name\r\nS02,Grace\r\n");
  EXPECT_THAT(messageOf<InputError>([&] {
                removeIdentity(folder.write("apart.csv", "\xef\xbb\xbfsubject_id;name\r\nS01;Ada\r\n"), "S01");
              }),
              HasSubstr("with commas"));
  EXPECT_THROW(addIdentity(folder.write("other.csv", "a,b\r\n"), "S01", "Ada"), InputError);
}

}  // namespace
}  // namespace ocelli::test
