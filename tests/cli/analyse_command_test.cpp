// `ocelli analyse` as a shell sees it.
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <set>
#include <sstream>

#include "oc_core/base/sha256.h"
#include "tests/analysis_dataset/made_study.h"
#include "tests/analysis_plot/well_formed.h"
#include "tests/analysis_report/report_reading.h"
#include "tests/base/temporary_folder.h"
#include "tests/cli/run_program.h"

namespace ocelli::test {
namespace {

namespace fs = std::filesystem;
using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::MatchesRegex;
using testing::Not;

constexpr int kWorkFailed = 1;
constexpr int kInputWrong = 2;

/// What went wrong and where, and what to do: two lines.
const char* const kErrorForm = "ocelli: error: [^\n]+: [^\n]+\n  try: [^\n]+\n";

class AnalyseCommand : public testing::Test {
 protected:
  std::string path(const std::string& name) const { return (folder_ / name).string(); }
  void make(const std::string& name, const MadeStudy& made = {}) const {
    SampleStudy study(path(name), kWholeProtocol);
    fillWholeStudy(study, made);
  }
  /// A small one where only reading matters.
  void makeSmall(const std::string& name) const {
    SampleStudy study(path(name));
    fillSmallStudy(study);
  }
  /// `rest` begins with names of sources in the test's folder.
  ProgramResult analyse(const std::string& rest) const {
    return runShell(fmt::format("cd '{}' && \"$OCELLI\" analyse {}", folder_.path().string(), rest));
  }
  nlohmann::json reportIn(const std::string& folder) const {
    return nlohmann::json::parse(fileBytes(folder_ / (folder + "/report.json")));
  }
  std::string hashOf(const std::string& sources) const {
    const ProgramResult result = analyse(sources + " --json --only survey -o hash");
    return result.exitCode == 0 ? nlohmann::json::parse(result.output)["data_sha256"].get<std::string>() : result.error;
  }
  void change(const std::string& name, const std::string& sql) const {
    SQLite::Database database(path(name), SQLite::OPEN_READWRITE);
    std::vector<std::string> triggers;
    SQLite::Statement list(database, "SELECT name FROM sqlite_schema WHERE type = 'trigger'");
    while (list.executeStep()) {
      triggers.push_back(list.getColumn(0).getString());
    }
    list.reset();
    for (const std::string& trigger : triggers) {
      database.exec("DROP TRIGGER " + trigger);
    }
    database.exec(sql);
  }
  /// Refused as input, in two lines, and nothing is written.
  void expectRefused(const std::string& rest, const std::string& reason) const {
    const ProgramResult result = analyse(rest + " -o refused");
    EXPECT_EQ(result.exitCode, kInputWrong) << rest << ": " << result.error;
    EXPECT_THAT(result.error, AllOf(MatchesRegex(kErrorForm), HasSubstr(reason))) << rest;
    EXPECT_EQ(result.output, "");
    EXPECT_FALSE(fs::exists(folder_ / "refused"));
  }

  TemporaryFolder folder_;
};

/// Lines of a text.
std::vector<std::string> linesOf(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);) {
    lines.push_back(line);
  }
  return lines;
}

// ---- What is written.

