#include "oc_core/base/error.h"

#include <gtest/gtest.h>

namespace ocelli {
namespace {

TEST(Error, SaysWhatWhereAndWhatNext) {
  EXPECT_STREQ(InputError("is empty", "a.ply:3", "export it again").what(),
               "a.ply:3: is empty\n  try: export it again");
}

TEST(Error, LeavesOutWhatIsNotKnown) {
  EXPECT_STREQ(WorkError("the disk is full", "", "").what(), "the disk is full");
}

TEST(Error, ShowsNoControlCharacters) {
  const std::string keyword("a\0b\x1b[2J", 7);
  EXPECT_STREQ(InputError("no '" + keyword + "'", "a.ply", "").what(), "a.ply: no 'a?b?[2J'");
}

TEST(Error, WhatStandsInAFileCannotAddLines) {
  const std::string hostile = "S01\n  try: something else\x7f";
  EXPECT_STREQ(InputError("no \"" + hostile + "\"", hostile, "b").what(),
               "S01?  try: something else?: no \"S01?  try: something else?\"\n  try: b");
  EXPECT_LT(std::string(InputError(std::string(100000, 'x'), std::string(100000, 'y'), "").what()).size(), 3000u);
}

TEST(Error, DetailsAreLinesBelow) {
  EXPECT_STREQ(WorkError("two do not work:", "here", "a third", "one: no\x1b\ntwo: no").what(),
               "here: two do not work:\n    one: no?\n    two: no\n  try: a third");
}

TEST(Error, TellsItsPartsOneByOne) {
  const WorkError error("two do\nnot work:", "here\x1b", "a third", "one: no\ntwo: no");
  const WorkError copy = error;
  EXPECT_EQ(copy.parts().problem, "two do?not work:");
  EXPECT_EQ(copy.parts().where, "here?");
  EXPECT_EQ(copy.parts().next, "a third");
  EXPECT_EQ(copy.parts().details, "one: no\ntwo: no");
}

TEST(Error, KindsAreDistinct) {
  // Exit codes 2 and 1 hang on it.
  EXPECT_THROW(throw InputError("a", "", ""), InputError);
  EXPECT_FALSE((std::is_base_of_v<InputError, WorkError> || std::is_base_of_v<WorkError, InputError>));
}

}  // namespace
}  // namespace ocelli
