#include "analysis/dataset/mapped_trials.h"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>

#include "analysis/dataset/exclusions.h"
#include "analysis/dataset/merge.h"
#include "tests/analysis_dataset/sample_study.h"

namespace ocelli::test {
namespace {

using ::testing::AllOf;
using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::Not;

constexpr const char* kMap = R"({
  "tool": "Tool", "subject": "who", "condition": "view", "case": "scene", "trial": "n", "time": {"column": "t"},
  "answer": "key", "correct": {"column": "ok", "right": ["1"], "wrong": ["0"]},
  "timeout": {"column": "key", "is": ["none"], "limit_seconds": 20}})";

constexpr const char* kHead = "who,n,view,scene,t,key,ok\n";
/// Two subjects, two conditions, two cases; the last trial ran out of time.
constexpr const char* kRows =
    "A,1,flat,door,1.5,x,1\nA,2,bent,door,2.25,y,0\nA,3,bent,arch,3,x,1\nB,1,bent,door,1,x,1\nB,2,flat,door,4,x,1\n"
    "B,3,flat,arch,,none,0\n";

struct MappedTrials : ::testing::Test {
  SampleFolder folder;

  std::string write(const std::string& name, const std::string& text) const {
    std::ofstream(folder.file(name), std::ios::binary) << text;
    return folder.file(name);
  }
  Dataset read(const std::string& text, const std::string& map = kMap) const {
    return readMappedTables({write("data.csv", text)}, columnMapFromJsonText(map, "map.json"));
  }
  std::string errorOf(const std::string& text, const std::string& map = kMap) const {
    return analysisErrorOf([&] { read(text, map); });
  }
  /// Of the good rows with another text in place of one.
  std::string errorWith(const std::string& from, const std::string& to, const std::string& map = kMap) const {
    std::string text = std::string(kHead) + kRows;
    EXPECT_NE(text.find(from), std::string::npos) << from;
    return errorOf(text.replace(text.find(from), from.size(), to), map);
  }
};

std::string with(const std::string& more) {
  return std::string(kMap).replace(1, 0, more + ", ");
}

/// The same with the line of the file.
auto saysAt(int line, const std::string& text) {
  return AllOf(HasSubstr(fmt::format("data.csv:{}", line)), HasSubstr(text));
}

TEST_F(MappedTrials, areTrialsAsADatabaseHasThem) {
  const Dataset data = read(std::string(kHead) + kRows);
  ASSERT_EQ(data.trials.size(), 6u);
  ASSERT_EQ(data.conditions.size(), 2u);
  EXPECT_EQ(data.conditions.nameOf(TrialView::kReference), "bent") << "by the alphabet";
  const Trial& second = data.trials[1];
  EXPECT_EQ(second.trialId, 3) << "the line of the file";
  EXPECT_EQ(second.subject, "A");
  EXPECT_EQ(second.session, 1);
  EXPECT_EQ(second.planIndex, 2);
  EXPECT_EQ(second.task, "main");
  EXPECT_EQ(second.block, "main");
  EXPECT_EQ(second.caseLabel, "door");
  EXPECT_EQ(second.caseIndex, 1) << "arch, door";
  EXPECT_EQ(second.view, TrialView::kReference);
  EXPECT_EQ(second.responseSeconds, 2.25);
  EXPECT_EQ(second.correct, false);
  EXPECT_EQ(second.censored, false);
  EXPECT_EQ(second.answer, "y");
  const Trial& last = data.trials.back();
  EXPECT_EQ(last.censored, true);
  EXPECT_EQ(last.responseSeconds, 20) << "the limit";
  ASSERT_EQ(data.subjects.size(), 2u);
  ASSERT_EQ(data.sessions.size(), 2u);
  EXPECT_EQ(data.sessions[0].completedTrials, 3);
  EXPECT_FALSE(data.sessions[0].ending.has_value());
  EXPECT_FALSE(data.consentIsKnown);
  EXPECT_EQ(merge({data}).trials.size(), 6u);
}

