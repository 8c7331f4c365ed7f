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

TEST(FormAnswers, textsAreTypedAndMayStayOpen) {
  ProtocolForm form = twoFields();
  form.fields.push_back({"remarks", "What else?"});
  form.fields.back().kind = "text";
  form.fields.back().required = false;
  FormAnswers answers(form);
  answers.type(U'x');  // nothing to be typed there
  answers.press(Key::k1);
  answers.press(Key::kEnter);
  answers.press(Key::k2);
  answers.press(Key::kEnter);
  EXPECT_EQ(answers.screen().focus, 2);
  answers.type(U'o');
  answers.type(U'k');
  answers.press(Key::kEnter);
  EXPECT_TRUE(answers.press(Key::kEnter));
  EXPECT_EQ(answers.answer(2), "ok");
  answers.press(Key::kUp);
  answers.press(Key::kBackspace);
  answers.press(Key::kBackspace);
  EXPECT_EQ(answers.answer(2), "") << "left open, and not 0 or the first option";
}

TEST(FormAnswers, aWrongNumberIsNoAnswer) {
  ProtocolForm form{"form", "A form", "", {{"age", "How old?"}}};
  form.fields[0].kind = "number";
  form.fields[0].least = 18;
  form.fields[0].required = false;
  FormAnswers answers(form);
  answers.type(U'7');
  answers.press(Key::kEnter);
  EXPECT_FALSE(answers.press(Key::kEnter)) << "also where the question may stay open";
  EXPECT_TRUE(answers.screen().missing);
  EXPECT_STREQ(problemOf(answers.screen(), 0)->text, "form_whole_number");
  answers.type(U'0');
  answers.press(Key::kEnter);
  EXPECT_TRUE(answers.press(Key::kEnter));
  EXPECT_EQ(answers.answer(0), "70");
}

TEST(FormAnswers, arrowsFollowTheScreen) {
  const ProtocolForm form = twoFields();
  FormAnswers answers(form, true);
  answers.press(Key::kLeft);  // on, where lines run to the left
  EXPECT_EQ(answers.answer(0), "red");
  answers.press(Key::kLeft);
  EXPECT_EQ(answers.answer(0), "green");
  answers.press(Key::kRight);
  EXPECT_EQ(answers.answer(0), "red");
}

TEST(FormAnswers, rowsOfAMatrixAreAnsweredOneByOne) {
  ProtocolForm form{"form", "A form", "", {{"rate", "How?", {"bad", "good"}}}};
  form.fields[0].kind = "matrix";
  form.fields[0].rows = {{"a", "Row A"}, {"b", "Row B"}};
  FormAnswers answers(form);
  answers.press(Key::k1);
  answers.press(Key::kDown);
  answers.click(1, {1});
  EXPECT_TRUE(answers.goOn());
  EXPECT_EQ(answers.answer(0), "bad");
  EXPECT_EQ(answers.answer(1), "good");
}

}  // namespace
}  // namespace ocelli