TEST_F(AnalyseCommand, WritesAWholeReport) {
  make("study.db");
  const ProgramResult result = analyse("study.db -o report --csv --json");
  ASSERT_EQ(result.exitCode, 0) << result.error;
  EXPECT_THAT(result.error, HasSubstr("456 trials of 6 subjects"));
  const nlohmann::json summary = nlohmann::json::parse(result.output);
  EXPECT_EQ(summary["subjects"], 6);
  EXPECT_EQ(summary["trials"], 456);
  EXPECT_EQ(summary["simulated"], false);

  const nlohmann::json report = reportIn("report");
  EXPECT_THAT(dishonestNumbers(report), IsEmpty());
  EXPECT_THAT(report.dump(), HasSubstr(summary["data_sha256"].get<std::string>()));
  EXPECT_THAT(fileBytes(folder_ / "report/report.pdf"), testing::StartsWith("%PDF-1."));
  EXPECT_EQ(linesOf(fileBytes(folder_ / "report/tables/trials.csv")).size(), 457u);
  EXPECT_GT(linesOf(fileBytes(folder_ / "report/tables/cells.csv")).size(), 50u);
  EXPECT_EQ(linesOf(fileBytes(folder_ / "report/tables/exclusions.csv")).size(), 1u) << "nothing was left out";

  const std::string html = fileBytes(folder_ / "report/index.html");
  EXPECT_THAT(numbersThatAreNone(html), IsEmpty());
  const MarkupReading page = readMarkup(html, {"meta", "br"});
  EXPECT_EQ(page.problem, "");
  // No request: nothing is taken from elsewhere, and links stay in the page or lead to its supplement.
  EXPECT_THAT(html, AllOf(Not(HasSubstr("http:")), Not(HasSubstr("https:")), Not(HasSubstr("@import"))));
  for (const std::string& attribute : page.attributes) {
    EXPECT_FALSE(attribute.starts_with("src=") || attribute.starts_with("srcset=")) << attribute;
    EXPECT_TRUE(!attribute.starts_with("href=") || attribute.starts_with("href=#") ||
                attribute.starts_with("href=supplement.html"))
        << attribute;
  }
  EXPECT_EQ(readMarkup(fileBytes(folder_ / "report/supplement.html"), {"meta", "br"}).problem, "");
  // Each link has its target, each figure its files.
  const std::set<std::string> attributes(page.attributes.begin(), page.attributes.end());
  for (const std::string& attribute : page.attributes) {
    if (attribute.starts_with("href=#")) {
      EXPECT_TRUE(attributes.contains("id=" + attribute.substr(6))) << attribute;
    }
  }
  for (const nlohmann::json& element : report["elements"]) {
    if (element["type"] == "figure") {
      const std::string svg = fileBytes(folder_ / ("report/figures/" + element["id"].get<std::string>() + ".svg"));
      EXPECT_EQ(readMarkup(svg).problem, "") << element["id"];
    }
  }
}

TEST_F(AnalyseCommand, AWithdrawalFindsTheReport) {
  makeSmall("study.db");
  ASSERT_EQ(analyse("study.db --csv --only survey -o report").exitCode, 0);
  const auto withdraw = [&](const std::string& rest) {
    return runShell(fmt::format("cd '{}' && \"$OCELLI\" study withdraw --db study.db --subject S02 {}",
                                folder_.path().string(), rest));
  };
  const ProgramResult refused = withdraw("");
  EXPECT_EQ(refused.exitCode, kInputWrong);
  EXPECT_THAT(refused.error, AllOf(HasSubstr(path("report") + " (a report)"), HasSubstr("--delete-exports")));
  const ProgramResult done = withdraw("--delete-exports");
  EXPECT_EQ(done.exitCode, 0) << done.error;
  EXPECT_THAT(done.error, HasSubstr("grep -rlw S02"));
  EXPECT_FALSE(fs::exists(folder_ / "report"));
  EXPECT_EQ(analyse("study.db --csv --only survey -o report").exitCode, 0);
  EXPECT_THAT(fileBytes(folder_ / "report/tables/trials.csv"), Not(HasSubstr("S02")));
}

TEST_F(AnalyseCommand, CautionsStandOnStandardErrorToo) {
  make("study.db", {});
  change("study.db",
         "UPDATE trial SET response_s = 75, censored = 0 WHERE trial_id = (SELECT min(trial_id) FROM trial)");
  change("study.db", "UPDATE run SET forced = 1 WHERE subject_id = 'S02' AND session_number = 1");
  const ProgramResult result = analyse("study.db --only survey -o report");
  EXPECT_EQ(result.exitCode, 0) << result.error;
  EXPECT_THAT(result.error,
              AllOf(HasSubstr("Trials that contradict themselves are left out, 1 in all: trial 1 of S01"),
                    HasSubstr("forced past a failed check of the screen's timing, 1 in all; they are left out")));
  EXPECT_THAT(fileBytes(folder_ / "report/index.html"), HasSubstr("they are left out: session 1 of S02"));
}

