#include "oc_core/base/json_fields.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "oc_core/base/error.h"
#include "tests/base/json_error.h"

namespace ocelli {
namespace {

using test::jsonErrorOf;
using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

nlohmann::json sample() {
  return parseJson(R"({"radius": 0.127, "slices": 198, "mirrored": true, "name": "perspecta", "list": [1, 2]})",
                   "p.json");
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
  EXPECT_THAT(jsonErrorOf([&] { fields.text("colour"); }),
              AllOf(HasSubstr("p.json"), HasSubstr("\"colour\" is missing")));
}

TEST(JsonFields, NamesAFieldOfTheWrongType) {
  const nlohmann::json object = sample();
  JsonFields fields(object, "p.json");
  EXPECT_THAT(jsonErrorOf([&] { fields.number("name", 0, 1); }), HasSubstr("\"name\" must be a number"));
  EXPECT_THAT(jsonErrorOf([&] { fields.integer("radius", 0, 1); }), HasSubstr("\"radius\" must be a whole number"));
  EXPECT_THAT(jsonErrorOf([&] { fields.boolean("slices", true); }), HasSubstr("\"slices\" must be true or false"));
  EXPECT_THAT(jsonErrorOf([&] { fields.text("slices"); }), HasSubstr("\"slices\" must be a text"));
}

TEST(JsonFields, NamesARangeThatIsLeft) {
  const nlohmann::json object = sample();
  JsonFields fields(object, "p.json");
  EXPECT_THAT(jsonErrorOf([&] { fields.integer("slices", 1, 100); }), HasSubstr("must lie between 1 and 100, not 198"));
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
  EXPECT_THAT(jsonErrorOf([&] { fields.rejectUnknown(); }), HasSubstr("list"));
}

TEST(JsonFields, ListsTheKnownFieldsWhetherOrNotTheyAreThere) {
  const nlohmann::json object = parseJson(R"({"colour": 1})", "p.json");
  JsonFields fields(object, "p.json");
  fields.number("radius", 0, 1, 0.5);
  fields.has("name");
  EXPECT_THAT(jsonErrorOf([&] { fields.rejectUnknown(); }), HasSubstr("use one of: name, radius"));
}

TEST(JsonFields, AllowsSchemaAndComment) {
  const nlohmann::json object = parseJson(R"({"$schema": "x", "comment": "y"})", "p.json");
  EXPECT_NO_THROW(JsonFields(object, "p.json").rejectUnknown());
}

TEST(JsonFields, WantsAnObject) {
  const nlohmann::json list = nlohmann::json::array();
  EXPECT_THROW(JsonFields(list, "p.json"), InputError);
}

const char* const kStudyText = R"({
  "name": "caf\u00e9 \u2615", // of 6 characters
  "kind": "small",
  "page": {"title": "t",
           "lines": ["a", "bb"]},
  "cases": [{"row": 1}, {"row": 2,
    "column": 3}],
  "mazes": {"a/b": {"side": 4},
            "c": {"side": 5}}
})";

TEST(JsonFields, ReadsTextsOfLimitedLength) {
  const JsonDocument document(kStudyText, "s.json");
  JsonFields fields(document);
  EXPECT_EQ(fields.shortText("name", 6), "caf\u00e9 \u2615") << "characters, not bytes";
  EXPECT_THAT(jsonErrorOf([&] { fields.shortText("name", 5); }),
              HasSubstr("s.json:2: field \"name\" must have 1 to 5 characters, not 6"));
  EXPECT_EQ(fields.shortText("title", 6, "none"), "none");
  EXPECT_THAT(jsonErrorOf([&] { fields.shortText("title", 6); }), HasSubstr("\"title\" is missing"));
  EXPECT_THAT(jsonErrorOf([&] { fields.shortText("page", 6); }), HasSubstr("must be a text"));
  const nlohmann::json empty{{"name", ""}};
  EXPECT_THAT(jsonErrorOf([&] { JsonFields(empty, "s.json").shortText("name", 6, "none"); }),
              HasSubstr("must have 1 to 6 characters, not 0"));
}

TEST(JsonFields, ReadsListsOfTexts) {
  const JsonDocument document(kStudyText, "s.json");
  JsonFields page = JsonFields(document).inner("page");
  EXPECT_THAT(page.texts("lines", 2, 2, 2), ElementsAre("a", "bb"));
  EXPECT_THAT(page.texts("notes", 0, 2, 2), IsEmpty()) << "missing";
  EXPECT_THAT(jsonErrorOf([&] { page.texts("notes", 1, 2, 2); }), HasSubstr("\"notes\" is missing"));
  for (const auto& [min, max] : {std::pair{0u, 1u}, std::pair{3u, 4u}}) {
    EXPECT_THAT(jsonErrorOf([&] { page.texts("lines", min, max, 2); }),
                HasSubstr(testing::PrintToString(min) + " to " + testing::PrintToString(max) + " texts"));
  }
  EXPECT_THAT(
      jsonErrorOf([&] { page.texts("lines", 0, 2, 1); }),
      HasSubstr("s.json:5, \"page\": field \"lines\" must be an array of texts of 1 to 1 characters, but entry 2"));
  EXPECT_THAT(jsonErrorOf([&] { page.texts("title", 0, 2, 1); }), HasSubstr("must be an array of 0 to 2 texts"));
}

