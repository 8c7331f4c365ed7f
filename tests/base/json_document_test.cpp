#include "oc_core/base/json_document.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "tests/base/json_error.h"
#include "tests/base/temporary_folder.h"

namespace ocelli::test {
namespace {

using testing::AllOf;
using testing::HasSubstr;

TEST(ParseJson, SaysLineAndColumn) {
  EXPECT_THAT(jsonErrorOf([] { parseJson("{\n  \"a\": 1,\n  oops\n}", "p.json"); }), HasSubstr("p.json:3:3"));
  EXPECT_THAT(jsonErrorOf([] { parseJson("oops", "p.json"); }), HasSubstr("p.json:1:1"));
}

TEST(ParseJson, RejectsWhatIsCutShort) {
  const std::string whole = R"({"a": [1, {"b": "c"}], "d": 1.5e3})";
  for (size_t length = 0; length < whole.size(); ++length) {
    EXPECT_THROW(parseJson(whole.substr(0, length), "p.json"), InputError) << length;
  }
  EXPECT_NO_THROW(parseJson(whole, "p.json"));
}

TEST(ParseJson, RejectsNumbersThatJsonDoesNotHave) {
  for (const char* text : {"[NaN]", "[Infinity]", "[1e999]", "[01]", "[\"\xff\"]"}) {
    EXPECT_THROW(parseJson(text, "p.json"), InputError) << text;
  }
}

TEST(ParseJson, AllowsComments) {
  EXPECT_EQ(parseJson("{ // radius in metres\n \"r\": /* inches? no */ 1 }", "p.json").at("r"), 1);
}

TEST(ReadJsonFile, ReadsAndNamesTheFile) {
  const test::TemporaryFolder folder;
  EXPECT_EQ(readJsonFile(folder.write("good.json", "{\"a\": 2}")).at("a"), 2);
  const auto broken = folder.write("broken.json", "{");
  EXPECT_THAT(jsonErrorOf([&] { readJsonFile(broken); }), HasSubstr("broken.json:1:2"));
}

TEST(ReadJsonFile, RejectsMissingEmptyAndFolder) {
  const test::TemporaryFolder folder;
  EXPECT_THROW(readJsonFile(folder / "missing.json"), InputError);
  EXPECT_THROW(readJsonFile(folder.write("empty.json", "")), InputError);
  EXPECT_THROW(readJsonFile(folder.path()), InputError);
}

TEST(ParseJson, DeepNestingIsAnError) {
  EXPECT_NO_THROW(parseJson(std::string(90, '[') + std::string(90, ']'), "x.json"));
  for (const size_t depth : {200u, 500000u}) {
    EXPECT_THROW(parseJson(std::string(depth, '[') + std::string(depth, ']'), "x.json"), InputError);
    EXPECT_THROW(parseJson(std::string(depth, '['), "x.json"), InputError);
  }
}

TEST(ParseJson, tellsOfTwoFieldsOfOneName) {
  EXPECT_THAT(jsonErrorOf([] { parseJson(R"({"a": {"seed": 1, "b": 2, "seed": 2}})", "p.json"); }),
              AllOf(HasSubstr("\"seed\" stands twice"), HasSubstr("p.json")));
  EXPECT_NO_THROW(parseJson(R"({"a": {"seed": 1}, "b": [{"seed": 1}, {"seed": 1}], "seed": 1})", "p.json"));
  // Comments may be many.
  EXPECT_NO_THROW(parseJson(R"({"comment": "one", "comment": "two"})", "p.json"));
}

TEST(ReadJsonFile, readsNoEndlessFile) {
  EXPECT_THAT(jsonErrorOf([] { readJsonFile("/dev/zero"); }), AllOf(HasSubstr("larger than"), HasSubstr("/dev/zero")));
}

TEST(TextOfJson, IsValidWhateverBytesNamesHold) {
  const std::string name = "caf\xe9 \xc3\xa9 \xf0\x9f\x92 \"1\"\n";
  const std::string text = textOfJson({{"name", name}, {"ratio", std::nan("")}});
  const auto back = nlohmann::json::parse(text);
  EXPECT_EQ(back["name"], "caf\xef\xbf\xbd \xc3\xa9 \xef\xbf\xbd \"1\"\n");
  EXPECT_TRUE(back["ratio"].is_null());
  EXPECT_EQ(textOfJson({{"a", 1}}, 2), "{\n  \"a\": 1\n}");
}

TEST(JsonDocument, KnowsThePlaceOfEachValueOrOfTheNearestAroundIt) {
  const JsonDocument document("{\n\"a\": [1,\n2],\n\"b\": {}}", "p.json");
  EXPECT_EQ(document.root().at("a").size(), 2u);
  EXPECT_EQ(document.placeOf(""), "p.json:1");
  EXPECT_EQ(document.placeOf("/a/1"), "p.json:3");
  EXPECT_EQ(document.placeOf("/b/missing/deeper"), "p.json:4");
  EXPECT_EQ(document.placeOf("/c"), "p.json:1");
}

TEST(JsonDocument, RefusesWhatTheParserRefuses) {
  EXPECT_THAT(jsonErrorOf([] { JsonDocument("{\"a\": 1\n \"b\": 2}", "p.json"); }),
              HasSubstr("p.json:2:4: this is not valid JSON"));
  EXPECT_THAT(jsonErrorOf([] { JsonDocument(std::string(500, '['), "p.json"); }), HasSubstr("deeper than 100 levels"));
  EXPECT_THAT(jsonErrorOf([] { JsonDocument("{\"a\": 1, \"a\": 2}", "p.json"); }), HasSubstr("stands twice"));
  EXPECT_THAT(jsonErrorOf([] { JsonDocument("[1e999]", "p.json"); }), HasSubstr("too large"));
}

TEST(ReadAs, SaysWhereTheFieldsAreDescribed) {
  const auto wrong = [] { throw JsonFieldError("field \"a\" is missing", "p.json:3"); };
  EXPECT_THAT(jsonErrorOf(wrong), HasSubstr("see docs/files.md"));
  EXPECT_THAT(jsonErrorOf([&] { readAs("protocols/x.schema.json", wrong); }),
              AllOf(HasSubstr("p.json:3: field \"a\" is missing"), HasSubstr("see protocols/x.schema.json")));
}

}  // namespace
}  // namespace ocelli::test
