#include "oc_core/feeds_measure/errors_page.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "oc_core/base/file_bytes.h"
#include "tests/base/temporary_folder.h"

namespace ocelli {
namespace {

FeedsEvaluation madeEvaluation() {
  FeedsEvaluation evaluation;
  evaluation.frames = 4;
  evaluation.walkers.assign(2, {});
  for (size_t k = 0; k < evaluation.frames; ++k) {
    const WalkerFate second = k < 3 ? WalkerFate::kRight : WalkerFate::kMissing;
    evaluation.timeline.push_back({0.5 * static_cast<double>(k), {WalkerFate::kRight, second}, {10, 1, 3, 1}});
    ++evaluation.walkers[0][static_cast<size_t>(WalkerFate::kRight)];
    ++evaluation.walkers[1][static_cast<size_t>(second)];
  }
  evaluation.seams = {40, 4, 3, 1};
  evaluation.pictures = {{"missing-2-1.50s.png", WalkerFate::kMissing, 1, 1.5, 200, 80}};
  return evaluation;
}

TEST(ErrorsPage, SaysWhatHappenedAndWhen) {
  const std::string page = errorsPage(madeEvaluation(), "Errors of a <corridor>");
  EXPECT_THAT(page, testing::HasSubstr("Errors of a &lt;corridor&gt;"));
  EXPECT_THAT(page, testing::HasSubstr("<td>3<br><span class=\"soft\">75.0 %</span></td>"));
  EXPECT_THAT(page, testing::HasSubstr("<title>missing 1.50 to 1.50 s</title>"));
  EXPECT_THAT(page, testing::HasSubstr("<title>right 0.00 to 1.00 s</title>"));
  EXPECT_THAT(page, testing::HasSubstr("src=\"missing-2-1.50s.png\""));
  EXPECT_THAT(page, testing::HasSubstr("10.0 % of the border"));
  EXPECT_THAT(page, testing::Not(testing::HasSubstr("stitcher")));
  FeedsEvaluation stitched = madeEvaluation();
  stitched.stitcher.frames = 12;
  EXPECT_THAT(errorsPage(stitched, "x"), testing::HasSubstr("Of 12 frames it makes a picture of 0"));
  for (const char* outside : {"http:", "https:", "<script", "//"}) {
    EXPECT_THAT(page, testing::Not(testing::HasSubstr(outside)));
  }
}

TEST(ErrorsPage, IsWrittenWithoutErrorsToo) {
  const test::TemporaryFolder folder;
  writeErrorsPage({}, "Nothing", folder.path() / "page");
  EXPECT_THAT(readFile(folder.path() / "page" / "index.html"), testing::HasSubstr("No walker was anything but right."));
}

}  // namespace
}  // namespace ocelli