enum class Size { kSmall, kLarge };
constexpr Size kSizes[] = {Size::kSmall, Size::kLarge};
const char* nameOf(Size size) {
  return size == Size::kSmall ? "small" : "large";
}

TEST(JsonFields, ReadsChoices) {
  const JsonDocument document(kStudyText, "s.json");
  JsonFields fields(document);
  EXPECT_EQ(fields.choice("kind", {"large", "small"}), "small");
  EXPECT_EQ(fields.choice("shape", {"round", "flat"}, "flat"), "flat");
  EXPECT_THAT(jsonErrorOf([&] { fields.choice("shape", {"round"}); }), HasSubstr("\"shape\" is missing"));
  EXPECT_THAT(jsonErrorOf([&] {
                fields.choice("kind", {"round", "flat"}, "flat");
              }),
              HasSubstr("s.json:3: field \"kind\" must be one of round, flat, not \"small\""));
  EXPECT_EQ(fields.choiceOf("kind", kSizes), Size::kSmall);
  EXPECT_EQ(fields.choiceOf("size", kSizes, Size::kLarge), Size::kLarge);
  EXPECT_THAT(jsonErrorOf([&] { fields.choiceOf("name", kSizes); }), HasSubstr("must be one of small, large"));
}

TEST(JsonFields, NameFileAndLineOfWhatIsInside) {
  const JsonDocument document(kStudyText, "s.json");
  JsonFields fields(document);
  EXPECT_EQ(fields.where(), "s.json:1");
  JsonFields page = fields.inner("page");
  EXPECT_EQ(page.where(), "s.json:4, \"page\"");
  page.text("title");
  EXPECT_THAT(jsonErrorOf([&] { page.rejectUnknown(); }),
              AllOf(HasSubstr("s.json:5, \"page\": field \"lines\" is unknown"), HasSubstr("use one of: title")));
  page.callIt("first");
  EXPECT_EQ(page.where(), "s.json:4, \"page\" (first)");
  EXPECT_THAT(jsonErrorOf([&] { fields.inner("kind"); }), HasSubstr("s.json:3, \"kind\": a JSON object"));
  EXPECT_THAT(jsonErrorOf([&] { fields.inner("none"); }), HasSubstr("s.json:1: field \"none\" is missing"));
  // Without a document.
  const nlohmann::json object = document.root();
  EXPECT_EQ(JsonFields(object, "s.json, it").inner("page").where(), "s.json, it, \"page\"");
}

TEST(JsonFields, CallsForEachObjectOfAnArray) {
  const JsonDocument document(kStudyText, "s.json");
  JsonFields fields(document);
  std::vector<int> rows;
  const auto read = [&](JsonFields& each) {
    rows.push_back(each.integer("row", 0, 9));
    each.has("column");
  };
  fields.forEach("cases", 2, 2, read);
  fields.forEach("none", 0, 2, read);
  EXPECT_THAT(rows, ElementsAre(1, 2));
  EXPECT_THAT(jsonErrorOf([&] { fields.forEach("none", 1, 2, read); }), HasSubstr("\"none\" is missing"));
  EXPECT_THAT(jsonErrorOf([&] { fields.forEach("cases", 3, 4, read); }),
              HasSubstr("s.json:6: field \"cases\" must be an array of 3 to 4 objects"));
  EXPECT_THAT(jsonErrorOf([&] { fields.forEach("cases", 0, 1, read, "cases"); }),
              HasSubstr("an array of 0 to 1 cases"));
  EXPECT_THAT(jsonErrorOf([&] { fields.forEach("page", 0, 1, read); }), HasSubstr("must be an array"));
  EXPECT_THAT(jsonErrorOf([&] { fields.forEach("cases", 0, 9, [](JsonFields& each) { each.has("row"); }); }),
              HasSubstr("s.json:7, \"cases\" 2: field \"column\" is unknown"));
}

TEST(JsonFields, CallsForEachObjectByName) {
  const JsonDocument document(kStudyText, "s.json");
  JsonFields fields(document);
  std::string read;
  fields.forEachNamed("mazes", 2, [&](const std::string& name, JsonFields& each) {
    read += name + "=" + std::to_string(each.integer("side", 0, 9)) + " ";
  });
  fields.forEachNamed("none", 2, [&](const std::string&, JsonFields&) { FAIL(); });
  EXPECT_EQ(read, "a/b=4 c=5 ");
  const auto ignore = [](const std::string&, JsonFields&) {};
  EXPECT_THAT(jsonErrorOf([&] { fields.forEachNamed("mazes", 2, ignore); }),
              HasSubstr("s.json:8, \"mazes\" a/b: field \"side\" is unknown"));
  EXPECT_THAT(jsonErrorOf([&] { fields.forEachNamed("mazes", 1, ignore, "mazes"); }),
              HasSubstr("must be an object of at most 1 mazes by name"));
  EXPECT_THAT(jsonErrorOf([&] { fields.forEachNamed("cases", 9, ignore); }), HasSubstr("must be an object"));
}

TEST(JsonFields, IgnoreUnknownFieldsWhereToldTo) {
  const JsonDocument document(kStudyText, "s.json");
  JsonFields fields(document, UnknownFields::kIgnored);
  EXPECT_NO_THROW(fields.rejectUnknown());
  EXPECT_NO_THROW(fields.inner("page").rejectUnknown());
  EXPECT_NO_THROW(fields.forEach("cases", 0, 9, [](JsonFields&) {}));
}

}  // namespace
}  // namespace ocelli