TEST_F(MappedTrials, whoTheSubjectsAreIsWhatTheMapSays) {
  const std::string text = std::string(kHead) + kRows;
  const Dataset unknown = read(text);
  EXPECT_FALSE(unknown.subjectsAreKnown());
  EXPECT_FALSE(unknown.isSimulated());
  EXPECT_THAT(unknown.tableFacts, Contains(HasSubstr("does not say whether the subjects are people or simulated")));
  EXPECT_THAT(analysisErrorOf([&] {
                merge({unknown}, {SimulatedRows::kOnly, false});
              }),
              HasSubstr("not known whether these subjects are people or simulated"));
  const Dataset people = read(text, with(R"("subjects": "people")"));
  EXPECT_TRUE(people.subjectsAreKnown());
  EXPECT_FALSE(people.isSimulated());
  EXPECT_THAT(people.tableFacts, Contains("That the subjects are people is what the map says."));
  const Dataset simulated = read(text, with(R"("subjects": "simulated")"));
  EXPECT_TRUE(simulated.subjectsAreKnown());
  EXPECT_TRUE(simulated.isSimulated());
  EXPECT_THAT(merge({simulated}).notes, Contains("All subjects are simulated: no result is one of people."));
}

TEST_F(MappedTrials, rowsOfSimulatedSubjectsDoNotMixWithPeople) {
  const std::string map =
      with(R"("subjects": "people", "simulated": {"column": "key", "is": ["bot"], "optional": true})");
  const std::string rows = std::string(kHead) + kRows;
  const std::string bots = "C,1,flat,door,1,bot,1\nC,2,bent,door,1,bot,1\n";
  const Dataset data = read(rows + bots, map);
  EXPECT_EQ(data.subjects.size(), 3u);
  EXPECT_TRUE(data.subjects[2].simulated);
  const Dataset merged = merge({data});
  EXPECT_EQ(merged.subjects.size(), 2u);
  EXPECT_FALSE(merged.isSimulated());
  EXPECT_THAT(errorOf(rows + "A,4,flat,door,1,bot,1\n", map),
              saysAt(8, "column \"key\" says that subject \"A\" is simulated"));
}

TEST_F(MappedTrials, notesSayWhatTablesCannotTell) {
  const Dataset data = read(std::string(kHead) + kRows);
  EXPECT_THAT(data.tableFacts, Contains(AllOf(HasSubstr("the protocol and its counterbalancing"), HasSubstr("seeds"),
                                              HasSubstr("left out before the tables were written"))));
  EXPECT_THAT(data.tableFacts,
              Contains(HasSubstr("\"bent\" is the reference because it is the first by the alphabet")));
  EXPECT_THAT(data.tableFacts, Not(Contains(HasSubstr("names no time-outs"))));
  const Dataset noLimit = read("who,view,scene,t\nA,a,x,1\nA,b,x,2\nB,a,x,3\nB,b,x,4\n",
                               R"({"subject": "who", "condition": "view", "case": "scene", "time": {"column": "t"}})");
  EXPECT_THAT(noLimit.tableFacts, Contains(HasSubstr("names no time-outs")));
  EXPECT_THAT(noLimit.tableFacts, Contains(HasSubstr("All trials are of one case")));
  EXPECT_THAT(noLimit.tableFacts, Contains(HasSubstr("the limits of times")));
  EXPECT_THAT(noLimit.tableFacts, Contains(HasSubstr("recorded by another tool")));
  EXPECT_FALSE(noLimit.timeoutsAreKnown);
  EXPECT_FALSE(noLimit.trials[0].censored.has_value());
  EXPECT_FALSE(noLimit.trials[0].correct.has_value());
}

