// Tables say what the database holds.
#include "study/export/study_export.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <fstream>
#include <optional>

#include "oc_core/base/csv.h"
#include "oc_core/base/error.h"
#include "study/session/trial_rows.h"
#include "study/store/database_lock.h"
#include "study/store/study_database.h"
#include "study/store/trial_store.h"
#include "study/store/withdraw.h"
#include "tests/base/temporary_folder.h"
#include "tests/study_export/exported_study.h"
#include "tests/study_store/study_checks.h"

namespace ocelli::test {
namespace {

using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::Not;

/// A table by the names of its columns.
class Table {
 public:
  explicit Table(const std::filesystem::path& file) : lines_(csvRows(fileBytes(file), file.string())) {}

  size_t rows() const { return lines_.size() - 1; }
  const std::vector<std::string>& names() const { return lines_.front(); }
  std::string at(size_t row, const std::string& column) const {
    const auto found = std::find(names().begin(), names().end(), column);
    EXPECT_NE(found, names().end()) << column;
    return found == names().end() ? "" : lines_.at(row + 1).at(static_cast<size_t>(found - names().begin()));
  }
  std::vector<std::string> column(const std::string& name) const {
    std::vector<std::string> values;
    for (size_t row = 0; row < rows(); ++row) {
      values.push_back(at(row, name));
    }
    return values;
  }

 private:
  std::vector<std::vector<std::string>> lines_;
};

class StudyExportTest : public testing::Test {
 protected:
  StudyExportTest() { storeStudy(file_); }
  ExportReport run(ExportOptions options = {}) const { return exportStudy(file_, tables_, options); }