TEST_F(AnalyseCommand, OnlyLeavesOutTheOtherTasks) {
  make("study.db");
  ASSERT_EQ(analyse("study.db -o report --only find,count").exitCode, 0);
  const nlohmann::json report = reportIn("report");
  for (const auto& [id, isThere] : std::vector<std::pair<const char*, bool>>{
           {"find", true}, {"count", true}, {"path", false}, {"survey", false}, {"path-right", false}}) {
    EXPECT_EQ(!elementOf(report, id).is_null(), isThere) << id;
  }
  // What is left out is not decided.
  EXPECT_FALSE(valueIn(report, "family-primary", "path-alike", "p"));
  EXPECT_THAT(dishonestNumbers(report), IsEmpty());
  EXPECT_FALSE(fs::exists(folder_ / "report/tables/trials.csv")) << "--csv was not given";
}

TEST_F(AnalyseCommand, TheSameInputAndSeedGiveTheSameBytes) {
  make("study.db");
  ASSERT_EQ(analyse("study.db -o a --seed 5").exitCode, 0);
  ASSERT_EQ(analyse("study.db -o b --seed 5 --threads 1").exitCode, 0);
  for (const fs::directory_entry& entry : fs::recursive_directory_iterator(folder_ / "a")) {
    const fs::path name = fs::relative(entry.path(), folder_ / "a");
    // These hold the time of creation.
    const bool hasTime =
        name == "index.html" || name == "supplement.html" || name == "report.pdf" || name == "report.json";
    if (entry.is_regular_file() && !hasTime) {
      EXPECT_EQ(fileBytes(entry.path()), fileBytes(folder_ / "b" / name)) << name;
    }
  }
  nlohmann::json a = reportIn("a");
  nlohmann::json b = reportIn("b");
  EXPECT_THAT(a["created"], MatchesRegex("20..-..-..T..:..:..Z"));
  const auto pageWithoutTime = [&](const std::string& folder, const std::string& file, const std::string& created) {
    std::string page = fileBytes(folder_ / folder / file);
    return page.replace(page.find(created), created.size(), "");
  };
  for (const char* file : {"index.html", "supplement.html"}) {
    EXPECT_EQ(pageWithoutTime("a", file, a["created"]), pageWithoutTime("b", file, b["created"]));
  }
  a.erase("created");
  b.erase("created");
  EXPECT_EQ(a, b);
}

TEST_F(AnalyseCommand, ExplainsCellsByTheirRows) {
  make("study.db");
  const ProgramResult result = analyse("study.db --explain section-7.4.2/stationary/gc");
  ASSERT_EQ(result.exitCode, 0) << result.error;
  // The rows give the mean that the cell shows.
  double sum = 0;
  size_t rows = 0;
  for (const std::string& line : linesOf(result.output)) {
    int source = 0, id = 0, session = 0;
    double seconds = 0;
    char subject[32];
    if (std::sscanf(line.c_str(), "%d  %d  %31s  %d  find stationary/location %*d  gc  %lf", &source, &id, subject,
                    &session, &seconds) == 5) {
      EXPECT_EQ(session, 1);
      sum += seconds;
      ++rows;
    }
  }
  ASSERT_GT(rows, 15u);
  const double mean = sum / static_cast<double>(rows);
  EXPECT_THAT(linesOf(result.output)[0], HasSubstr(fmt::format(" {:.1f} s (n = {})", mean, rows)));
  // And so does the query that stands above them.
  const size_t query = result.output.find("SELECT");
  std::string sql = result.output.substr(query, result.output.find('"', query) - query);
  sql.replace(sql.find('*'), 1, "avg(response_s)");
  const SQLite::Database database(path("study.db"), SQLite::OPEN_READWRITE);
  SQLite::Statement asked(database, sql);
  ASSERT_TRUE(asked.executeStep());
  EXPECT_NEAR(asked.getColumn(0).getDouble(), mean, 1e-4) << "six digits are printed";

  EXPECT_THAT(analyse("study.db --explain section-7.4.2/stationary/faster").output,
              AllOf(HasSubstr("from section-7.4.2/stationary/ppc"), HasSubstr("from section-7.4.2/stationary/gc")));
  EXPECT_THAT(analyse("study.db --explain subjects/analysed").output, HasSubstr("S01\nS02\nS03\n"));
  EXPECT_THAT(analyse("study.db --explain section-7.4.5/easier-find").output, HasSubstr("FROM final_answer"));
  const ProgramResult none = analyse("study.db --explain section-7.4.2/stationary/g");
  EXPECT_EQ(none.exitCode, kInputWrong);
  EXPECT_THAT(none.error, AllOf(MatchesRegex(kErrorForm), HasSubstr("section-7.4.2/stationary/gc")));
  EXPECT_EQ(analyse("study.db --explain subjects/analysed >/dev/full").exitCode, kWorkFailed);
}

