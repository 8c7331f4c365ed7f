// Questionnaires: the files can be read, and their scores are those of the published formulas, worked by hand.
#include "study/outline/questionnaire.h"

#include <gtest/gtest.h>

#include "study/outline/question_kinds.h"

namespace ocelli::test {
namespace {

Questionnaire named(const std::string& name) {
  return findQuestionnaire(name, "en").value();
}

double score(const Questionnaire& of, const std::string& name, const std::map<std::string, double>& answers) {
  for (const QuestionnaireScore& each : of.scores) {
    if (each.name == name) {
      return scoreOf(each, answers).value();
    }
  }
  ADD_FAILURE() << "no score " << name;
  return 0;
}

/// All items with the same answer.
std::map<std::string, double> all(const Questionnaire& of, double answer) {
  std::map<std::string, double> answers;
  for (const QuestionItem& item : itemsOf(of.form.fields)) {
    answers[item.name] = answer;
  }
  return answers;
}

constexpr double kRounding = 1e-9;  // of sums of a few decimal fractions

TEST(Questionnaires, CanBeReadInAllLanguages) {
  EXPECT_EQ(questionnaireNames().size(), 3u);
  for (const std::string& name : questionnaireNames()) {
    for (const SubjectCatalogue& language : subjectCatalogues()) {
      const auto read = findQuestionnaire(name, language.language);
      ASSERT_TRUE(read);
      EXPECT_EQ(read->name, name);
      EXPECT_FALSE(read->source.empty());
    }
  }
  EXPECT_FALSE(findQuestionnaire("mood", "en"));
  EXPECT_NE(findQuestionnaire("sus", "de")->form.title, named("sus").form.title);
}

/// Kennedy et al. 1993, table 5: 7 symptoms count for each of three scales, and the total is of their sums.
TEST(Questionnaires, SsqIsWeightedAsPublished) {
  const Questionnaire ssq = named("ssq");
  EXPECT_EQ(itemsOf(ssq.form.fields).size(), 16u);
  const std::map<std::string, double> severe = all(ssq, 3);
  EXPECT_NEAR(score(ssq, "nausea", severe), 7 * 3 * 9.54, kRounding);           // 200.34
  EXPECT_NEAR(score(ssq, "oculomotor", severe), 7 * 3 * 7.58, kRounding);       // 159.18
  EXPECT_NEAR(score(ssq, "disorientation", severe), 7 * 3 * 13.92, kRounding);  // 292.32
  EXPECT_NEAR(score(ssq, "total", severe), 3 * 7 * 3 * 3.74, kRounding);        // 235.62
  // General discomfort 1 (N, O), nausea 2 (N, D), blurred sight 3 (O, D): N 3, O 4, D 5.
  std::map<std::string, double> some = all(ssq, 0);
  some["symptoms_discomfort"] = 1;
  some["symptoms_nausea"] = 2;
  some["symptoms_blurred"] = 3;
  EXPECT_NEAR(score(ssq, "nausea", some), 28.62, kRounding);
  EXPECT_NEAR(score(ssq, "oculomotor", some), 30.32, kRounding);
  EXPECT_NEAR(score(ssq, "disorientation", some), 69.6, kRounding);
  EXPECT_NEAR(score(ssq, "total", some), 44.88, kRounding);
}

/// Brooke 1996: odd items count their place less 1, even ones 5 less their place, all times 2.5.
TEST(Questionnaires, SusTurnsEveryOtherItem) {
  const Questionnaire sus = named("sus");
  const std::vector<QuestionItem> items = itemsOf(sus.form.fields);
  ASSERT_EQ(items.size(), 10u);
  std::map<std::string, double> best;
  std::map<std::string, double> mixed;
  const std::array<double, 10> given{4, 2, 5, 1, 3, 2, 4, 3, 4, 2};
  // (3 + 3 + 4 + 4 + 2 + 3 + 3 + 2 + 3 + 3) x 2.5 = 30 x 2.5
  for (size_t i = 0; i < items.size(); ++i) {
    best[items[i].name] = i % 2 == 0 ? 5 : 1;
    mixed[items[i].name] = given[i];
  }
  EXPECT_DOUBLE_EQ(score(sus, "score", best), 100);
  EXPECT_DOUBLE_EQ(score(sus, "score", mixed), 75);
  EXPECT_DOUBLE_EQ(score(sus, "score", all(sus, 3)), 50);
}

TEST(Questionnaires, RawTlxIsTheMeanOfSixScales) {
  const Questionnaire tlx = named("nasa-tlx");
  const std::vector<QuestionItem> items = itemsOf(tlx.form.fields);
  ASSERT_EQ(items.size(), 6u);
  for (const FormField& field : tlx.form.fields) {
    EXPECT_EQ(field.least, 0);
    EXPECT_EQ(field.most, 100);
    EXPECT_EQ(field.step, 5);
  }
  const std::map<std::string, double> answers{{"mental", 80},      {"physical", 10}, {"temporal", 55},
                                              {"performance", 25}, {"effort", 70},   {"frustration", 30}};
  EXPECT_NEAR(score(tlx, "raw", answers), 45, kRounding);  // 270 / 6
  EXPECT_DOUBLE_EQ(score(tlx, "effort", answers), 70);
}

TEST(Questionnaires, AMissingAnswerIsNotZero) {
  const Questionnaire ssq = named("ssq");
  std::map<std::string, double> answers = all(ssq, 1);
  answers.erase("symptoms_burping");
  for (const QuestionnaireScore& each : ssq.scores) {
    EXPECT_EQ(scoreOf(each, answers).has_value(), !each.weights.contains("symptoms_burping")) << each.name;
  }
}

TEST(Questionnaires, ScoresKeepTheirRange) {
  for (const std::string& name : questionnaireNames()) {
    const Questionnaire of = named(name);
    for (const QuestionnaireScore& each : of.scores) {
      double least = each.constant;
      double most = each.constant;
      for (const auto& [item, weight] : each.weights) {
        double low = 0;
        double high = 0;
        for (const QuestionItem& one : itemsOf(of.form.fields)) {
          const FormField& field = of.form.fields[static_cast<size_t>(one.field)];
          if (one.name == item) {
            const bool isNumber = questionKind(field.kind).value == QuestionValue::kNumber;
            low = isNumber ? field.least : std::stod(storedOptions(field).front());
            high = isNumber ? field.most : std::stod(storedOptions(field).back());
          }
        }
        least += weight * (weight > 0 ? low : high);
        most += weight * (weight > 0 ? high : low);
      }
      EXPECT_NEAR(each.factor * least / each.divisor, each.least, kRounding) << name << " " << each.name;
      EXPECT_NEAR(each.factor * most / each.divisor, each.most, kRounding) << name << " " << each.name;
    }
  }
}

}  // namespace
}  // namespace ocelli::test
