#include "study/screen/study_pieces.h"

#include <gtest/gtest.h>

namespace ocelli {
namespace {

TEST(PageChoices, areAKeyAndALabelEach) {
  const auto one = pageChoices("Enter: begin");
  ASSERT_EQ(one.size(), 1u);
  EXPECT_EQ(one[0].key, Key::kEnter);
  EXPECT_EQ(one[0].label, "Begin");

  const auto two = pageChoices("Enter: end the session    Escape: go on with it");
  ASSERT_EQ(two.size(), 2u);
  EXPECT_EQ(two[0].label, "End the session");
  EXPECT_EQ(two[1].key, Key::kEscape);
  EXPECT_EQ(two[1].label, "Go on with it");
}

TEST(PageChoices, takeWhatIsNoKeyForALabel) {
  const auto choices = pageChoices("Experimenter: Enter goes on");
  ASSERT_EQ(choices.size(), 1u);
  EXPECT_FALSE(choices[0].key);
  EXPECT_EQ(choices[0].label, "Experimenter: Enter goes on");
  EXPECT_TRUE(pageChoices("").empty());
  EXPECT_TRUE(pageChoices("   ").empty());
}

}  // namespace
}  // namespace ocelli
