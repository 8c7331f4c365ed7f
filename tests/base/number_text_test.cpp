#include "oc_core/base/number_text.h"

#include <gtest/gtest.h>

#include <cstdint>

namespace ocelli {
namespace {

TEST(NumberText, IsTheWholeOfAText) {
  EXPECT_EQ(numberFromText<int>("-12"), -12);
  EXPECT_EQ(numberFromText<double>("2.5e3"), 2500);
  for (const char* text : {"", " 1", "1 ", "4 or 5", "+1", "0x10", "one"}) {
    EXPECT_FALSE(numberFromText<int>(text)) << text;
    EXPECT_FALSE(numberFromText<double>(text)) << text;
  }
}

TEST(NumberText, FitsItsType) {
  EXPECT_EQ(numberFromText<uint16_t>("65535"), 65535);
  EXPECT_FALSE(numberFromText<uint16_t>("65536"));
  EXPECT_FALSE(numberFromText<uint16_t>("-1"));
  EXPECT_FALSE(numberFromText<int>("1.5"));
  for (const char* text : {"nan", "inf", "-inf", "1e999"}) {
    EXPECT_FALSE(numberFromText<double>(text)) << text;
  }
}

}  // namespace
}  // namespace ocelli
