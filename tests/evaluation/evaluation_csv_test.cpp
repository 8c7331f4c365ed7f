#include "oc_core/evaluation/evaluation_csv.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <sstream>

namespace ocelli {
namespace {

using ::testing::ElementsAre;

/// The fields of each line, as RFC 4180 reads them.
std::vector<std::vector<std::string>> readCsv(const std::string& text) {
  std::vector<std::vector<std::string>> lines(1, {""});
  bool quoted = false;
  for (size_t i = 0; i < text.size(); ++i) {
    const char c = text[i];
    std::string& field = lines.back().back();
    if (quoted && c == '"' && i + 1 < text.size() && text[i + 1] == '"') {
      field += '"';
      ++i;
    } else if (c == '"') {
      quoted = !quoted;
    } else if (c == ',' && !quoted) {
      lines.back().emplace_back();
    } else if (c == '\n' && !quoted) {
      lines.push_back({""});
    } else {
      field += c;
    }
  }
  EXPECT_FALSE(quoted);
  EXPECT_THAT(lines.back(), ElementsAre("")) << "the last line ends with a line feed";
  lines.pop_back();
  return lines;
}

RepresentationFigures figures(const std::string& name) {
  RepresentationFigures row;
  row.name = name;
  row.triangles = 12;
  row.bytes = {1000, 100};
  row.buildMilliseconds = 1.5;
  row.edges.truth = 200;
  row.edges.strict = 50;
  row.edges.frame = 100;
  row.edges.falseSkin = 1;
  return row;
}

std::string fieldOf(const std::vector<std::vector<std::string>>& lines, size_t line, const std::string& column) {
  const auto found = std::find(lines[0].begin(), lines[0].end(), column);
  EXPECT_NE(found, lines[0].end()) << column;
  return lines[line][static_cast<size_t>(found - lines[0].begin())];
}

TEST(EvaluationCsv, hasALineForEachRepresentation) {
  const auto lines = readCsv(evaluationCsv({}, {figures("di"), figures("ddoc")}));
  ASSERT_EQ(lines.size(), 3u);
  EXPECT_EQ(lines[0].size(), lines[1].size());
  EXPECT_EQ(lines[0].size(), lines[2].size());
  EXPECT_EQ(fieldOf(lines, 1, "name"), "di");
  EXPECT_EQ(fieldOf(lines, 2, "name"), "ddoc");
  EXPECT_EQ(fieldOf(lines, 1, "triangles"), "12");
  EXPECT_EQ(fieldOf(lines, 1, "bytes_zstd"), "100");
  EXPECT_EQ(fieldOf(lines, 1, "build_ms"), "1.5");
  EXPECT_EQ(fieldOf(lines, 1, "missing_strict_edges"), "0.25");
  EXPECT_EQ(fieldOf(lines, 1, "false_skins_edges"), "0.01");
  EXPECT_EQ(fieldOf(lines, 1, "missing_strict_interior"), "0");
}

TEST(EvaluationCsv, leavesEmptyWhatWasNotMeasured) {
  RepresentationFigures row = figures("di");
  auto lines = readCsv(evaluationCsv({}, {row}));
  EXPECT_EQ(fieldOf(lines, 1, "slice_ms"), "");
  EXPECT_EQ(fieldOf(lines, 1, "psnr_db_edges"), "");
  row.edges.images = 2;
  row.edges.ssim = 2;
  EvaluationOptions options;
  options.slice = [](const Mesh&) {};
  lines = readCsv(evaluationCsv(options, {row}));
  EXPECT_EQ(fieldOf(lines, 1, "slice_ms"), "0");
  EXPECT_EQ(fieldOf(lines, 1, "psnr_db_edges"), "inf");
  EXPECT_EQ(fieldOf(lines, 1, "ssim_edges"), "1");
  EXPECT_EQ(fieldOf(lines, 1, "ssim_interior"), "");
}

TEST(EvaluationCsv, quotesWhatNeedsIt) {
  const std::string name = "my \"best\", of\ntwo";
  EXPECT_EQ(fieldOf(readCsv(evaluationCsv({}, {figures(name)})), 1, "name"), name);
  EXPECT_EQ(evaluationCsv({}, {figures("plain")}).find('"'), std::string::npos);
}

TEST(EvaluationCsv, withoutRowsHasItsHeader) {
  EXPECT_EQ(readCsv(evaluationCsv({}, {})).size(), 1u);
  EXPECT_EQ(readCsv(offsetsCsv({}, {})).size(), 1u);
}

TEST(OffsetsCsv, hasALineForEachDistance) {
  EvaluationOptions options;
  options.offsets = {0, 0.02f};
  RepresentationFigures row = figures("di");
  row.offsets = {FrameErrors{}, row.edges};
  const auto lines = readCsv(offsetsCsv(options, {row, row}));
  ASSERT_EQ(lines.size(), 5u);
  EXPECT_THAT(lines[0],
              ElementsAre("name", "half_sides", "missing_strict", "missing_thick", "wrong_front", "false_skins"));
  EXPECT_THAT(lines[2], ElementsAre("di", "0.02", "0.25", "0", "0", "0.01"));
}

// The corner at (-1, -1, -1) is where edges 0, 4 and 8 begin; edges have their midpoints as viewpoints 0 to 11.
TEST(SequencesCsv, hasALineForEachViewpointOfEachEdge) {
  RepresentationFigures row = figures("di");
  row.edgeViews = std::vector<FrameErrors>(20, row.edges);
  row.edgeViews[0].strict = 100;
  row.edgeViews[12].strict = 20;
  const auto lines = readCsv(sequencesCsv({}, {row}));
  ASSERT_EQ(lines.size(), 1u + 12 * 3);
  EXPECT_EQ(fieldOf(lines, 1, "name"), "di");
  EXPECT_EQ(fieldOf(lines, 1, "right"), "-1");
  EXPECT_EQ(fieldOf(lines, 2, "right"), "0");
  EXPECT_EQ(fieldOf(lines, 2, "backward"), "-1");
  for (size_t line = 1; line < lines.size(); ++line) {
    const std::string expected = line == 2 ? "0.5" : line == 1 || line == 13 || line == 25 ? "0.1" : "0.25";
    EXPECT_EQ(fieldOf(lines, line, "missing_strict"), expected) << line;
    EXPECT_EQ(fieldOf(lines, line, "edge"), std::to_string((line - 1) / 3));
    EXPECT_EQ(fieldOf(lines, line, "flip"), "") << "no images were compared";
  }
}

TEST(SequencesCsv, hasNoLinesForOtherCells) {
  EvaluationOptions options;
  options.cell.shape = ViewCell::Shape::kSphere;
  EXPECT_EQ(readCsv(sequencesCsv(options, {figures("di")})).size(), 1u);
}

}  // namespace
}  // namespace ocelli
