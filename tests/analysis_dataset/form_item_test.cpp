#include "analysis/dataset/form_item.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "analysis/dataset/database.h"
#include "analysis/dataset/merge.h"
#include "analysis/dataset/protocol_facts.h"
#include "tests/analysis_dataset/sample_study.h"

namespace ocelli::test {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

/// A protocol whose survey has these fields.
std::string protocolWith(const std::string& fields) {
  return R"({"name": "forms", "title": "Forms", "blocks": [], "survey": {"title": "Survey", "fields": [)" + fields +
         "]}}";
}

FormItem itemOf(const std::string& field) {
  const ProtocolFacts facts = protocolFacts(protocolWith(field), "forms.json");
  EXPECT_EQ(facts.items.size(), 1U);
  return facts.items.at(0);
}

TEST(FormItem, HasTheScaleOfTheProtocol) {
  const FormItem seven = itemOf(R"({"name": "tired", "question": "How tired are you?",
    "options": ["1", "2", "3", "4", "5", "6", "7"], "ends": ["not at all", "very"]})");
  EXPECT_EQ(seven.form, "survey");
  EXPECT_EQ(seven.label(), "How tired are you?");
  EXPECT_TRUE(seven.isScale());
  EXPECT_FALSE(seven.comparesViews());
  EXPECT_EQ(seven.steps(), 7);
  EXPECT_EQ(seven.middle(), 4);
  EXPECT_EQ(seven.placeOf("6"), 6);
  EXPECT_EQ(seven.placeOf("7"), 7);
  EXPECT_FALSE(seven.placeOf("8"));
  EXPECT_FALSE(seven.placeOf("6.0")) << "not as the option is written";
  EXPECT_EQ(seven.scaleText(), "1 (not at all) to 7 (very)");
}

TEST(FormItem, HasNumbersOfItsOwnWhereOptionsAreNumbersAtEqualDistances) {
  const FormItem down = itemOf(R"({"name": "a", "question": "?", "options": ["2", "1", "0", "-1", "-2"]})");
  EXPECT_TRUE(down.isScale()) << "unlabelled";
  EXPECT_EQ(down.numberAt(1), 2);
  EXPECT_EQ(down.numberAt(4.5), -1.5);
  const FormItem uneven = itemOf(R"({"name": "a", "question": "?", "options": ["1", "2", "5"], "ends": ["x", "y"]})");
  EXPECT_EQ(uneven.numberAt(3), 3) << "a place";
  EXPECT_EQ(uneven.scaleText(), "1 (x) to 3 (y)");
}

TEST(FormItem, WordsWithoutEndsAreNoScale) {
  const FormItem words = itemOf(R"({"name": "a", "question": "?", "options": ["glasses", "lenses", "none"]})");
  EXPECT_FALSE(words.isScale());
  EXPECT_FALSE(words.comparesViews());
  const FormItem four = itemOf(R"({"name": "a", "question": "?", "options": ["never", "rarely", "often", "always"],
    "ends": ["less", "more"]})");
  EXPECT_TRUE(four.isScale());
  EXPECT_EQ(four.middle(), 2.5);
  const FormItem any = itemOf(R"({"name": "a", "question": "What else?"})");
  EXPECT_FALSE(any.isScale());
  EXPECT_EQ(any.scaleText(), "any text");
}

TEST(FormItem, ComparesTheViewsWhereTheProtocolSaysSo) {
  const char* const kField =
      R"({"name": "a", "question": "?", "options": ["1", "2", "3"], "ends": [%s], "favors": %s})";
  const auto favored = [&](const std::string& ends, const std::string& favors) {
    std::string text = kField;
    text.replace(text.find("%s"), 2, ends);
    text.replace(text.find("%s"), 2, favors);
    return itemOf(text).lastFavors;
  };
  EXPECT_EQ(favored(R"("this", "that")", R"(["ppc", "gc"])"), TrialView::kOther);
  // What the protocol says counts, not the words.
  EXPECT_EQ(favored(R"("plain", "bent")", R"(["gc", "ppc"])"), TrialView::kReference);
  EXPECT_THAT(analysisErrorOf([&] { favored(R"("a", "b")", R"(["gc", "gc"])"); }), HasSubstr("favors"));
}