TEST_F(AnalyseCommand, APlanIsNamedWithItsHash) {
  make("study.db");
  const std::string plan = fileBytes(OCELLI_SOURCE_DIR "/protocols/rosen2010.plan.json");
  folder_.write("plan.json", plan);
  const ProgramResult result = analyse("study.db -o report --json --plan plan.json");
  ASSERT_EQ(result.exitCode, 0) << result.error;
  const std::string digest = sha256(plan);
  EXPECT_EQ(nlohmann::json::parse(result.output)["plan_sha256"], digest);
  EXPECT_THAT(reportIn("report").dump(), HasSubstr(digest));

  expectRefused("study.db --plan none.json", "none.json");
  folder_.write("broken.json", "{\n\"name\": }");
  expectRefused("study.db --plan broken.json", "broken.json:2");
  folder_.write("other.json", R"({"name": "other", "protocol_sha256": ")" + std::string(64, 'a') + R"("})");
  expectRefused("study.db --plan other.json", "aaaaaaaaaaaa");
  folder_.write("unknown.json", R"({"name": "other", "exclude": []})");
  expectRefused("study.db --plan unknown.json", "exclude");
}

// ---- Which data.

TEST_F(AnalyseCommand, PeopleAndSimulatedSubjectsAreKeptApartUnlessToldOtherwise) {
  make("people.db");
  MadeStudy made;
  made.firstNumber = 50;
  made.subjects = 4;
  made.kind = "simulated_observer";
  make("simulated.db", made);
  const auto summary = [&](const std::string& rest) {
    return nlohmann::json::parse(analyse("people.db simulated.db --json --only survey -o report " + rest).output);
  };
  const nlohmann::json people = summary("");
  EXPECT_EQ(people["subjects"], 6);
  EXPECT_EQ(people["simulated"], false);
  // What was left out stands in the log, row by row, and on the page.
  EXPECT_EQ(linesOf(fileBytes(folder_ / "report/tables/exclusions.csv")).size(), 1u + 4 * (76 + 4));
  EXPECT_THAT(reportIn("report").dump(), HasSubstr("4 simulated subjects with 304 trials were left out"));
  const nlohmann::json simulated = summary("--simulated only");
  EXPECT_EQ(simulated["subjects"], 4);
  EXPECT_EQ(simulated["simulated"], true);
  const nlohmann::json together = summary("--simulated together");
  EXPECT_EQ(together["subjects"], 10);
  EXPECT_EQ(together["simulated"], true);
  EXPECT_EQ(reportIn("report")["marking"], "Simulated subjects");
  EXPECT_EQ((std::set{people["data_sha256"], simulated["data_sha256"], together["data_sha256"]}).size(), 3u);
  EXPECT_EQ(analyse("people.db --simulated perhaps -o x").exitCode, kInputWrong);
}

