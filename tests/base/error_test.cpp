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

TEST(Error, KindsAreDistinct) {
  // Exit codes 2 and 1 hang on it.
  EXPECT_THROW(throw InputError("a", "", ""), InputError);
  EXPECT_FALSE((std::is_base_of_v<InputError, WorkError> || std::is_base_of_v<WorkError, InputError>));
}

}  // namespace
}  // namespace ocelli