TEST(FormItem, TakesTheWordsOfOldProtocols) {
  const auto favoredByEnds = [](const std::vector<std::string>& ends) {
    return viewFavoredByLastEnd(ends, defaultConditions());
  };
  EXPECT_EQ(favoredByEnds({"plain view easier", "bent view easier"}), TrialView::kOther);
  EXPECT_EQ(favoredByEnds({"Graph camera", "Pinhole"}), TrialView::kReference);
  EXPECT_EQ(favoredByEnds({"ppc", "gc"}), TrialView::kOther);
  EXPECT_FALSE(favoredByEnds({"not at all", "very"}));
  EXPECT_FALSE(favoredByEnds({"plain", "plain and bent"})) << "both in one end";
  EXPECT_FALSE(favoredByEnds({"explain", "paragraph"})) << "words, not parts of them";
  EXPECT_FALSE(favoredByEnds({}));
  EXPECT_TRUE(
      itemOf(R"({"name": "a", "question": "?", "options": ["1", "2"], "ends": ["plain", "bent"]})").favorsFromWords);
}

struct Answers : ::testing::Test {
  SampleFolder folder;
  Dataset data;

  /// The survey of subjects S1, S2, ..., one answer each.
  std::vector<ItemAnswers> answered(const std::string& fields, const std::vector<std::string>& answers) {
    const std::string path = folder.file("study.db");
    SampleStudy study(path, protocolWith(fields));
    for (size_t i = 0; i < answers.size(); ++i) {
      const std::string subject = std::string("S").append(std::to_string(i + 1));
      study.addSubject(subject);
      study.addSession(subject, 1);
      study.addAnswer(subject, "survey", "tired", answers[i]);
    }
    data = merge({readDatabase(path)});
    return answersToForm(data, "survey");
  }
};

TEST_F(Answers, OfSevenStepsAreAllThere) {
  const auto items = answered(R"({"name": "tired", "question": "?", "options": ["1", "2", "3", "4", "5", "6", "7"]})",
                              {"1", "6", "7", "7"});
  ASSERT_EQ(items.size(), 1U);
  std::vector<int> places;
  for (const ItemAnswers::Answer& answer : items[0].answers) {
    places.push_back(answer.place);
  }
  EXPECT_THAT(places, ElementsAre(1, 6, 7, 7));
  EXPECT_THAT(items[0].notOptions, IsEmpty());
}

TEST_F(Answers, ThatAreNoOptionsAreNamed) {
  const auto items = answered(R"({"name": "tired", "question": "?", "options": ["1", "2", "3"]})", {"1", "6", "", "3"});
  ASSERT_EQ(items.size(), 1U);
  EXPECT_EQ(items[0].answers.size(), 2U);
  ASSERT_EQ(items[0].notOptions.size(), 2U);
  EXPECT_EQ(items[0].notOptions[0]->answer, "6");
}

TEST_F(Answers, ToQuestionsThatNoProtocolHasStandAlone) {
  const auto items = answered(R"({"name": "other", "question": "?", "options": ["1", "2"]})", {"1", "6"});
  ASSERT_EQ(items.size(), 1U);
  EXPECT_FALSE(items[0].item.isInProtocol());
  EXPECT_EQ(items[0].item.label(), "tired");
  EXPECT_EQ(items[0].answers.size(), 2U);
}

TEST_F(Answers, OfTheLastSessionCount) {
  const std::string path = folder.file("study.db");
  SampleStudy study(path, protocolWith(R"({"name": "tired", "question": "?", "options": ["1", "2", "3"]})"));
  study.addSubject("S1");
  for (const int session : {1, 2}) {
    study.addSession("S1", session);
    study.addAnswer("S1", "survey", "tired", session == 1 ? "1" : "3", session);
  }
  data = merge({readDatabase(path)});
  const auto items = answersToForm(data, "survey");
  ASSERT_EQ(items.at(0).answers.size(), 1U);
  EXPECT_EQ(items[0].answers[0].place, 3);
}

}  // namespace
}  // namespace ocelli::test
