#include "oc_core/base/printable_text.h"

#include <gtest/gtest.h>

namespace ocelli {
namespace {

TEST(PrintableText, leavesTextAsItIs) {
  for (const char* text : {"", "builtin:box", "a \\ b", "sch\xc3\xb6n \xc2\xa0\xe2\x82\xac \xf0\x9f\x91\x81"}) {
    EXPECT_EQ(printableText(text), text);
  }
}

TEST(PrintableText, escapesWhatWouldSteerATerminalOrBeginALine) {
  EXPECT_EQ(printableText(std::string_view("a\nb\r\t\0\x1b[2J\x7f", 11)), "a\\nb\\x0d\\t\\x00\\x1b[2J\\x7f");
  EXPECT_EQ(printableText("\xc2\x9b"
                          "2J"),
            "\\u009b2J")
      << "a control sequence in one character";
  EXPECT_EQ(printableText("\xc2"), "\xc2") << "cut";
}

}  // namespace
}  // namespace ocelli