TEST_F(AnalyseCommand, SeveralDatabasesAreAsTheirMerge) {
  make("a.db");
  MadeStudy made;
  made.firstNumber = 7;
  made.subjects = 3;
  make("b.db", made);
  ASSERT_EQ(runProgram(fmt::format("study merge --db {} {} {}", path("all.db"), path("a.db"), path("b.db"))).exitCode,
            0);
  EXPECT_EQ(hashOf("a.db b.db"), hashOf("all.db"));
  EXPECT_EQ(hashOf("b.db a.db"), hashOf("all.db"));
  EXPECT_EQ(hashOf("a.db all.db b.db"), hashOf("all.db")) << "rows that stand twice are taken once";
  const ProgramResult parts = analyse("a.db b.db -o parts");
  ASSERT_EQ(parts.exitCode, 0) << parts.error;
  ASSERT_EQ(analyse("all.db -o whole").exitCode, 0);
  EXPECT_EQ(namedValues(reportIn("parts")), namedValues(reportIn("whole")));
  EXPECT_EQ(valueIn(reportIn("parts"), "find-time", "view", "Estimate"),
            valueIn(reportIn("whole"), "find-time", "view", "Estimate"));
  EXPECT_TRUE(valueIn(reportIn("whole"), "find-time", "view", "Estimate"));
}

TEST_F(AnalyseCommand, OtherProtocolsAreRefusedUnlessAllowed) {
  make("a.db");
  makeSmall("b.db");
  expectRefused("a.db b.db", "--other-protocols");
  // They name subjects alike, too.
  expectRefused("a.db b.db --other-protocols", "S01");
}

TEST_F(AnalyseCommand, AnExportGivesTheNumbersOfItsDatabase) {
  make("study.db");
  ASSERT_EQ(runProgram(fmt::format("study export --db {} -o {}", path("study.db"), path("tables"))).exitCode, 0);
  folder_.write("protocol.json", kWholeProtocol);
  EXPECT_EQ(hashOf("tables"), hashOf("study.db"));
  ASSERT_EQ(analyse("study.db -o a").exitCode, 0);
  ASSERT_EQ(analyse("tables --protocol protocol.json -o b").exitCode, 0);
  const nlohmann::json a = reportIn("a");
  const nlohmann::json b = reportIn("b");
  for (const char* model : {"find-time", "find-hazard", "count-right", "path-right"}) {
    EXPECT_TRUE(valueIn(a, model, "view", "Estimate")) << model;
    EXPECT_EQ(valueIn(a, model, "view", "Estimate"), valueIn(b, model, "view", "Estimate")) << model;
  }
  for (const std::string& value : namedValues(a)) {
    // Tables do not hold consent.
    if (!value.starts_with("subjects/consented")) {
      EXPECT_THAT(namedValues(b), testing::Contains(value));
    }
  }
  EXPECT_THAT(dishonestNumbers(b), IsEmpty());
  // Without the protocol both are perhaps not of one study.
  expectRefused("study.db tables", "--protocol");
  EXPECT_EQ(hashOf("study.db tables --protocol protocol.json"), hashOf("study.db"));
  expectRefused("tables --protocol none.json", "none.json");
}

TEST_F(AnalyseCommand, OneChangedValueChangesTheHash) {
  makeSmall("study.db");
  fs::copy_file(folder_ / "study.db", folder_ / "changed.db");
  EXPECT_EQ(hashOf("changed.db"), hashOf("study.db"));
  change("changed.db", "UPDATE trial SET response_s = response_s + 1.0 / 240 WHERE trial_id = 4");
  EXPECT_THAT(hashOf("changed.db"), AllOf(MatchesRegex("[0-9a-f]{64}"), Not(hashOf("study.db"))));
}

// ---- Where to.

TEST_F(AnalyseCommand, AFolderOfOtherFilesIsRefused) {
  makeSmall("study.db");
  fs::create_directory(folder_ / "mine");
  folder_.write("mine/report.json", R"({"precious": true})");
  for (const char* folder : {"mine", "mine/", "study.db", "."}) {
    const ProgramResult result = analyse(std::string("study.db -o ") + folder);
    EXPECT_EQ(result.exitCode, kInputWrong) << folder << result.error;
    EXPECT_THAT(result.error, MatchesRegex(kErrorForm));
  }
  EXPECT_EQ(fileBytes(folder_ / "mine/report.json"), R"({"precious": true})");
  // An earlier report is replaced, with what the new one does not have.
  ASSERT_EQ(analyse("study.db -o report --csv").exitCode, 0);
  ASSERT_TRUE(fs::exists(folder_ / "report/tables/trials.csv"));
  ASSERT_EQ(analyse("study.db -o report").exitCode, 0);
  EXPECT_FALSE(fs::exists(folder_ / "report/tables/trials.csv"));
  EXPECT_EQ(analyse("study.db").exitCode, kInputWrong) << "no -o";
}

