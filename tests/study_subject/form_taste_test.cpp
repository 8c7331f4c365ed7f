#include "study/subject/form_taste.h"

#include <gtest/gtest.h>

namespace ocelli {
namespace {

Protocol protocolWithForms() {
  Protocol protocol;
  ProtocolForm survey;
  survey.name = "survey";
  survey.fields.push_back(
      {"find", "Which was easier for finding the object?", {"1", "2", "3", "4", "5"}, {"plain view", "bent view"}});
  survey.fields.push_back({"find_reversed", "find", {"1", "2", "3", "4", "5"}, {"bent view", "plain view"}});
  survey.fields.push_back({"vision", "How is your vision?", {"colour-blind", "normal", "corrected"}});
  survey.fields.push_back(
      {"find_unlabelled", "find", {"1", "2", "3", "4"}, {}, {TrialView::kOther, TrialView::kReference}});
  protocol.survey = survey;
  protocol.exclusions.push_back({"form:vision", ExclusionTest::kIs, "colour-blind", 0, "colours matter"});
  return protocol;
}

Experience findTimes(double pinhole, double graph) {
  Experience experience;
  experience["find"][0].add(std::log(pinhole));
  experience["find"][1].add(std::log(graph));
  return experience;
}

TEST(FormTaste, answersScalesByExperience) {
  const Protocol protocol = protocolWithForms();
  Random random(1);
  const auto answer = [&](int field, double pinhole, double graph) {
    return optionOf(protocol, *protocol.survey, field, findTimes(pinhole, graph), random);
  };
  EXPECT_EQ(answer(0, 20, 10), 4);
  EXPECT_EQ(answer(0, 10, 20), 0);
  EXPECT_EQ(answer(0, 10, 10), 2);
  EXPECT_EQ(answer(1, 20, 10), 0) << "the ends are the other way round";
  EXPECT_EQ(answer(3, 20, 10), 0) << "as the protocol says, without words";
  EXPECT_EQ(answer(3, 10, 20), 3);
}

TEST(FormTaste, isNotExcludedForItsVision) {
  const Protocol protocol = protocolWithForms();
  Random random(1);
  for (int i = 0; i < 20; ++i) {
    EXPECT_EQ(optionOf(protocol, *protocol.survey, 2, {}, random), 1);
  }
}

TEST(FormTaste, answersAtRandomWhereItHasNoExperience) {
  const Protocol protocol = protocolWithForms();
  Random random(1);
  std::array<int, 5> counts{};
  for (int i = 0; i < 500; ++i) {
    ++counts[static_cast<size_t>(optionOf(protocol, *protocol.survey, 0, {}, random))];
  }
  for (const int count : counts) {
    EXPECT_NEAR(count, 100, 40);  // more than four standard deviations
  }
}

}  // namespace
}  // namespace ocelli
