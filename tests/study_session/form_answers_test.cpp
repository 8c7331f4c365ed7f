#include "study/session/form_answers.h"

#include <gtest/gtest.h>

namespace ocelli {
namespace {

ProtocolForm twoFields() {
  return {"form", "A form", "", {{"color", "Which?", {"red", "green", "blue"}, {}}, {"size", "How?", {"1", "2"}, {}}}};
}

TEST(FormAnswers, arrowsMoveAndChoose) {
  const ProtocolForm form = twoFields();
  FormAnswers answers(form);
  EXPECT_FALSE(answers.press(Key::kUp));
  EXPECT_EQ(answers.screen().focus, 0);
  answers.press(Key::kRight);
  EXPECT_EQ(answers.screen().entries[0].chosen, std::vector<int>{0});
  answers.press(Key::kRight);
  answers.press(Key::kRight);
  answers.press(Key::kRight);  // no further
  EXPECT_EQ(answers.screen().entries[0].chosen, std::vector<int>{2});
  answers.press(Key::kLeft);
  EXPECT_EQ(answers.answer(0), "green");
  answers.press(Key::kDown);
  answers.press(Key::kLeft);  // from nothing to the last
  EXPECT_EQ(answers.answer(1), "2");
}

TEST(FormAnswers, digitsChoose) {
  const ProtocolForm form = twoFields();
  FormAnswers answers(form);
  answers.press(Key::k3);
  EXPECT_EQ(answers.answer(0), "blue");
  answers.press(Key::k4);  // no such option
  EXPECT_EQ(answers.answer(0), "blue");
}

TEST(FormAnswers, theButtonAsksForWhatIsMissing) {
  const ProtocolForm form = twoFields();
  FormAnswers answers(form);
  answers.press(Key::k1);
  answers.press(Key::kEnter);
  answers.press(Key::kEnter);
  EXPECT_EQ(answers.screen().focus, 2);
  EXPECT_FALSE(answers.press(Key::kEnter));
  EXPECT_TRUE(answers.screen().missing);
  EXPECT_EQ(answers.screen().focus, 1);
  answers.press(Key::k2);
  answers.press(Key::kEnter);
  EXPECT_TRUE(answers.press(Key::kEnter));
}

}  // namespace
}  // namespace ocelli