TEST_F(AnalyseCommand, AFullDiskLeavesTheEarlierReport) {
  makeSmall("study.db");
  ASSERT_EQ(analyse("study.db -o report").exitCode, 0);
  const std::string before = fileBytes(folder_ / "report/report.json");
  // A limit to the size of files, in blocks of 512 bytes, stands for the disk.
  const ProgramResult result =
      runShell(fmt::format("cd '{}'\ntrap '' XFSZ\nulimit -f 100\n\"$OCELLI\" analyse study.db -o report 2>&1 | cat",
                           folder_.path().string()));
  EXPECT_THAT(result.output, AllOf(MatchesRegex(kErrorForm), HasSubstr("cannot be written"), HasSubstr("free some")));
  EXPECT_EQ(fileBytes(folder_ / "report/report.json"), before);
  std::vector<std::string> left;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder_.path())) {
    left.push_back(entry.path().filename().string());
  }
  EXPECT_THAT(left, testing::UnorderedElementsAre("report", "study.db"));
  EXPECT_EQ(analyse("study.db -o /proc/none").exitCode, kWorkFailed);
  EXPECT_EQ(analyse("study.db -o no/such/report").exitCode, kWorkFailed);
}

TEST_F(AnalyseCommand, AFolderMayHaveAnyName) {
  makeSmall("study.db");
  const ProgramResult result = analyse("study.db --json -o \"$(printf 'a \\377 b')\"");
  EXPECT_EQ(result.exitCode, 0) << result.error;
  EXPECT_EQ(nlohmann::json::parse(result.output)["subjects"], 2);
}

// ---- Bad input.

TEST_F(AnalyseCommand, WhatIsNoStudyIsRefused) {
  makeSmall("study.db");
  const std::string bytes = fileBytes(folder_ / "study.db");
  expectRefused("none.db", "there is no such file");
  folder_.write("empty.db", "");
  expectRefused("empty.db", "empty");
  folder_.write("text.db", std::string(5000, 'x'));
  expectRefused("text.db", "this is no database");
  for (const size_t size : {size_t{50}, size_t{100}, size_t{5000}, bytes.size() / 2}) {
    folder_.write("half.db", std::string_view(bytes).substr(0, size));
    expectRefused("half.db", "damaged");
  }
  expectRefused("/dev/null", "this is no file");
  fs::create_directory(folder_ / "tables");
  expectRefused("tables", "subjects.csv");
  folder_.write("tables/subjects.csv", "subject_id\nS01\n");
  expectRefused("tables", "subjects.csv:1");
  for (const auto& [sql, reason] : std::vector<std::pair<std::string, std::string>>{
           {"PRAGMA user_version = 99", "a newer version of ocelli"},
           {"PRAGMA user_version = 0", "version 0"},
           {"PRAGMA application_id = 0", "no database of a study"},
           {"DELETE FROM study", "holds no study"},
           {"UPDATE study SET protocol_text = ''", "someone changed it"},
           {"DROP VIEW final_trial", "no such table: final_trial"},
           {"UPDATE trial SET response_s = 9e999 WHERE trial_id = 4", "trial_id 4: response_s is inf"},
           {"UPDATE trial SET response_s = -1 WHERE trial_id = 4", "trial_id 4: response_s is -1"},
           {"UPDATE trial SET response_s = 1e300 WHERE trial_id = 4", "trial_id 4: response_s is 1e+300"},
           {"UPDATE trial SET case_index = 4294967296 WHERE trial_id = 4", "trial_id 4: case_index is 4294967296"},
           {"UPDATE trial SET block_index = -1 WHERE trial_id = 4", "trial_id 4: block_index is -1"},
           {"UPDATE trial SET frames = 9e15 WHERE trial_id = 4", "trial_id 4: frames is 9000000000000000"},
           {"UPDATE trial SET exposure_s = 9e999 WHERE trial_id = 3", "trial_id 3: exposure_s is inf"},
           {"UPDATE trial SET measures_json = '[' WHERE trial_id = 4", "trial_id 4, measures_json"},
           {"UPDATE trial SET measures_json = '{\"a\": 1e300}' WHERE trial_id = 4", "trial_id 4: a is 1e+300"},
           {"UPDATE trial SET case_label = printf('%.*c', 1000000, 'x') WHERE trial_id = 4", "has 1000000 bytes"},
           {"PRAGMA ignore_check_constraints = 1; UPDATE trial SET view = '' WHERE trial_id = 4", "table trial"},
           {"UPDATE trial SET view = 'both' WHERE trial_id = 4", "must be ppc or gc"},
           {"PRAGMA ignore_check_constraints = 1; UPDATE trial SET censored = 7 WHERE trial_id = 4", "table trial"}}) {
    folder_.write("changed.db", bytes);
    change("changed.db", sql);
    expectRefused("changed.db", reason);
  }
}

