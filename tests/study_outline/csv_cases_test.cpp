#include "study/outline/csv_cases.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "oc_core/base/error.h"
#include "oc_core/base/file_bytes.h"
#include "tests/base/temporary_folder.h"

namespace ocelli::test {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

const std::string kProtocol = R"({"factors": [{"name": "size", "levels": ["small", "large"], "of": "cases"}],
  "blocks": [{"name": "a", "cases": [{"row": 1}]},
    {"name": "b", "cases": {  // a table
       "csv": "tables/cases.csv"},
     "practice_cases": [{"row": 3}], "task": "find"}]})";

class CsvCasesTest : public testing::Test {
 protected:
  void write(const std::string& table) {
    std::filesystem::create_directories(folder_.path() / "tables");
    writeFile(folder_.path() / "tables/cases.csv", table);
  }
  ProtocolText read(const std::string& protocol = kProtocol) const {
    return withCsvCases(protocol, folder_.path() / "study.json");
  }
  std::string errorOf(const std::string& table) {
    write(table);
    try {
      read();
    } catch (const InputError& error) {
      return error.what();
    }
    return "";
  }

  TemporaryFolder folder_;
};

TEST_F(CsvCasesTest, StandInTheProtocol) {
  write(
      "label,row,start.column,size,moving,places,look\n"
      "1,2,3,small,true,\"[{\"\"row\"\": 1}]\",north\n"
      "\"two, or so\",-0.5,,large,false,,\n");
  const ProtocolText text = read();
  const nlohmann::json json = nlohmann::json::parse(text.text, nullptr, true, true);
  EXPECT_EQ(json["blocks"][1]["cases"], nlohmann::json::parse(R"([
    {"label": "1", "row": 2, "start": {"column": 3}, "factors": {"size": "small"}, "moving": true,
     "places": [{"row": 1}], "look": "north"},
    {"label": "two, or so", "row": -0.5, "factors": {"size": "large"}, "moving": false}])"));
  EXPECT_EQ(json["blocks"][0], nlohmann::json::parse(R"({"name": "a", "cases": [{"row": 1}]})"));
  EXPECT_EQ(json["blocks"][1]["task"], "find");
  EXPECT_EQ(std::count(text.text.begin(), text.text.end(), '\n'), std::count(kProtocol.begin(), kProtocol.end(), '\n'))
      << "what follows stays on its line";
  ASSERT_EQ(text.tables.size(), 1u);
  EXPECT_EQ(text.tables[0].pointer, "/blocks/1/cases");
  EXPECT_THAT(text.tables[0].lines, ElementsAre(2, 3));
  EXPECT_THAT(text.tables[0].placeOf(1, "row"), HasSubstr("tables/cases.csv:3, column 2 (row)"));
  EXPECT_THAT(text.tables[0].placeOf(0, "column"), HasSubstr("cases.csv:2, column 3 (start.column)"));
  EXPECT_EQ(withCsvCases(text.text, "study.db").text, text.text) << "it stands alone";
}

TEST_F(CsvCasesTest, LeaveOtherProtocolsAlone) {
  const std::string plain = "// none\n{\"blocks\": [{\"cases\": [{\"row\": 1}]}]}\n";
  EXPECT_EQ(withCsvCases(plain, "study.json").text, plain);
  EXPECT_TRUE(withCsvCases(plain, "study.json").tables.empty());
  EXPECT_EQ(withCsvCases("[1]", "study.json").text, "[1]");
}

TEST_F(CsvCasesTest, SayFileLineAndColumnOfWhatIsWrong) {
  EXPECT_THAT(errorOf("row,column\n1,2\n3\n"),
              HasSubstr("cases.csv:3: this line has 1 fields, but the first line names 2"));
  EXPECT_THAT(errorOf("row,row\n1,2\n"), HasSubstr("cases.csv:1, column 2 (row): this column stands twice"));
  EXPECT_THAT(errorOf("row,start.\n1,2\n"), HasSubstr("column 2 (start.): a column must have the name of a field"));
  EXPECT_THAT(errorOf("row,places\n1,[2\n"),
              HasSubstr("cases.csv:2, column 2 (places): this is neither a list nor an"));
  EXPECT_THAT(errorOf("start,start.row\n1,2\n"), HasSubstr("another column gives this object a value"));
  EXPECT_THAT(errorOf("start.row,start\n1,2\n"), HasSubstr("another column has this field"));
  EXPECT_THAT(errorOf("size,factors.size\nsmall,small\n"), HasSubstr("another column has this field"));
  EXPECT_THAT(errorOf("row\n"), HasSubstr("has no cases"));
  EXPECT_THAT(errorOf("row,label\n1,\"x\n"), HasSubstr("cases.csv:2: a quote of this row does not end"));
  EXPECT_THAT(errorOf("label\n\xff\n"), HasSubstr("cases.csv:2, column 1 (label): this field is not valid UTF-8"));
}

TEST_F(CsvCasesTest, AreNamedRelativeToTheProtocol) {
  const auto errorOfField = [&](const std::string& field) {
    try {
      read(R"({"blocks": [{"cases": )" + field + "}]}");
    } catch (const InputError& error) {
      return std::string(error.what());
    }
    return std::string();
  };
  EXPECT_THAT(errorOfField(R"({"csv": "none.csv"})"), HasSubstr("none.csv"));
  EXPECT_THAT(errorOfField(R"({"csv": "/cases.csv"})"),
              HasSubstr("study.json:1: field \"cases\" must be a list of cases"));
  EXPECT_THAT(errorOfField(R"({"csv": 3})"), HasSubstr("must be a list of cases"));
  EXPECT_THAT(errorOfField(R"({"csv": "a.csv", "more": 1})"), HasSubstr("must be a list of cases"));
}

}  // namespace
}  // namespace ocelli::test