  TemporaryFolder folder_;
  const std::filesystem::path file_ = folder_ / "study.db";
  const std::filesystem::path tables_ = folder_ / "tables";
};

TEST_F(StudyExportTest, WritesEveryTrialWithAllItsValues) {
  const ExportReport report = run();
  EXPECT_EQ(report.subjects, 3);
  EXPECT_EQ(report.simulatedSubjects, 1);
  EXPECT_THAT(report.files,
              ElementsAre("columns.csv", "trials.csv", "subjects.csv", "runs.csv", "answers.csv", "events.csv"));
  const Table trials(tables_ / "trials.csv");
  const StudyDatabase database = StudyDatabase::openForReading(file_);
  const std::vector<TrialRow> stored = database.trials();
  ASSERT_EQ(trials.rows(), stored.size());
  ASSERT_EQ(trials.rows(), 3u + 3 * 4);
  for (size_t row = 0; row < stored.size(); ++row) {
    const TrialRecord record = recordOf(stored[row]);
    EXPECT_EQ(trials.at(row, "trial_id"), std::to_string(stored[row].trialId));
    EXPECT_EQ(trials.at(row, "subject_id"), stored[row].subject);
    EXPECT_EQ(trials.at(row, "session_number"), "1");
    EXPECT_EQ(trials.at(row, "view"), defaultConditions().nameOf(record.plan.view));
    EXPECT_EQ(trials.at(row, "simulated"), stored[row].subject == "R1" ? "1" : "0");
    if (record.ending == TrialEnding::kCompleted && stored[row].ending) {
      EXPECT_EQ(trials.at(row, "answer"), record.outcome.answer);
      // Numbers come back to the last bit.
      EXPECT_EQ(std::stod(trials.at(row, "response_s")), static_cast<double>(record.outcome.responseTicks) / 240);
      EXPECT_EQ(std::stod(trials.at(row, "path_length_m")), record.outcome.measures.at("path_length_m"));
      EXPECT_EQ(trials.at(row, "clicks"), "2");
    } else {
      EXPECT_EQ(trials.at(row, "answer"), "");
      EXPECT_EQ(trials.at(row, "response_s"), "");
    }
  }
  EXPECT_EQ(trials.at(3, "trial_seed"), "0xf000000000000000");
}

TEST_F(StudyExportTest, MarksTheRowsThatCount) {
  run();
  const Table trials(tables_ / "trials.csv");
  // S01: practice, redone, never ended, then four that count.
  const std::vector<std::string> counts = trials.column("counts");
  EXPECT_EQ(std::vector<std::string>(counts.begin(), counts.begin() + 7),
            (std::vector<std::string>{"0", "0", "0", "1", "1", "1", "1"}));
  EXPECT_EQ(trials.at(0, "practice"), "1");
  EXPECT_EQ(trials.at(0, "plan_index"), "");
  EXPECT_EQ(trials.at(1, "ending"), "redone");
  EXPECT_EQ(trials.at(2, "ending"), "");
  const Table answers(tables_ / "answers.csv");
  EXPECT_THAT(answers.column("counts"), ElementsAre("0", "1", "0", "1", "0", "1"));
}

TEST_F(StudyExportTest, QuotesAndDisarmsTexts) {
  run();
  const Table answers(tables_ / "answers.csv");
  EXPECT_EQ(answers.at(0, "answer"), std::string("'") + kFormula);
  EXPECT_EQ(answers.at(1, "answer"), "18-24, \"about\"");
  EXPECT_THAT(fileBytes(tables_ / "answers.csv"), HasSubstr(",\"18-24, \"\"about\"\"\",1,"));
}

TEST_F(StudyExportTest, LeavesOutWhatExperimentersTyped) {
  run();
  EXPECT_THAT(fileBytes(tables_ / "events.csv"), Not(HasSubstr(kTypedNote)));
  const Table events(tables_ / "events.csv");
  EXPECT_EQ(events.at(0, "what"), "note");
  EXPECT_EQ(events.at(1, "detail"), "begins");
  run({.notes = true, .overwrite = true});
  EXPECT_THAT(fileBytes(tables_ / "events.csv"), HasSubstr(kTypedNote));
}

TEST_F(StudyExportTest, WritesFramesAndInputsWhereAskedFor) {
  run({.frames = true, .inputs = true, .gaze = true});
  const Table frames(tables_ / "frames.csv");
  const StudyDatabase database = StudyDatabase::openForReading(file_);
  const std::vector<FrameRecord> stored = database.frames(1);
  ASSERT_EQ(stored.size(), 3u);
  for (size_t i = 0; i < stored.size(); ++i) {
    EXPECT_EQ(frames.at(i, "trial_id"), "1");
    EXPECT_EQ(std::stod(frames.at(i, "x_m")), stored[i].pose.x);
    EXPECT_EQ(std::stod(frames.at(i, "heading_rad")), stored[i].pose.headingRadians);
    EXPECT_EQ(std::stoll(frames.at(i, "shown_ns")), stored[i].shownNanoseconds);
  }
  EXPECT_EQ(frames.at(0, "pixel_hash"), "0x8000000000000000");
  EXPECT_EQ(frames.at(1, "pixel_hash"), "");
  const Table inputs(tables_ / "inputs.csv");
  EXPECT_EQ(inputs.at(0, "what"), "W");
  EXPECT_EQ(inputs.rows(), 14 * madeInputs().size());
  const Table gaze(tables_ / "gaze.csv");
  EXPECT_EQ(gaze.rows(), 14 * madeGaze().size());
  EXPECT_EQ(std::stod(gaze.at(0, "y_px")), madeGaze()[0].y);
  EXPECT_EQ(gaze.at(1, "pupil"), "");
  EXPECT_EQ(gaze.at(2, "valid"), "0");
  EXPECT_EQ(gaze.at(2, "x_px"), "");
}

TEST_F(StudyExportTest, ExplainsEveryColumnOfEveryTable) {
  const ExportReport report = run({.frames = true, .inputs = true, .gaze = true});
  const Table columns(tables_ / "columns.csv");
  std::vector<std::string> explained;
  for (size_t row = 0; row < columns.rows(); ++row) {
    explained.push_back(columns.at(row, "file") + ":" + columns.at(row, "column"));
    EXPECT_FALSE(columns.at(row, "meaning").empty()) << explained.back();
  }
  for (const std::string& file : report.files) {
    if (file != "columns.csv") {
      const Table table(tables_ / file);
      for (const std::string& name : table.names()) {
        EXPECT_THAT(explained, Contains(file + ":" + name));
      }
    }
  }
}

TEST_F(StudyExportTest, RefusesAFolderThatHoldsFilesUnlessTold) {
  std::filesystem::create_directories(tables_);
  EXPECT_NO_THROW(run());
  std::ofstream(tables_ / "mine.txt") << "mine";
  EXPECT_THAT(messageOf<InputError>([&] { run(); }), HasSubstr("holds files already"));
  // An earlier export goes, with tables that are no longer asked for; what is not ours stays.
  run({.frames = true, .overwrite = true});
  run({.overwrite = true});
  EXPECT_FALSE(std::filesystem::exists(tables_ / "frames.csv"));
  EXPECT_TRUE(std::filesystem::exists(tables_ / "mine.txt"));
  EXPECT_THAT(messageOf<InputError>([&] { exportStudy(file_, file_, {}); }), HasSubstr("not a folder"));
  EXPECT_THROW(exportStudy(file_, "/proc/none/tables", {}), WorkError);
}

TEST_F(StudyExportTest, IsFoundByAWithdrawal) {
  run({.frames = true});
  exportStudy(file_, folder_ / "set", {.form = ExportForm::kPsychDs});
  EXPECT_THAT(messageOf<InputError>([&] { withdrawSubject(file_, "S02", {}); }), HasSubstr("trials.csv"));
  const WithdrawReport report = withdrawSubject(file_, "S02", {.deleteExports = true});
  // Subjects, runs, answers, events, trials and frames; the first four again, and trials by task.
  EXPECT_EQ(report.deletedFiles.size(), 12u);
  for (const auto& entry : std::filesystem::recursive_directory_iterator(folder_.path())) {
    if (entry.is_regular_file()) {
      EXPECT_THAT(fileBytes(entry.path()), Not(HasSubstr("S02"))) << entry.path();
    }
  }
}

TEST_F(StudyExportTest, ExportsAStudyWithoutSubjects) {
  const std::filesystem::path empty = folder_ / "empty.db";
  StudyDatabase::openForSessions(empty, madeProtocol());
  const ExportReport report = exportStudy(empty, tables_, {});
  EXPECT_EQ(report.rows, 0);
  EXPECT_EQ(Table(tables_ / "trials.csv").rows(), 0u);
}

TEST_F(StudyExportTest, IsTheSameWheneverItIsMade) {
  run({.frames = true});
  exportStudy(file_, folder_ / "again", {.frames = true});
  for (const auto& entry : std::filesystem::directory_iterator(tables_)) {
    EXPECT_EQ(fileBytes(entry.path()), fileBytes(folder_ / "again" / entry.path().filename().string()));
  }
}

TEST_F(StudyExportTest, RefusesAFolderWhoseNameIsNoText) {
  const std::filesystem::path folder = folder_ / "lat\xe9in";
  EXPECT_THAT(messageOf<InputError>([&] { exportStudy(file_, folder, {}); }), HasSubstr("no UTF-8"));
  EXPECT_FALSE(std::filesystem::exists(folder));
}

TEST_F(StudyExportTest, IsMadeDuringASessionAndNotDuringAWithdrawal) {
  const DatabaseLock session(file_);
  run();
  const DatabaseLock withdrawal(file_, DatabaseUse::kExport);
  EXPECT_THAT(messageOf<WorkError>([&] { run({.overwrite = true}); }), HasSubstr("a withdrawal"));
}

TEST_F(StudyExportTest, ReadsADatabaseThatCannotBeWritten) {
  namespace fs = std::filesystem;
  const TemporaryFolder other;
  fs::permissions(other.path(), fs::perms::all);
  fs::permissions(file_, static_cast<fs::perms>(0444));
  fs::permissions(folder_.path(), static_cast<fs::perms>(0555));
  const std::string before = fileBytes(file_);
  // Rights do not bind root, so root becomes nobody for a moment.
  const bool wasRoot = geteuid() == 0;
  if (wasRoot && seteuid(65534) != 0) {
    GTEST_SKIP() << "root cannot become nobody here";
  }
  std::optional<ExportReport> report;
  EXPECT_NO_THROW(report = exportStudy(file_, other / "tables", {}));
  ASSERT_TRUE(!wasRoot || seteuid(0) == 0);
  fs::permissions(folder_.path(), fs::perms::owner_all);
  ASSERT_TRUE(report);
  EXPECT_FALSE(report->recorded);
  EXPECT_EQ(report->subjects, 3);
  EXPECT_TRUE(fileBytes(file_) == before);
}

TEST_F(StudyExportTest, GivesEachMeasureAColumnOfItsOwn) {
  const std::filesystem::path file = folder_ / "measures.db";
  {
    StudyDatabase database = StudyDatabase::openForSessions(file, madeProtocol());
    database.addSubject("S01", SubjectKind::kPerson);
    const SessionSchedule schedule = madeSchedule(0, 1, 1);
    TrialStore store(database, madeProtocol(), madeRun("S01", 1), schedule);
    TrialRecord record = madeTrial(schedule.trials[0], 1, 1);
    record.outcome.measures = {{"a b", 1}, {"a-b", 2}, {"A_b", 3}, {"a_b_2", 4}};
    storeTrial(store, 0, record, 3, 1);
  }
  exportStudy(file, tables_, {});
  const Table trials(tables_ / "trials.csv");
  // By the measures' names: "A_b", "a b", "a-b", "a_b_2".
  EXPECT_EQ(trials.at(0, "A_b"), "3");
  EXPECT_EQ(trials.at(0, "a_b_2"), "1");
  EXPECT_EQ(trials.at(0, "a_b_3"), "2");
  EXPECT_EQ(trials.at(0, "a_b_2_2"), "4");
}

}  // namespace
}  // namespace ocelli::test