TEST_F(AnalyseCommand, ProtocolsThatAreNoneAreRefused) {
  const std::pair<std::string, const char*> protocols[] = {
      {"hello", "not valid JSON"}, {"[]", "object"}, {std::string(100'000, '['), "JSON"}, {"{}", "name"}};
  for (const auto& [protocol, reason] : protocols) {
    fs::remove(folder_ / "study.db");
    {
      SampleStudy study(path("study.db"), protocol);
      fillSmallStudy(study);
    }
    expectRefused("study.db", reason);
  }
}

TEST_F(AnalyseCommand, FlippedBitsAreNoCrash) {
  makeSmall("study.db");
  const std::string bytes = fileBytes(folder_ / "study.db");
  // Spread over the file by the golden ratio: headers, pages of trees, rows.
  uint32_t place = 0;
  std::string script = fmt::format("cd '{}'\n", folder_.path().string());
  for (int i = 0; i < 24; ++i) {
    std::string flipped = bytes;
    for (int k = 0; k <= i % 3; ++k) {
      place += 2654435769U;
      const size_t at = i % 4 == 0 ? place % 4096 : place % flipped.size();
      flipped[at] = static_cast<char>(flipped[at] ^ (1 << (place >> 13) % 8));
    }
    const std::string name = fmt::format("{}.db", i);
    folder_.write(name, flipped);
    const ProgramResult result = analyse(name + " --explain section-7.4.2/stationary/gc");
    EXPECT_TRUE(result.exitCode == 0 || result.exitCode == kInputWrong) << i << ": " << result.exitCode << result.error;
    if (result.exitCode != 0) {
      EXPECT_THAT(result.error, MatchesRegex(kErrorForm)) << i;
    }
    EXPECT_THAT(numbersThatAreNone(result.output), IsEmpty());
  }
}

TEST_F(AnalyseCommand, ADatabaseThatIsBeingWrittenIsReadAsItStands) {
  SampleStudy study(path("study.db"));
  fillSmallStudy(study);
  const std::string before = hashOf("study.db");
  EXPECT_THAT(before, MatchesRegex("[0-9a-f]{64}"));
  SQLite::Transaction unfinished(study.database());
  SampleTrial trial;
  trial.plan = 9;
  study.addTrial(trial);
  EXPECT_EQ(hashOf("study.db"), before);
  unfinished.commit();
  EXPECT_THAT(hashOf("study.db"), AllOf(MatchesRegex("[0-9a-f]{64}"), Not(before)));
  EXPECT_TRUE(fs::exists(path("study.db-wal"))) << "the writer's log stays";
}

TEST_F(AnalyseCommand, HostileTextsStayText) {
  const std::string hostile =
      "</script><script>alert(1)</script><img src=x onerror=alert(1)>\"'&\r\n\t\x01\x7f\xff\xfe";
  {
    SampleStudy study(path("study.db"));
    for (const char* start : {"=1+1", "@SUM", "-x", "+y", "\x1b[31m"}) {
      const std::string subject = start + hostile;
      study.addSubject(subject);
      study.addSession(subject, 1, *start == '@' ? "unwell" : "completed");
      study.addAnswer(subject, "survey", "=easier" + hostile, "4");
      study.addAnswer(subject, "survey", "easier_find", std::string(1'000'000, '<'));
      for (int i = 0; i < 6; ++i) {
        SampleTrial trial;
        trial.subject = subject;
        trial.plan = i;
        trial.view = i % 2 == 0 ? "ppc" : "gc";
        trial.task = i < 4 ? "find" : "count";
        trial.block = start + hostile;
        trial.caseIndex = i / 2;
        trial.caseLabel = start + hostile;
        trial.answer = i == 0 ? std::string(1'000'000, '>') : "=cmd()" + hostile;
        trial.expected = "=cmd()" + hostile;
        trial.response = 5 + i;
        study.addTrial(trial);
      }
    }
  }
  const ProgramResult result = analyse("study.db -o report --csv");
  ASSERT_EQ(result.exitCode, 0) << result.error;
  const std::string html = fileBytes(folder_ / "report/index.html");
  EXPECT_LT(html.size(), 2'000'000u) << "a long answer is not on the page";
  const MarkupReading page = readMarkup(html, {"meta", "br"});
  EXPECT_EQ(page.problem, "");
  EXPECT_EQ(std::count(page.tags.begin(), page.tags.end(), "script"), 1) << "its own";
  EXPECT_EQ(std::count(page.tags.begin(), page.tags.end(), "img"), 0);
  for (const std::string& attribute : page.attributes) {
    EXPECT_FALSE(attribute.starts_with("on")) << attribute;
  }
  EXPECT_THAT(page.text, HasSubstr("alert(1)"));
  EXPECT_NE(html.find("&lt;... [1000000 bytes]"), std::string::npos);
  const nlohmann::json report = reportIn("report");
  EXPECT_THAT(dishonestNumbers(report), IsEmpty());
  for (const fs::directory_entry& entry : fs::directory_iterator(folder_ / "report/figures")) {
    if (entry.path().extension() == ".svg") {
      const MarkupReading figure = readMarkup(fileBytes(entry.path()));
      EXPECT_EQ(figure.problem, "") << entry.path();
      EXPECT_EQ(std::count(figure.tags.begin(), figure.tags.end(), "script"), 0) << entry.path();
    }
  }
  // No field of a table is a formula; numbers may be negative.
  for (const char* table : {"trials", "cells", "exclusions"}) {
    const std::string text = fileBytes(folder_ / fmt::format("report/tables/{}.csv", table));
    for (const char* formula : {",=", ",@", ",+", ",-x", "\n=", "\n@", ",\"=", ",\"@", ",\"-", ",\"+", "\n\"="}) {
      EXPECT_EQ(text.find(formula), std::string::npos) << table << ": " << text.substr(text.find(formula), 40);
    }
  }
  // Nor do terminals see commands.
  const ProgramResult rows = analyse("study.db --explain section-7.4.2/stationary/ppc");
  EXPECT_EQ(rows.exitCode, 0);
  EXPECT_EQ(rows.output.find('\x1b'), std::string::npos);
  EXPECT_EQ(rows.output.find('\x01'), std::string::npos);
  change("study.db", "UPDATE trial SET measures_json = '[' WHERE trial_id = 25");
  EXPECT_EQ(analyse("study.db -o x").error.find('\x1b'), std::string::npos);
}

TEST_F(AnalyseCommand, WrongCommandLinesAreRefused) {
  makeSmall("study.db");
  for (const char* rest : {"", "study.db --only reading -o x", "study.db -o x --seed -1", "study.db -o x --nonsense",
                           "study.db --explain ''"}) {
    const ProgramResult result = analyse(rest);
    EXPECT_EQ(result.exitCode, kInputWrong) << rest;
    EXPECT_THAT(result.error, HasSubstr("  try: ")) << rest;
  }
  EXPECT_FALSE(fs::exists(folder_ / "x"));
}

}  // namespace
}  // namespace ocelli::test
