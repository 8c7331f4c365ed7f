// The contract of the kinds of questions: each runs through the same tests, with an example in question_examples.h.
#include "study/outline/question_kinds.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>
#include <nlohmann/json.hpp>
#include <set>
#include <sstream>

#include "oc_core/base/json_fields.h"
#include "tests/study_outline/outline_text.h"
#include "tests/study_outline/question_examples.h"

namespace ocelli::test {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

class QuestionContract : public testing::TestWithParam<std::string> {
 protected:
  FormField field_ = questionExample(GetParam());
  const QuestionKind& kind_ = questionKind(field_.kind);

  void apply(QuestionEntry& entry, const QuestionStroke& stroke) const {
    if (stroke.key) {
      kind_.press(field_, entry, *stroke.key);
    } else {
      kind_.type(field_, entry, stroke.character);
    }
  }
};

TEST_P(QuestionContract, whatIsNotAnsweredIsNotStored) {
  const QuestionEntry empty;
  EXPECT_TRUE(empty.isEmpty());
  EXPECT_EQ(kind_.stored(field_, empty), std::nullopt);
}

TEST_P(QuestionContract, keysAloneReachEveryAnswer) {
  Random random(7);
  QuestionEntry entry;
  for (int i = 0; i < 200; ++i) {
    const QuestionEntry target = kind_.atRandom(field_, random);
    const std::optional<std::string> wanted = kind_.stored(field_, target);
    ASSERT_TRUE(wanted) << "an answer at random is an answer";
    EXPECT_FALSE(kind_.problem(field_, target));
    int strokes = 0;
    while (const auto stroke = kind_.towards(field_, entry, target)) {
      apply(entry, *stroke);
      ASSERT_LT(++strokes, 2000);
    }
    EXPECT_EQ(kind_.stored(field_, entry), wanted) << "from the last answer to " << *wanted;
    if (i % 2 == 0) {
      entry = {};  // and from nothing
    }
  }
}

TEST_P(QuestionContract, storedAnswersAreOfTheirType) {
  Random random(3);
  for (int i = 0; i < 50; ++i) {
    const std::string stored = kind_.stored(field_, kind_.atRandom(field_, random)).value();
    const std::vector<std::string>& options = storedOptions(field_);
    switch (kind_.value) {
      case QuestionValue::kOption:
        EXPECT_THAT(options, testing::Contains(stored));
        break;
      case QuestionValue::kOptions:
        for (const auto& each : nlohmann::json::parse(stored)) {
          EXPECT_THAT(options, testing::Contains(each.get<std::string>()));
        }
        break;
      case QuestionValue::kNumber:
        EXPECT_GE(std::stod(stored), field_.least);
        EXPECT_LE(std::stod(stored), field_.most);
        break;
      case QuestionValue::kText:
        EXPECT_FALSE(stored.empty());
        break;
    }
  }
}

TEST_P(QuestionContract, isSeenAndClicked) {
  QuestionEntry entry;
  const QuestionLook before = kind_.look(field_, entry);
  EXPECT_TRUE(!before.options.empty() || before.track || before.box);
  kind_.click(field_, entry, {0, 0.3});
  if (before.options.empty() && !before.track) {
    return;  // a box is typed into
  }
  EXPECT_TRUE(kind_.stored(field_, entry));
  const QuestionLook after = kind_.look(field_, entry);
  EXPECT_EQ(after.track ? after.track->share.has_value() : after.options[0].chosen, true);
}

INSTANTIATE_TEST_SUITE_P(Kinds, QuestionContract, testing::ValuesIn(questionExamples()),
                         [](const auto& test) { return questionExample(test.param).name; });

TEST(QuestionKinds, EachHasAnExample) {
  std::set<std::string> shown;
  for (const std::string& example : questionExamples()) {
    shown.insert(questionExample(example).kind);
  }
  for (const QuestionKind& kind : questionKinds()) {
    EXPECT_TRUE(shown.contains(kind.name)) << kind.name;
    EXPECT_FALSE(kind.description.empty());
  }
}

/// The recipe: nothing outside of its own file names a kind.
TEST(QuestionKinds, AreNamedInTheirOwnFilesAlone) {
  for (const char* file :
       {"study/session/form_answers.cpp", "study/screen/form_drawing.cpp", "study/screen/question_drawing.cpp",
        "study/subject/form_taste.cpp", "study/subject/session_observer.cpp", "analysis/dataset/form_item.cpp"}) {
    std::ifstream in(std::string(OCELLI_SOURCE_DIR) + "/" + file);
    ASSERT_TRUE(in) << file;
    std::stringstream text;
    text << in.rdbuf();
    for (const QuestionKind& kind : questionKinds()) {
      EXPECT_EQ(text.str().find("\"" + kind.name + "\""), std::string::npos) << file << " names " << kind.name;
    }
  }
}

std::string storedOf(const std::string& json, const std::vector<QuestionStroke>& strokes) {
  const FormField field = questionExample(json);
  const QuestionKind& kind = questionKind(field.kind);
  QuestionEntry entry;
  for (const QuestionStroke& stroke : strokes) {
    if (stroke.key) {
      kind.press(field, entry, *stroke.key);
    } else {
      kind.type(field, entry, stroke.character);
    }
  }
  return kind.stored(field, entry).value_or("nothing");
}

std::vector<QuestionStroke> typed(std::u32string_view text) {
  std::vector<QuestionStroke> strokes;
  for (const char32_t character : text) {
    strokes.push_back({std::nullopt, character});
  }
  return strokes;
}

TEST(QuestionKinds, NumbersAreTypedInManyWaysAndStoredInOne) {
  const std::string any =
      R"({"name": "a", "question": "?", "kind": "number", "least": -100, "most": 100, "step": 0.5})";
  EXPECT_EQ(storedOf(any, typed(U"7")), "7");
  EXPECT_EQ(storedOf(any, typed(U"-3,50")), "-3.5");
  EXPECT_EQ(storedOf(any, typed(U"\u0664\u0662")), "42") << "Arabic digits";
  EXPECT_EQ(storedOf(any, typed(U"\uff11\uff10")), "10") << "full width";
  EXPECT_EQ(storedOf(any, typed(U"-0")), "0");
  EXPECT_EQ(storedOf(any, typed(U"0")), "0") << "zero is an answer";
  EXPECT_EQ(storedOf(any, typed(U"")), "nothing") << "and nothing is none";
  EXPECT_EQ(storedOf(any, typed(U"1e2")), "12") << "letters are not taken";
  for (const char32_t* wrong : {U"101", U"0.25", U"-", U"."}) {
    EXPECT_EQ(storedOf(any, typed(wrong)), "nothing");
  }
  const FormField field = questionExample(any);
  QuestionEntry entry;
  entry.typed = "101";
  const auto problem = questionKind(field.kind).problem(field, entry);
  ASSERT_TRUE(problem);
  EXPECT_STREQ(problem->text, "form_number");
  EXPECT_EQ(problem->least, "-100");
}

TEST(QuestionKinds, SlidersBeginWithoutAMark) {
  const std::string& json = questionExamples()[6];
  EXPECT_EQ(storedOf(json, {}), "nothing");
  EXPECT_EQ(storedOf(json, {{Key::kRight}}), "50") << "the middle first";
  EXPECT_EQ(storedOf(json, {{Key::kRight}, {Key::kRight}}), "55");
  EXPECT_EQ(storedOf(json, {{Key::kHome}, {Key::kLeft}}), "0");
  EXPECT_EQ(storedOf(json, {{Key::kEnd}, {Key::kRight}}), "100");
  EXPECT_EQ(storedOf(questionExamples()[7], {{Key::kHome}, {Key::kRight}, {Key::kRight}, {Key::kRight}}), "0.3")
      << "without the rounding of 3 x 0.1";
}

TEST(QuestionKinds, SeveralOptionsKeepTheOrderOfTheProtocol) {
  const std::string& json = questionExamples()[2];
  EXPECT_EQ(storedOf(json, {{Key::k3}, {Key::k1}}), R"(["mouse","pad"])");
  EXPECT_EQ(storedOf(json, {{Key::k3}, {Key::k3}}), "nothing");
  EXPECT_EQ(storedOf(json, {{Key::kRight}, {Key::kSpace}}), R"(["keys"])");
}

TEST(QuestionKinds, TextsAreStoredAsTyped) {
  const std::string& json = questionExamples()[3];
  EXPECT_EQ(storedOf(json, typed(U"  caf\u00e9, \u3042 = 1; DROP TABLE ")), "caf\u00e9, \u3042 = 1; DROP TABLE");
  EXPECT_EQ(storedOf(json, typed(std::u32string(60, U'x'))), std::string(40, 'x')) << "as many as it may have";
  std::vector<QuestionStroke> erased = typed(U"a\u3042");
  erased.push_back({Key::kBackspace});
  EXPECT_EQ(storedOf(json, erased), "a") << "a character, not a byte";
}

TEST(QuestionKinds, AMatrixHasAnAnswerForEachRow) {
  std::vector<std::string> names;
  for (const QuestionItem& item : itemsOf({questionExample(questionExamples()[8])})) {
    names.push_back(item.name);
  }
  EXPECT_THAT(names, ElementsAre("symptoms_head", "symptoms_eyes"));
}

TEST(QuestionKinds, WhatCannotBeIsRefused) {
  const auto errorOf = [](const std::string& json) {
    return outlineErrorOf(json, ProtocolReading::kByStudy, [](JsonFields& fields, ProtocolReading reading) {
      FormField field = readFormField(fields, defaultConditions(), reading);
      fields.rejectUnknown();
      return field;
    });
  };
  EXPECT_THAT(errorOf(R"({"name": "a", "question": "?", "kind": "essay"})"), HasSubstr("\"kind\" must be one of"));
  EXPECT_THAT(errorOf(R"({"name": "a", "question": "?", "kind": "slider"})"), HasSubstr("\"ends\""));
  EXPECT_THAT(errorOf(R"({"name": "a", "question": "?", "kind": "slider", "ends": ["a", "b"], "step": 7})"),
              HasSubstr("\"step\" must divide"));
  EXPECT_THAT(errorOf(R"({"name": "a", "question": "?", "kind": "number", "least": 3, "most": 3})"),
              HasSubstr("\"most\" must be more"));
  EXPECT_THAT(errorOf(R"({"name": "a", "question": "?", "options": ["x", "y"], "values": [1, 1]})"),
              HasSubstr("\"values\" must be different"));
  EXPECT_THAT(errorOf(R"({"name": "a", "question": "?", "kind": "matrix", "options": ["x", "y"], "rows": []})"),
              HasSubstr("\"rows\""));
  EXPECT_THAT(errorOf(R"({"name": "a", "question": "?", "kind": "text", "options": ["x", "y"]})"),
              HasSubstr("\"options\""));
  EXPECT_THAT(errorOf(R"({"name": "a", "question": "?", "kind": "text", "favors": ["ppc", "gc"]})"),
              HasSubstr("\"favors\""));
}

TEST(QuestionKinds, AnUnknownKindIsATextToAnAnalysis) {
  const FormField field = readOutline(
      R"({"name": "a", "question": "?", "kind": "drawing"})", ProtocolReading::kByAnalysis,
      [](JsonFields& fields, ProtocolReading reading) { return readFormField(fields, defaultConditions(), reading); });
  EXPECT_EQ(questionKind(field.kind).value, QuestionValue::kText);
}

}  // namespace
}  // namespace ocelli::test
