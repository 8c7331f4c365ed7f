// What a database of a study refuses, before a subject sits down.
#include "study/store/study_database.h"

#include <SQLiteCpp/SQLiteCpp.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include "oc_core/base/error.h"
#include "study/store/database_lock.h"
#include "study/store/trial_store.h"
#include "tests/base/temporary_folder.h"
#include "tests/study_store/made_study.h"
#include "tests/study_store/study_checks.h"

namespace ocelli::test {
namespace {

using testing::AllOf;
using testing::HasSubstr;

class StudyDatabaseTest : public testing::Test {
 protected:
  StudyDatabase open() const { return StudyDatabase::openForSessions(file_, protocol_); }
  template <class Kind>
  std::string refusal() const {
    return messageOf<Kind>([&] { open(); });
  }
  void execute(const std::string& statement) const {
    SQLite::Database(file_.string(), SQLite::OPEN_READWRITE | SQLite::OPEN_CREATE).exec(statement);
  }

  TemporaryFolder folder_;
  const std::filesystem::path file_ = folder_ / "study.db";
  const Protocol protocol_ = madeProtocol();
};

TEST_F(StudyDatabaseTest, IsMadeOnceAndOpenedAgain) {
  open().addSubject("S01", SubjectKind::kPerson);
  const StudyDatabase database = open();
  EXPECT_EQ(database.subjects().size(), 1u);
  ASSERT_EQ(database.audit().size(), 1u);
  EXPECT_EQ(database.audit()[0].action, "created");
}

TEST_F(StudyDatabaseTest, RefusesAnotherProtocol) {
  open();
  const std::string message =
      messageOf<InputError>([&] { StudyDatabase::openForSessions(file_, madeProtocol("changed")); });
  EXPECT_THAT(message, AllOf(HasSubstr("this database is of the protocol \"made-up\""),
                             HasSubstr(protocol_.sha256.substr(0, 12))));
}

TEST_F(StudyDatabaseTest, RefusesANewerVersion) {
  open();
  execute("PRAGMA user_version = 99");
  EXPECT_THAT(refusal<InputError>(), HasSubstr("this database has version 99"));
  EXPECT_THAT(messageOf<InputError>([&] { StudyDatabase::openForReading(file_); }), HasSubstr("version 99"));
}

TEST_F(StudyDatabaseTest, RefusesWhatIsNoDatabase) {
  folder_.write("study.db",
                "Dear diary, this is not a database, though it is long enough to be looked at. "
                "It goes on and on so that it has more bytes than the head of a database.");
  const std::string before = fileBytes(file_);
  EXPECT_THAT(refusal<InputError>(), HasSubstr("no database of a study"));
  EXPECT_EQ(fileBytes(file_), before);
}

TEST_F(StudyDatabaseTest, RefusesADatabaseOfAnotherProgram) {
  execute("CREATE TABLE recipe (name TEXT)");
  const std::string before = fileBytes(file_);
  EXPECT_THAT(refusal<InputError>(), HasSubstr("no database of a study"));
  EXPECT_TRUE(fileBytes(file_) == before);  // the mode of its log too
}

TEST_F(StudyDatabaseTest, RefusesFoldersAndFilesThatAreNotThere) {
  EXPECT_THAT(messageOf<InputError>([&] { StudyDatabase::openForReading(folder_.path()); }), HasSubstr("folder"));
  EXPECT_THAT(messageOf<InputError>([&] { StudyDatabase::openForReading(file_); }), HasSubstr("there is no such file"));
  EXPECT_FALSE(std::filesystem::exists(file_));
  EXPECT_THAT(messageOf<WorkError>([&] { StudyDatabase::openForSessions(folder_ / "none/study.db", protocol_); }),
              HasSubstr("folder"));
}

TEST_F(StudyDatabaseTest, AcceptsAnEmptyFile) {
  folder_.write("study.db", "");
  EXPECT_EQ(open().study().protocolName, "made-up");
}

TEST_F(StudyDatabaseTest, RefusesASecondProgramAndNamesTheFirst) {
  {
    const StudyDatabase first = open();
    EXPECT_THAT(refusal<WorkError>(),
                AllOf(HasSubstr("another program uses this database"), HasSubstr(std::to_string(getpid()))));
    EXPECT_THAT(DatabaseLock::holderOf(file_).value_or(""), HasSubstr(std::to_string(getpid())));
    // To look is always possible.
    EXPECT_EQ(StudyDatabase::openForReading(file_).study().protocolName, "made-up");
  }
  EXPECT_EQ(DatabaseLock::holderOf(file_), std::nullopt);
  open();
  EXPECT_FALSE(std::filesystem::exists(DatabaseLock::fileOf(file_)));
}

TEST_F(StudyDatabaseTest, TakesALinkForWhatItLeadsTo) {
  const std::filesystem::path link = folder_ / "link.db";
  const std::filesystem::path far = folder_ / "folder" / "far.db";
  std::filesystem::create_symlink("study.db", link);  // leads to nothing yet
  std::filesystem::create_directory(folder_ / "folder");
  std::filesystem::create_symlink("../link.db", far);
  {
    StudyDatabase first = StudyDatabase::openForSessions(far, protocol_);
    for (const std::filesystem::path& other : {file_, link, far}) {
      EXPECT_THAT(messageOf<WorkError>([&] { StudyDatabase::openForSessions(other, protocol_); }),
                  HasSubstr("another program uses this database"))
          << other;
    }
    // Its log is read through any name.
    first.addSubject("S01", SubjectKind::kPerson);
    EXPECT_EQ(StudyDatabase::openForReading(far).subjects().size(), 1u);
  }
  EXPECT_EQ(StudyDatabase::openForReading(file_).subjects().size(), 1u);
}

TEST_F(StudyDatabaseTest, IgnoresTheLockOfAProcessThatWasKilled) {
  const pid_t child = fork();
  ASSERT_GE(child, 0);
  if (child == 0) {
    const StudyDatabase held = open();
    _exit(0);  // no destructor runs
  }
  int status = 0;
  waitpid(child, &status, 0);
  EXPECT_TRUE(std::filesystem::exists(DatabaseLock::fileOf(file_)));
  EXPECT_EQ(open().study().protocolName, "made-up");
}

TEST_F(StudyDatabaseTest, RefusesADiskThatIsNearlyFull) {
  EXPECT_THAT(messageOf<WorkError>(
                  [&] { StudyDatabase::openForSessions(file_, protocol_, {std::numeric_limits<uint64_t>::max()}); }),
              HasSubstr("the disk has"));
  EXPECT_FALSE(std::filesystem::exists(file_));
}

// Rights do not bind root, so root becomes nobody for a moment.
class AsNobody {
 public:
  AsNobody() : wasRoot_(geteuid() == 0) { works_ = !wasRoot_ || seteuid(65534) == 0; }
  ~AsNobody() {
    if (wasRoot_ && seteuid(0) != 0) {
      std::abort();
    }
  }
  bool works() const { return works_; }

