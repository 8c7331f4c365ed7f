#include "study/outline/block_outline.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/study_outline/outline_text.h"

namespace ocelli::test {
namespace {

using testing::HasSubstr;

constexpr ProtocolReading kStudy = ProtocolReading::kByStudy;
constexpr ProtocolReading kAnalysis = ProtocolReading::kByAnalysis;

TEST(BlockOutline, IsTheSameToBoth) {
  for (const ProtocolReading reading : kBothReadings) {
    const BlockOutline block = readOutline(
        R"({"name": "find it", "title": "Find", "task": "find", "views": "one", "practice": {"least_correct": 3}})",
        reading, readBlockOutline);
    EXPECT_EQ(block.name, "find it");
    EXPECT_EQ(block.title, "Find");
    EXPECT_EQ(block.task, "find");
    EXPECT_EQ(block.views, ViewsOfCases::kOne);
    ASSERT_TRUE(block.practice.has_value());
    EXPECT_EQ(block.practice->minCorrect, 3);
    const BlockOutline least = readOutline(R"({"name": "b", "title": "B", "task": "t"})", reading, readBlockOutline);
    EXPECT_EQ(least.views, ViewsOfCases::kAll);
    EXPECT_FALSE(least.practice.has_value());
    EXPECT_THAT(outlineErrorOf("{\"name\": \"b\",\n\"task\": 3, \"title\": \"B\"}", reading, readBlockOutline),
                HasSubstr("p.json:2 (b): field \"task\" must be a text"));
  }
}

TEST(BlockOutline, IsStrictToAStudyAlone) {
  const char* const wrong[] = {
      R"({"name": "a_b", "title": "B", "task": "t"})",
      R"({"name": "b", "task": "t"})",
      R"({"name": "b", "title": "B", "task": "t", "views": "three"})",
      R"({"name": "b", "title": "B", "task": "t", "practice": {"least_correct": 101}})",
      R"({"name": "b", "title": "B", "task": "t", "practice": {"least_correct": 3, "most_trials": 2}})",
      R"({"name": "b", "title": "B", "task": "t", "practice": {"most_minutes": 2}})",
  };
  for (const char* text : wrong) {
    EXPECT_NE(outlineErrorOf(text, kStudy, readBlockOutline), "") << text;
    EXPECT_EQ(outlineErrorOf(text, kAnalysis, readBlockOutline), "") << text;
  }
  EXPECT_EQ(readOutline(wrong[1], kAnalysis, readBlockOutline).title, "b") << "its name";
}

}  // namespace
}  // namespace ocelli::test