TEST_F(MappedTrials, shapesOfTablesDoNotMatter) {
  const std::string hash = dataHash(read(std::string(kHead) + kRows));
  std::string windows = std::string(kHead) + kRows;
  for (size_t at = windows.find('\n'); at != std::string::npos; at = windows.find('\n', at + 2)) {
    windows.insert(at, "\r");
  }
  EXPECT_EQ(dataHash(read(windows)), hash);
  EXPECT_EQ(dataHash(read("\xef\xbb\xbf" + windows)), hash);
  EXPECT_EQ(dataHash(read(std::string(kHead) + kRows + "\n\n")), hash) << "blank lines";
  std::string comma = std::string(kHead) + kRows;
  for (char& c : comma) {
    c = c == ',' ? ';' : c == '.' ? ',' : c;
  }
  EXPECT_EQ(dataHash(read(comma, with(R"("separator": "semicolon", "decimal": "comma")"))), hash);
  std::string tabs = std::string(kHead) + kRows;
  std::replace(tabs.begin(), tabs.end(), ',', '\t');
  EXPECT_EQ(dataHash(read(tabs, with(R"("separator": "tab")"))), hash);
  // What the map does not name may be anything, also without a name or with one that stands twice.
  std::string wide;
  std::string line;
  for (std::istringstream lines(std::string(kHead) + kRows); std::getline(lines, line);) {
    wide += "\xff," + line + (wide.empty() ? ",more,more," : ",\"" + std::string(100'000, 'z') + "\",\xfe,") + "\n";
  }
  wide.replace(0, 1, "first");
  EXPECT_EQ(dataHash(read(wide)), hash);
}

TEST_F(MappedTrials, wrongTablesAreNamedWithColumnAndLine) {
  EXPECT_THAT(errorOf(""), saysAt(1, "this table is empty"));
  EXPECT_THAT(errorOf("\n"), saysAt(1, "this table is empty"));
  EXPECT_THAT(errorOf(kHead), saysAt(1, "no row below the names"));
  EXPECT_THAT(errorWith("scene,", "stage,"),
              saysAt(1, "column \"scene\" is missing, which the map map.json has for \"case\""));
  EXPECT_THAT(errorWith("scene,", "stage,"), HasSubstr("who, n, view, stage, t, key, ok"));
  EXPECT_THAT(errorWith("scene,", "view,"), saysAt(1, "column \"view\" stands twice"));
  EXPECT_THAT(errorOf("who;n;view;scene;t;key;ok\nA;1;flat;door;1;x;1\n"),
              saysAt(1, "a map with \"separator\": \"semicolon\""));
  EXPECT_THAT(errorOf("\xff\xfew\0h\0o\0"), saysAt(1, "this table is in UTF-16"));
  EXPECT_THAT(errorWith("who", "wh\xe9"), saysAt(1, "the name of column 1 holds the byte 0xe9"));
  EXPECT_THAT(errorWith("2.25,y,0", "2.25,y"), saysAt(3, "6 fields, and the table 7 columns: column \"ok\" has none"));
  EXPECT_THAT(errorWith("2.25,y,0", "2.25,y,0,more"), saysAt(3, "8 fields, and the table 7 columns: \"more\" has no"));
  EXPECT_THAT(errorWith("A,3", "\"A,3"), saysAt(4, "a quote of this row does not end"));
  EXPECT_THAT(
      analysisErrorOf([&] { readMappedTables({folder.file("nowhere.csv")}, columnMapFromJsonText(kMap, "map.json")); }),
      HasSubstr("nowhere.csv"));
  EXPECT_THAT(analysisErrorOf([&] { readMappedTables({folder.file(".")}, columnMapFromJsonText(kMap, "map.json")); }),
              HasSubstr("this is a folder"));
}

TEST_F(MappedTrials, wrongRowsAreNamedWithColumnAndLine) {
  EXPECT_THAT(errorWith("2.25", "2,25,"), HasSubstr("data.csv:3"));
  EXPECT_THAT(errorWith("2.25", "\"2,25\""), saysAt(3, "column \"t\" is \"2,25\", but must be a number"));
  EXPECT_THAT(errorWith("2.25", "\"2,25\""), HasSubstr("\"decimal\": \"comma\""));
  EXPECT_THAT(errorWith("2.25", "2.25s"), saysAt(3, "column \"t\" is \"2.25s\", but must be a number"));
  EXPECT_THAT(errorWith("2.25", "inf"), saysAt(3, "column \"t\" is \"inf\""));
  EXPECT_THAT(errorWith("2.25", "1e300"), saysAt(3, "column \"t\" is 1e+300, but must be a number from 0 to"));
  EXPECT_THAT(errorWith("2.25", "-2.25"), saysAt(3, "column \"t\" is -2.25, but no time is negative"));
  EXPECT_THAT(errorWith("2.25", ""), saysAt(3, "column \"t\" is \"\", but a trial needs a time"));
  EXPECT_THAT(errorWith("2.25", "NA"), saysAt(3, "column \"t\" is \"NA\", but a trial needs a time"));
  EXPECT_THAT(errorWith("A,2,bent", ",2,bent"), saysAt(3, "column \"who\" is empty"));
  EXPECT_THAT(errorWith("A,2,bent", "A,2,"), saysAt(3, "column \"view\" is empty"));
  EXPECT_THAT(errorWith("bent,door,2.25", "bent, ,2.25"), saysAt(3, "column \"scene\" is empty"));
  EXPECT_THAT(errorWith("A,2,bent", "A,two,bent"), saysAt(3, "column \"n\" is \"two\", but must be a whole number"));
  EXPECT_THAT(errorWith("A,2,bent", "A,-2,bent"), saysAt(3, "column \"n\" is \"-2\""));
  EXPECT_THAT(errorWith("2.25,y,0", "2.25,y,2"), saysAt(3, "column \"ok\" is \"2\", which is neither right nor wrong"));
  EXPECT_THAT(errorWith("2.25,y,0", "2.25,y,"), saysAt(3, "column \"ok\" is \"\", which is neither"));
  EXPECT_THAT(errorWith("bent,door,2.25", "bent,\xe9,2.25"),
              saysAt(3, "column \"scene\" holds the byte 0xe9, which is no UTF-8"));
  EXPECT_THAT(errorWith("bent,door,2.25", "bent,a\x01,2.25"),
              saysAt(3, "column \"scene\" holds the control character"));
  EXPECT_THAT(errorWith("bent,door,2.25", "bent," + std::string(2000, 'x') + ",2.25"),
              saysAt(3, "column \"scene\" has 2000 bytes, but a name has at most 1000"));
  EXPECT_THAT(errorWith("2.25,y", "2.25," + std::string(1'000'000, 'x')),
              saysAt(3, "column \"key\" has 1000000 bytes, but at most"));
  EXPECT_THAT(errorWith("2.25,y,0", ",none,0", with(R"("subjects": "people")")), "") << "the limit stands in";
  std::string noLimit = kMap;
  noLimit.erase(noLimit.find(", \"limit_seconds\": 20"), 21);
  EXPECT_THAT(errorWith("2.25,y,0", ",none,0", noLimit),
              saysAt(3, "column \"t\" is empty as the trial's time ran out, and the map does not say"));
}

TEST_F(MappedTrials, rowsThatContradictEachOtherAreNamed) {
  EXPECT_THAT(errorWith("A,2,bent", "A,1,bent"),
              saysAt(3, "column \"n\" is 1 a second time for subject \"A\" in session 1: as in"));
  EXPECT_THAT(errorWith("A,2,bent", "A,2,bend"),
              saysAt(3, "column \"view\" is \"bend\", which no subject but \"A\" has"));
  EXPECT_THAT(errorWith("A,2,bent", "A,2,bend", with(R"("conditions": [{"value": "flat"}, {"value": "bent"}])")),
              saysAt(3, "column \"view\" is \"bend\", but \"conditions\" of the map has: flat, bent"));
  EXPECT_THAT(errorWith("A,2,bent", "A,2,be nt"), HasSubstr("which no subject but \"A\" has"));
  const std::string uncounted = R"({"subject": "who", "condition": "view", "case": "scene", "time": {"column": "t"}})";
  const std::string head = "who,view,scene,t\n";
  EXPECT_THAT(errorOf(head + "A,a,x,1\nA,b,x,2\nB,a,x,3\nB,b,x,4\nA,a,x,1\n", uncounted),
              saysAt(6, "this row is the same in all columns as"));
  EXPECT_THAT(errorOf(head + "A,a b,x,1\nA,a_b,x,2\nB,a b,x,3\nB,a_b,x,4\n", uncounted),
              saysAt(3, "column \"view\" is \"a_b\", which would have the same name as \"a b\": a_b"));
  std::string many = head;
  for (int i = 0; i < 17; ++i) {
    many += fmt::format("A,v{0},x,1\nB,v{0},x,1\n", i);
  }
  EXPECT_THAT(errorOf(many, uncounted), saysAt(34, "column \"view\" is \"v16\", the 17th condition"));
  const std::string tasks =
      R"({"subject": "who", "condition": "view", "case": "scene", "time": {"column": "t"}, "block": "b", "task": "k"})";
  EXPECT_THAT(errorOf("who,view,scene,t,b,k\nA,a,x,1,one,find\nB,a,x,2,one,count\n", tasks),
              saysAt(3, "column \"b\" is \"one\" with task \"count\", but in"));
}

TEST_F(MappedTrials, tablesAreReadTogether) {
  const std::string rows = kRows;
  const size_t half = rows.find("B,1");
  const std::string first = write("a.csv", kHead + rows.substr(0, half));
  const std::string second = write("b.csv", kHead + rows.substr(half));
  const ColumnMap map = columnMapFromJsonText(kMap, "map.json");
  const Dataset data = readMappedTables({first, second}, map);
  EXPECT_EQ(dataHash(data), dataHash(read(std::string(kHead) + kRows)));
  EXPECT_EQ(data.trials.back().source, 1);
  EXPECT_EQ(data.trials.back().trialId, 4);
  EXPECT_THAT(analysisErrorOf([&] {
                readMappedTables({first, second, first}, map);
              }),
              HasSubstr("this table is given twice"));
  EXPECT_THAT(analysisErrorOf([&] {
                readMappedTables({first, second, write("c.csv", kHead + rows.substr(0, half))}, map);
              }),
              AllOf(HasSubstr("c.csv:2: column \"n\" is 1 a second time for subject \"A\""), HasSubstr("a.csv:2")));
}

TEST_F(MappedTrials, rowsPracticeSessionsAndDifferencesAreTold) {
  const std::string map = R"({
    "subject": {"file_name": true}, "session": "visit", "session_values": ["pre", "post"], "task": "kind",
    "rows": [{"column": "kind", "is_not": ["break"]}], "practice": {"column": "try", "is": ["yes"]},
    "condition": "view", "case": "scene", "time": {"column": "end", "minus": "begin", "unit": "ms"},
    "answer": "key", "expected": "target", "timeout": {"limit_seconds": 3}, "measures": {"level": "contrast"}})";
  const Dataset data = read(
      "visit,kind,try,view,scene,begin,end,key,target,contrast\n"
      "pre,search,yes,,,,,,,\n"
      "pre,search,no,a,x,1000,2500,l,l,0.5\n"
      "pre,break,,,,,,,,\n"
      "post,search,no,b,x,5000,8000,l,r,\n",
      map);
  ASSERT_EQ(data.trials.size(), 2u);
  EXPECT_EQ(data.trials[0].subject, "data");
  EXPECT_EQ(data.trials[0].task, "search");
  EXPECT_EQ(data.trials[0].responseSeconds, 1.5);
  EXPECT_EQ(data.trials[0].correct, true);
  EXPECT_EQ(data.trials[0].censored, false);
  EXPECT_EQ(data.trials[0].measures, (std::map<std::string, double>{{"level", 0.5}}));
  EXPECT_EQ(data.trials[1].session, 2);
  EXPECT_EQ(data.trials[1].censored, true) << "as long as the limit";
  EXPECT_EQ(data.trials[1].correct, false);
  EXPECT_TRUE(data.trials[1].measures.empty());
  ASSERT_EQ(data.otherAttempts.size(), 1u);
  EXPECT_EQ(data.otherAttempts[0].why, OtherAttempt::Why::kPractice);
  EXPECT_THAT(data.tableFacts, Contains("1 of 4 rows are no trials by the map, and are in no number."));
  EXPECT_THAT(errorOf("visit,kind,try,view,scene,begin,end,key,target,contrast\nlate,search,no,a,x,1,2,l,l,\n", map),
              saysAt(2, "column \"visit\" is \"late\", which \"session_values\""));
  EXPECT_THAT(errorOf("visit,kind,try,view,scene,begin,end,key,target,contrast\npre,search,no,a,x,9,2,l,l,\n", map),
              saysAt(2, "column \"end\" less column \"begin\" is -7"));
  EXPECT_THAT(errorOf("visit,kind,try,view,scene,begin,end,key,target,contrast\npre,search,no,a,x,,2,l,l,\n", map),
              saysAt(2, "column \"begin\" is empty"));
  EXPECT_THAT(errorOf("visit,kind,try,view,scene,begin,end,key,target,contrast\npre,break,,,,,,,,\n", map),
              saysAt(2, "none of the 1 rows is a trial by the map, which looks at column \"kind\""));
}

}  // namespace
}  // namespace ocelli::test
