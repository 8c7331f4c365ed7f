// Tables as RFC 4180 has them.
#include "oc_core/base/csv.h"

#include <gtest/gtest.h>

#include "oc_core/base/error.h"

namespace ocelli::test {
namespace {

TEST(CsvText, QuotesWhatNeedsIt) {
  EXPECT_EQ(csvText(""), "");
  EXPECT_EQ(csvText("plain text"), "plain text");
  EXPECT_EQ(csvText("a,b"), "\"a,b\"");
  EXPECT_EQ(csvText("say \"hello\""), "\"say \"\"hello\"\"\"");
  EXPECT_EQ(csvText("two\nlines"), "\"two\nlines\"");
  EXPECT_EQ(csvText("two\r\nlines"), "\"two\r\nlines\"");
}

TEST(CsvText, DisarmsFormulas) {
  EXPECT_EQ(csvText("=1+1"), "'=1+1");
  EXPECT_EQ(csvText("+1"), "'+1");
  EXPECT_EQ(csvText("-1"), "'-1");
  EXPECT_EQ(csvText("@SUM(A1)"), "'@SUM(A1)");
  EXPECT_EQ(csvText("\t=1"), "'\t=1");
  EXPECT_EQ(csvText("=HYPERLINK(\"x\",\"y\")"), "\"'=HYPERLINK(\"\"x\"\",\"\"y\"\")\"");
  EXPECT_EQ(csvText("1=1"), "1=1");
}

TEST(CsvText, IsUtf8WhateverComesIn) {
  const std::string replacement = "\xef\xbf\xbd";
  EXPECT_EQ(csvText("Gr\xc3\xbc\xc3\x9f"
                    "e \xe2\x82\xac \xf0\x9f\x98\x80"),
            "Gr\xc3\xbc\xc3\x9f"
            "e \xe2\x82\xac \xf0\x9f\x98\x80");
  EXPECT_EQ(csvText("\xfc"), replacement);                                      // Latin-1
  EXPECT_EQ(csvText("a\xc3"), "a" + replacement);                               // cut off
  EXPECT_EQ(csvText("\xc0\xaf"), replacement + replacement);                    // overlong
  EXPECT_EQ(csvText("\xed\xa0\x80"), replacement + replacement + replacement);  // half of a surrogate pair
  EXPECT_EQ(csvText("\xf4\x90\x80\x80"), replacement + replacement + replacement + replacement);  // past the last one
}

TEST(CsvText, ReadsWhatItWrites) {
  const std::vector<std::string> fields{"a,b", "say \"x\"", "two\r\nlines", "", "plain", "\xc3\xa4"};
  std::string line;
  for (const std::string& field : fields) {
    line.append(line.empty() ? "" : ",").append(csvText(field));
  }
  const auto lines = csvRows(line + "\r\nlast,line", "test");
  ASSERT_EQ(lines.size(), 2u);
  EXPECT_EQ(lines[0], fields);
  EXPECT_EQ(lines[1], (std::vector<std::string>{"last", "line"}));
  EXPECT_TRUE(csvRows("", "test").empty());
  EXPECT_EQ(csvRows("\n", "test").size(), 1u);
  EXPECT_EQ(csvRows("\xef\xbb\xbf"
                    "a,b",
                    "test"),
            (std::vector<std::vector<std::string>>{{"a", "b"}}));
}

TEST(Csv, TellsTheLineOfARow) {
  CsvReader reader("a,\"two\nlines\"\nb,c\n\"open", "test.csv");
  std::vector<std::string> fields;
  ASSERT_TRUE(reader.next(fields));
  EXPECT_EQ(reader.place(), "test.csv:1");
  ASSERT_TRUE(reader.next(fields));
  EXPECT_EQ(reader.place(), "test.csv:3");
  try {
    reader.next(fields);
    FAIL() << "an open quote was taken";
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find("test.csv:4"), std::string::npos) << error.what();
  }
}

TEST(Csv, TakesTheMarkOffWhatLooksLikeAFormula) {
  for (const char* text : {"=1+1", "-1", "@x", "'tis", "plain", "'"}) {
    EXPECT_EQ(textOfCsv(csvText(text)), text);
  }
}

}  // namespace
}  // namespace ocelli::test
