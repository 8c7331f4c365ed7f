// Exports keep the rules of Psych-DS, and each way to break one is found.
#include "study/export/psych_ds.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>
#include <functional>
#include <map>
#include <nlohmann/json.hpp>

#include "study/export/study_export.h"
#include "tests/base/temporary_folder.h"
#include "tests/study_export/exported_study.h"
#include "tests/study_export/psych_ds_rules.h"

namespace ocelli::test {
namespace {

using testing::Contains;
using testing::HasSubstr;
using testing::IsEmpty;

constexpr const char* kFind = "data/study-madeup_task-find_data.csv";

class PsychDsTest : public testing::Test {
 protected:
  PsychDsTest() {
    storeStudy(folder_ / "study.db");
    exportStudy(folder_ / "study.db", set_,
                {.form = ExportForm::kPsychDs, .frames = true, .inputs = true, .gaze = true, .notes = true});
  }

  TemporaryFolder folder_;
  const std::filesystem::path set_ = folder_ / "set";
};

TEST_F(PsychDsTest, KeepsTheRules) {
  EXPECT_THAT(psychDsViolations(set_), IsEmpty());
  for (const char* file :
       {kFind, "data/study-madeup_task-count_data.csv", "data/study-madeup_description-subjects_data.csv",
        "data/study-madeup_description-runs_data.csv", "data/study-madeup_description-answers_data.csv",
        "data/study-madeup_description-events_data.csv", "data/study-madeup_description-frames_data.csv",
        "data/study-madeup_description-inputs_data.csv", "README.md", "CHANGES.md"}) {
    EXPECT_TRUE(std::filesystem::is_regular_file(set_ / file)) << file;
  }
  EXPECT_EQ(fileBytes(set_ / "materials/protocol.json"), madeProtocol().text);
}

TEST_F(PsychDsTest, TellsTheMeaningAndUnitOfEveryColumn) {
  const nlohmann::json json = nlohmann::json::parse(fileBytes(set_ / "dataset_description.json"));
  std::map<std::string, nlohmann::json> variables;
  for (const nlohmann::json& variable : json["variableMeasured"]) {
    EXPECT_TRUE(variables.emplace(variable["name"], variable).second) << variable["name"];
    EXPECT_FALSE(variable["description"].get<std::string>().empty()) << variable["name"];
  }
  EXPECT_EQ(variables["response_s"]["unitText"], "s");
  EXPECT_EQ(variables["x_m"]["unitText"], "m");
  EXPECT_EQ(variables["path_length_m"]["unitText"], "m");  // a task's own measure
  EXPECT_FALSE(variables["view"].contains("unitText"));
}

TEST_F(PsychDsTest, SaysLoudlyThatSubjectsAreSimulated) {
  for (const char* file : {"dataset_description.json", "README.md", "CHANGES.md"}) {
    EXPECT_THAT(fileBytes(set_ / file), HasSubstr("3 subjects, 1 of them SIMULATED")) << file;
  }
  PsychDsText text;
  text.subjects = 2;
  EXPECT_THAT(psychDsReadme(text), HasSubstr("all of them people"));
  text.simulatedSubjects = 2;
  EXPECT_THAT(psychDsReadme(text), HasSubstr("no person took part"));
}

TEST(PsychDsFileName, HasLettersAndDigitsAlone) {
  EXPECT_EQ(psychDsFileName("rosen2010-balanced", "task", "find"), "study-rosen2010balanced_task-find_data.csv");
  EXPECT_EQ(psychDsFileName("a b/../c", "task", "\xc3\xa4_x"), "study-abc_task-x_data.csv");
  EXPECT_EQ(psychDsFileName("-", "task", "find"), "study-unnamed_task-find_data.csv");
}

// ---- The rules themselves

std::string replaced(std::string text, const std::string& what, const std::string& with) {
  const size_t at = text.find(what);
  EXPECT_NE(at, std::string::npos) << "the mutation changes nothing: " << what;
  return at == std::string::npos ? text : text.replace(at, what.size(), with);
}

struct Mutation {
  const char* name;
  /// Of a data set that keeps the rules.
  std::function<void(const std::filesystem::path& set)> apply;
  const char* found;
};

void rewrite(const std::filesystem::path& file, const std::string& what, const std::string& with) {
  const std::string text = replaced(fileBytes(file), what, with);
  std::ofstream(file, std::ios::binary) << text;
}

std::function<void(const std::filesystem::path&)> inDescription(const std::function<void(nlohmann::json&)>& change) {
  return [change](const std::filesystem::path& set) {
    nlohmann::json json = nlohmann::json::parse(fileBytes(set / "dataset_description.json"));
    change(json);
    std::ofstream(set / "dataset_description.json") << json.dump();
  };
}

std::function<void(const std::filesystem::path&)> inFind(const std::string& what, const std::string& with) {
  return [what, with](const std::filesystem::path& set) { rewrite(set / kFind, what, with); };
}

std::function<void(const std::filesystem::path&)> renamed(const std::string& name) {
  return [name](const std::filesystem::path& set) { std::filesystem::rename(set / kFind, set / "data" / name); };
}

const std::vector<Mutation>& mutations() {
  using Path = std::filesystem::path;
  using Json = nlohmann::json;
  static const std::vector<Mutation> all{
      {"no description file", [](const Path& set) { std::filesystem::remove(set / "dataset_description.json"); },
       "dataset_description.json: missing"},
      {"a description that is no JSON", [](const Path& set) { rewrite(set / "dataset_description.json", "{", "["); },
       "no JSON object"},
      {"no name", inDescription([](Json& json) { json.erase("name"); }), "no name"},
      {"an empty description", inDescription([](Json& json) { json["description"] = ""; }), "no description"},
      {"another type", inDescription([](Json& json) { json["@type"] = "DataCatalog"; }), "@type is not Dataset"},
      {"another context", inDescription([](Json& json) { json["@context"] = "https://example.org"; }),
       "@context is not schema.org"},
      {"no context", inDescription([](Json& json) { json.erase("@context"); }), "@context is not schema.org"},
      {"no variables", inDescription([](Json& json) { json.erase("variableMeasured"); }), "no variableMeasured"},
      {"one variable less", inDescription([](Json& json) { json["variableMeasured"].erase(3); }),
       "is not in variableMeasured"},
      {"a variable without a name", inDescription([](Json& json) { json["variableMeasured"][0].erase("name"); }),
       "neither a name nor a PropertyValue"},
      {"no data", [](const Path& set) { std::filesystem::remove_all(set / "data"); }, "data/: no data file"},
      {"a name without _data", renamed("study-madeup_task-find.csv"), "not a name of a data file"},
      {"a name without a key", renamed("find_data.csv"), "not a name of a data file"},
      {"a key with a capital", renamed("Study-madeup_data.csv"), "not a name of a data file"},
      {"a value with a space", renamed("study-made up_data.csv"), "not a name of a data file"},
      {"a value with a hyphen", renamed("study-made-up_data.csv"), "not a name of a data file"},
      {"a column that nobody knows", inFind("response_s", "reaction_time"), "reaction_time is not in variableMeasured"},
      {"a column that comes twice", inFind("expected", "answer"), "column answer comes twice"},
      {"a column without a name", inFind(",view,", ",,"), "a column without a name"},
      {"a row_id that comes twice", inFind("\r\n2,", "\r\n1,"), "row_id \"1\""},
      {"an empty row_id", inFind("\r\n2,", "\r\n,"), "row_id \"\""},
      {"a field too few", inFind("\r\n2,", "\r\n"), "line 3 has another number of fields"},
      {"a field too many", inFind("\r\n2,", "\r\n2,,"), "line 3 has another number of fields"},
      {"a quote that does not close", inFind("\r\n2,", "\r\n\"2,"), "quotes that RFC 4180 does not allow"},
      {"a quote within a field", inFind(",find stationary,", ",find \"stationary\","), "quotes that RFC 4180"},
      {"bytes that are no UTF-8", inFind("find stationary", "find \xfc"), "not UTF-8"},
      {"an empty file", [](const Path& set) { std::ofstream(set / kFind, std::ios::trunc).flush(); },
       "no column names"},
  };
  return all;
}

TEST_F(PsychDsTest, BreaksARuleByEachMutationWhichIsFound) {
  ASSERT_GE(mutations().size(), 10u);
  for (const Mutation& mutation : mutations()) {
    const std::filesystem::path copy = folder_ / "copy";
    std::filesystem::remove_all(copy);
    std::filesystem::copy(set_, copy, std::filesystem::copy_options::recursive);
    ASSERT_THAT(psychDsViolations(copy), IsEmpty());
    mutation.apply(copy);
    EXPECT_THAT(psychDsViolations(copy), Contains(HasSubstr(mutation.found))) << mutation.name;
  }
}

}  // namespace
}  // namespace ocelli::test