 private:
  bool wasRoot_;
  bool works_ = false;
};

TEST_F(StudyDatabaseTest, RefusesAReadOnlyFileAndFolder) {
  namespace fs = std::filesystem;
  open();
  const auto everyone = fs::perms::owner_all | fs::perms::group_all | fs::perms::others_all;
  const auto readOnly = fs::perms::owner_read | fs::perms::group_read | fs::perms::others_read;
  fs::permissions(folder_.path(), everyone);
  fs::permissions(file_, readOnly);
  {
    const AsNobody nobody;
    if (!nobody.works()) {
      GTEST_SKIP() << "root cannot become nobody here";
    }
    EXPECT_THAT(refusal<WorkError>(), HasSubstr("read-only"));
  }
  fs::permissions(folder_.path(), readOnly | fs::perms::owner_exec | fs::perms::group_exec | fs::perms::others_exec);
  {
    const AsNobody nobody;
    EXPECT_THAT(refusal<WorkError>(), HasSubstr("may be written to"));
    EXPECT_THAT(messageOf<WorkError>([&] { StudyDatabase::openForSessions(folder_ / "new.db", protocol_); }),
                HasSubstr("may be written to"));
  }
  fs::permissions(folder_.path(), everyone);
}

TEST_F(StudyDatabaseTest, IsReadWithoutATrace) {
  open().addSubject("S01", SubjectKind::kPerson);
  const std::string before = fileBytes(file_);
  EXPECT_EQ(StudyDatabase::openForReading(file_).subjects().size(), 1u);
  EXPECT_EQ(fileBytes(file_), before);
  EXPECT_FALSE(std::filesystem::exists(folder_ / "study.db-wal"));

  // The log of a program that was killed stays as it is, and is read.
  const pid_t child = fork();
  ASSERT_GE(child, 0);
  if (child == 0) {
    StudyDatabase database = open();
    database.addSubject("S02", SubjectKind::kPerson);
    _exit(0);  // no destructor runs
  }
  int status = 0;
  waitpid(child, &status, 0);
  const std::string log = fileBytes(folder_ / "study.db-wal");
  ASSERT_FALSE(log.empty());
  EXPECT_EQ(StudyDatabase::openForReading(file_).subjects().size(), 2u);
  EXPECT_EQ(fileBytes(file_), before);
  EXPECT_EQ(fileBytes(folder_ / "study.db-wal"), log);
  EXPECT_EQ(open().subjects().size(), 2u);
}

TEST_F(StudyDatabaseTest, IsReadInAFolderThatCannotBeWritten) {
  namespace fs = std::filesystem;
  open().addSubject("S01", SubjectKind::kPerson);
  fs::permissions(folder_.path(), static_cast<fs::perms>(0555));
  {
    const AsNobody nobody;
    if (!nobody.works()) {
      GTEST_SKIP() << "root cannot become nobody here";
    }
    EXPECT_EQ(StudyDatabase::openForReading(file_).subjects().size(), 1u);
  }
  fs::permissions(folder_.path(), fs::perms::owner_all);
}

TEST_F(StudyDatabaseTest, RefusesIdsThatAreTakenOrNone) {
  StudyDatabase database = open();
  database.addSubject("S-01_b", SubjectKind::kPerson);
  EXPECT_THAT(messageOf<InputError>([&] { database.addSubject("S-01_b", SubjectKind::kPerson); }),
              AllOf(HasSubstr("has that subject already"), HasSubstr("resume")));
  for (const char* id : {"", "a b", "a@b.c", "-x", "_x", "../x", "\xc3\xa4", "a\n"}) {
    EXPECT_THAT(messageOf<InputError>([&] { database.addSubject(id, SubjectKind::kPerson); }), HasSubstr("no id"))
        << id;
  }
  EXPECT_THAT(messageOf<InputError>([&] { database.addSubject(std::string(65, 'x'), SubjectKind::kPerson); }),
              HasSubstr("no id"));
  EXPECT_NO_THROW(database.addSubject(std::string(64, 'x'), SubjectKind::kPerson));
}

TEST_F(StudyDatabaseTest, GivesNewSubjectsTheFirstSlotThatIsFree) {
  StudyDatabase database = open();
  EXPECT_EQ(database.addSubject("a", SubjectKind::kPerson).slot, 0);
  EXPECT_EQ(database.addSubject("b", SubjectKind::kPerson).slot, 1);
  EXPECT_EQ(database.addSubject("r", SubjectKind::kObserver).slot, 0);
  EXPECT_EQ(database.addSubject("q", SubjectKind::kGenerator).slot, 1);
  EXPECT_EQ(database.addSubject("c", SubjectKind::kPerson).slot, 2);
  EXPECT_EQ(database.addSubject("far", SubjectKind::kPerson, 10).slot, 10);
  EXPECT_EQ(database.addSubject("d", SubjectKind::kPerson).slot, 3);
  // Whoever left is replaced (withdraw_test.cpp has the whole of it).
  execute(
      "UPDATE withdrawal SET subject_id = 'b'; DELETE FROM subject WHERE subject_id = 'b'; "
      "UPDATE withdrawal SET subject_id = NULL");
  EXPECT_EQ(database.addSubject("e", SubjectKind::kPerson).slot, 1);
}

TEST_F(StudyDatabaseTest, KeepsRecordedRowsAsTheyAre) {
  {
    StudyDatabase database = open();
    database.addSubject("S01", SubjectKind::kPerson);
    const SessionSchedule schedule = madeSchedule(0, 1, 1);
    TrialStore store(database, protocol_, madeRun("S01", 1), schedule);
    store.consent({"Consent", "You may stop.", "abc", true, "2026-03-01T12:00:00.500Z"});
    store.answer({"demographics", "age_band", "18-24", "2026-03-01T12:00:00.700Z"});
    store.event({5, "2026-03-01T12:00:00.800Z", "note", "x"});
    storeTrial(store, 0, madeTrial(schedule.trials[0], 1, 4), 3, 4);
    store.sessionEnds(SessionEnding::kCompleted, "2026-03-01T13:00:00.000Z");
  }
  SQLite::Database raw(file_.string(), SQLite::OPEN_READWRITE);
  for (const char* table : {"study", "subject", "session", "run", "consent", "answer", "trial", "frame", "input",
                            "gaze", "event", "audit"}) {
    const std::string name = table;
    ASSERT_GT(raw.execAndGet("SELECT count(*) FROM " + name).getInt(), 0) << name;
    EXPECT_THROW(raw.exec("DELETE FROM " + name), SQLite::Exception) << name;
    SQLite::Statement column(raw, "SELECT name FROM pragma_table_info(?)");
    column.bind(1, name);
    while (column.executeStep()) {
      const std::string update =
          "UPDATE " + name + " SET " + column.getColumn(0).getString() + " = " + column.getColumn(0).getString();
      EXPECT_THROW(raw.exec(update), SQLite::Exception) << update;
    }
  }
}

TEST_F(StudyDatabaseTest, LetsNoRowContradictTheMarkOfItsSubject) {
  {
    StudyDatabase database = open();
    database.addSubject("S01", SubjectKind::kPerson);
    const SessionSchedule schedule = madeSchedule(0, 1, 1);
    TrialStore store(database, protocol_, madeRun("S01", 1), schedule);
    storeTrial(store, 0, madeTrial(schedule.trials[0], 1, 4), 3, 4);
  }
  SQLite::Database raw(file_.string(), SQLite::OPEN_READWRITE);
  raw.exec("PRAGMA foreign_keys = ON");
  const auto insertFrame = [&](const std::string& simulated) {
    raw.exec("INSERT INTO frame SELECT trial_id, frame + 100, tick, shown_ns, x_m, z_m, heading_rad, pixel_hash, " +
             simulated + " FROM frame WHERE frame = 0");
  };
  EXPECT_THROW(insertFrame("1"), SQLite::Exception);
  EXPECT_NO_THROW(insertFrame("0"));
}

}  // namespace
}  // namespace ocelli::test
