#include "oc_core/base/json_fields.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "oc_core/base/error.h"
#include "tests/base/temporary_folder.h"

namespace ocelli {
namespace {

using testing::AllOf;
using testing::HasSubstr;

nlohmann::json sample() {
  return parseJson(R"({"radius": 0.127, "slices": 198, "mirrored": true, "name": "perspecta", "list": [1, 2]})",
                   "p.json");
}

template <class Call>
std::string messageOf(const Call& call) {
  try {
    call();
  } catch (const InputError& error) {
    return error.what();
  }
  return "nothing was thrown";
}

TEST(JsonFields, ReadsEachType) {
  const nlohmann::json object = sample();
  JsonFields fields(object, "p.json");
  EXPECT_EQ(fields.number("radius", 0, 1), 0.127);
  EXPECT_EQ(fields.integer("slices", 1, 1000), 198);
  EXPECT_TRUE(fields.boolean("mirrored", false));
  EXPECT_EQ(fields.text("name"), "perspecta");
  EXPECT_EQ(fields.value("list").size(), 2u);
  fields.rejectUnknown();
}

TEST(JsonFields, FallsBackWhereAFieldIsOptional) {
  const nlohmann::json object = nlohmann::json::object();
  JsonFields fields(object, "p.json");
  EXPECT_EQ(fields.number("radius", 0, 1, 0.5), 0.5);
  EXPECT_EQ(fields.integer("slices", 0, 9, 3), 3);
  EXPECT_TRUE(fields.boolean("mirrored", true));
  EXPECT_EQ(fields.text("name", "none"), "none");
  EXPECT_FALSE(fields.has("name"));
}

TEST(JsonFields, NamesAMissingField) {
  const nlohmann::json object = sample();
  JsonFields fields(object, "p.json");
  EXPECT_THAT(messageOf([&] { fields.text("colour"); }),
              AllOf(HasSubstr("p.json"), HasSubstr("\"colour\" is missing")));
}

TEST(JsonFields, NamesAFieldOfTheWrongType) {
  const nlohmann::json object = sample();
  JsonFields fields(object, "p.json");
  EXPECT_THAT(messageOf([&] { fields.number("name", 0, 1); }), HasSubstr("\"name\" must be a number"));
  EXPECT_THAT(messageOf([&] { fields.integer("radius", 0, 1); }), HasSubstr("\"radius\" must be a whole number"));
  EXPECT_THAT(messageOf([&] { fields.boolean("slices", true); }), HasSubstr("\"slices\" must be true or false"));
  EXPECT_THAT(messageOf([&] { fields.text("slices"); }), HasSubstr("\"slices\" must be a text"));
}

TEST(JsonFields, NamesARangeThatIsLeft) {
  const nlohmann::json object = sample();
  JsonFields fields(object, "p.json");
  EXPECT_THAT(messageOf([&] { fields.integer("slices", 1, 100); }), HasSubstr("must lie between 1 and 100, not 198"));
  // The ends belong to the range.
  EXPECT_EQ(fields.integer("slices", 198, 198), 198);
}

TEST(JsonFields, HugeIntegersAreOutOfRangeAndNotWrapped) {
  const nlohmann::json object = parseJson(R"({"n": 18446744073709551615, "m": -9223372036854775808})", "p.json");
  JsonFields fields(object, "p.json");
  EXPECT_THROW(fields.integer("n", -10, 10), InputError);
  EXPECT_THROW(fields.integer("m", -10, 10), InputError);
}

TEST(JsonFields, RejectsAnUnknownFieldByName) {
  const nlohmann::json object = sample();
  JsonFields fields(object, "p.json");
  fields.number("radius", 0, 1);
  EXPECT_THAT(messageOf([&] { fields.rejectUnknown(); }), HasSubstr("list"));
}

TEST(JsonFields, ListsTheKnownFieldsWhetherOrNotTheyAreThere) {
  const nlohmann::json object = parseJson(R"({"colour": 1})", "p.json");
  JsonFields fields(object, "p.json");
  fields.number("radius", 0, 1, 0.5);
  fields.has("name");
  EXPECT_THAT(messageOf([&] { fields.rejectUnknown(); }), HasSubstr("use one of: name, radius"));
}

TEST(JsonFields, AllowsSchemaAndComment) {
  const nlohmann::json object = parseJson(R"({"$schema": "x", "comment": "y"})", "p.json");
  EXPECT_NO_THROW(JsonFields(object, "p.json").rejectUnknown());
}

TEST(JsonFields, WantsAnObject) {
  const nlohmann::json list = nlohmann::json::array();
  EXPECT_THROW(JsonFields(list, "p.json"), InputError);
}

TEST(ParseJson, SaysLineAndColumn) {
  EXPECT_THAT(messageOf([] { parseJson("{\n  \"a\": 1,\n  oops\n}", "p.json"); }), HasSubstr("p.json:3:3"));
  EXPECT_THAT(messageOf([] { parseJson("oops", "p.json"); }), HasSubstr("p.json:1:1"));
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
  EXPECT_THAT(messageOf([&] { readJsonFile(broken); }), HasSubstr("broken.json:1:2"));
}

TEST(ReadJsonFile, RejectsMissingEmptyAndFolder) {
  const test::TemporaryFolder folder;
  EXPECT_THROW(readJsonFile(folder / "missing.json"), InputError);
  EXPECT_THROW(readJsonFile(folder.write("empty.json", "")), InputError);
  EXPECT_THROW(readJsonFile(folder.path()), InputError);
}

TEST(JsonFields, DeepNestingIsAnError) {
  EXPECT_NO_THROW(parseJson(std::string(90, '[') + std::string(90, ']'), "x.json"));
  for (const size_t depth : {200u, 500000u}) {
    EXPECT_THROW(parseJson(std::string(depth, '[') + std::string(depth, ']'), "x.json"), InputError);
    EXPECT_THROW(parseJson(std::string(depth, '['), "x.json"), InputError);
  }
}

TEST(JsonFields, tellsOfTwoFieldsOfOneName) {
  EXPECT_THAT(messageOf([] { parseJson(R"({"a": {"seed": 1, "b": 2, "seed": 2}})", "p.json"); }),
              AllOf(HasSubstr("\"seed\" stands twice"), HasSubstr("p.json")));
  EXPECT_NO_THROW(parseJson(R"({"a": {"seed": 1}, "b": [{"seed": 1}, {"seed": 1}], "seed": 1})", "p.json"));
  // Comments may be many.
  EXPECT_NO_THROW(parseJson(R"({"comment": "one", "comment": "two"})", "p.json"));
}

TEST(JsonFields, readsNoEndlessFile) {
  EXPECT_THAT(messageOf([] { readJsonFile("/dev/zero"); }), AllOf(HasSubstr("larger than"), HasSubstr("/dev/zero")));
}

TEST(TextOfJson, IsValidWhateverBytesNamesHold) {
  const std::string name = "caf\xe9 \xc3\xa9 \xf0\x9f\x92 \"1\"\n";
  const std::string text = textOfJson({{"name", name}, {"ratio", std::nan("")}});
  const auto back = nlohmann::json::parse(text);
  EXPECT_EQ(back["name"], "caf\xef\xbf\xbd \xc3\xa9 \xef\xbf\xbd \"1\"\n");
  EXPECT_TRUE(back["ratio"].is_null());
  EXPECT_EQ(textOfJson({{"a", 1}}, 2), "{\n  \"a\": 1\n}");
}

}  // namespace
}  // namespace ocelli
