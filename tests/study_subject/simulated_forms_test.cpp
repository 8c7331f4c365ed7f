// Simulated subjects fill in questions of all kinds, by keys and typing alone, on screens of both directions.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <map>
#include <nlohmann/json.hpp>

#include "oc_core/base/file_bytes.h"
#include "study/outline/question_kinds.h"
#include "study/store/study_database.h"
#include "tests/base/temporary_folder.h"
#include "tests/study_subject/simulated_sessions.h"

namespace ocelli {
namespace {

Protocol questions(const std::string& language) {
  nlohmann::json json = nlohmann::json::parse(readFile(OCELLI_SOURCE_DIR "/protocols/questions.json", 1'000'000));
  json["language"] = language;
  return protocolFromJsonText(json.dump(), "questions");
}

class SimulatedForms : public testing::TestWithParam<std::tuple<std::string, SubjectKind>> {};

TEST_P(SimulatedForms, everyQuestionHasAnAnswerOfItsType) {
  const auto& [language, kind] = GetParam();
  const Protocol protocol = questions(language);
  const test::TemporaryFolder folder;
  SimulationPlan plan = test::observers(1);
  plan.kind = kind;
  simulateStudy(protocol, folder / "forms.db", plan);
  const StudyDatabase database = StudyDatabase::openForReading(folder / "forms.db");
  const StoredSubject subject = database.subjects().front();
  EXPECT_EQ(database.session(subject.id, 1)->ending, SessionEnding::kCompleted);
  std::map<std::pair<std::string, std::string>, std::string> answers;
  for (const StoredAnswer& answer : database.answers(subject.id)) {
    EXPECT_TRUE(answers.emplace(std::pair(answer.record.form, answer.record.field), answer.record.answer).second)
        << "asked twice: " << answer.record.form << ", " << answer.record.field;
  }
  size_t asked = 0;
  for (const ProtocolForm* form : formsOf(protocol)) {
    for (const QuestionItem& item : itemsOf(form->fields)) {
      ++asked;
      const FormField& field = form->fields[static_cast<size_t>(item.field)];
      ASSERT_TRUE(answers.contains({form->name, item.name})) << form->name << ", " << item.name;
      const std::string& answer = answers[{form->name, item.name}];
      if (questionKind(field.kind).value == QuestionValue::kNumber) {
        EXPECT_GE(std::stod(answer), field.least) << item.name;
        EXPECT_LE(std::stod(answer), field.most) << item.name;
      } else if (questionKind(field.kind).value == QuestionValue::kOption) {
        EXPECT_THAT(storedOptions(field), testing::Contains(answer)) << "the same in all languages";
      } else {
        EXPECT_FALSE(answer.empty());
      }
    }
  }
  EXPECT_EQ(answers.size(), asked);
  EXPECT_TRUE(answers.contains({"ssq before", "symptoms_nausea"}));
  EXPECT_TRUE(answers.contains({"nasa-tlx after nearer", "mental"}));
  EXPECT_TRUE(answers.contains({"sus after", "statements_easy"}));
}

INSTANTIATE_TEST_SUITE_P(Languages, SimulatedForms,
                         testing::Combine(testing::Values("en", "ar"),
                                          testing::Values(SubjectKind::kObserver, SubjectKind::kGenerator)),
                         [](const auto& test) {
                           return std::get<0>(test.param) + "_" + nameOf(std::get<1>(test.param));
                         });

}  // namespace
}  // namespace ocelli
