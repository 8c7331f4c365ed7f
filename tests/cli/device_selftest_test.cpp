// `ocelli device selftest`: the folder that it writes, and the images in it.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <glm/common.hpp>
#include <regex>

#include "display_driver/selftest/selftest_page.h"
#include "display_driver/selftest/test_patterns.h"
#include "display_sim/frames/svol_file.h"
#include "oc_core/image/png_file.h"
#include "tests/base/temporary_folder.h"
#include "tests/cli/run_program.h"
#include "tests/page/unstyled_classes.h"

namespace ocelli::test {
namespace {

using testing::HasSubstr;
using testing::Not;

std::vector<std::string> attributes(const std::string& html, const std::string& name) {
  std::vector<std::string> values;
  const std::regex attribute(" " + name + "=\"([^\"]*)\"");
  for (std::sregex_iterator it(html.begin(), html.end(), attribute), end; it != end; ++it) {
    values.push_back((*it)[1]);
  }
  return values;
}

TEST(DeviceSelftest, LeavesAPageWithImagesAndVolumes) {
  const TemporaryFolder folder;
  const std::string page = (folder / "my page").string();
  const ProgramResult result =
      runProgram("device selftest --profile test --pattern wedges dark axis -o '" + page + "'");
  ASSERT_EQ(result.exitCode, 0) << result.error;
  EXPECT_THAT(result.error, HasSubstr("3 patterns"));
  const std::string html = fileBytes(page + "/index.html");
  for (const std::string name : {"dark", "axis", "wedges"}) {
    EXPECT_EQ(readSvol(page + "/" + name + ".svol"), testPattern(name).volume(loadProfile("test")));
    EXPECT_THAT(html, HasSubstr("href=\"" + name + ".svol\""));
  }
  // Four eyes and a slice; of the dark pattern none.
  const std::vector<std::string> images = attributes(html, "src");
  size_t wrong = 0;
  for (const std::string name : {"dark", "axis", "wedges"}) {
    wrong += static_cast<size_t>(
        std::ranges::count_if(testPattern(name).wrong, [](const WrongLook& look) { return look.shown != nullptr; }));
  }
  EXPECT_EQ(images.size(), 2u * 5u + wrong);
  for (const std::string& image : images) {
    EXPECT_FALSE(readPng(page + "/" + image).empty());
  }
  EXPECT_THAT(unstyledClasses(html), testing::IsEmpty());
  EXPECT_THAT(undefinedProperties(html), testing::IsEmpty());
  // In the order of the checklist, not in that of the options.
  EXPECT_LT(html.find("id=\"dark\""), html.find("id=\"axis\""));
  EXPECT_LT(html.find("id=\"axis\""), html.find("id=\"wedges\""));
}

TEST(DeviceSelftest, AsksHowPatternsLookOnADevice) {
  const TemporaryFolder folder;
  const std::string answers = folder.write("answers", "y\nwhat?\nn  too \"dim\"\nb\ny\nq\n").string();
  const ProgramResult result =
      runProgram("device selftest --device file:'" + (folder / "shown.svol").string() +
                 "' --profile test --pattern dark axis phase -o '" + folder.path().string() + "' < '" + answers + "'");
  ASSERT_EQ(result.exitCode, 0) << result.error;
  // The second pattern is wrong, then looked at once more, and right; the third is not answered.
  EXPECT_THAT(result.output, HasSubstr("3/3"));
  EXPECT_EQ(fileBytes(folder / "verdicts.csv"),
            "pattern,verdict,note\n"
            "dark,right,\"\"\n"
            "axis,right,\"\"\n"
            "phase,not seen,\"\"\n");
  EXPECT_THAT(result.error, HasSubstr("2 right, 0 wrong, 1 not seen"));
  const std::string wrong = folder.write("wrong", "n  too \"dim\"\n").string();
  ASSERT_EQ(runProgram("device selftest --device null --profile test --pattern axis -o '" + folder.path().string() +
                       "' < '" + wrong + "'")
                .exitCode,
            0);
  EXPECT_EQ(fileBytes(folder / "verdicts.csv"),
            "pattern,verdict,note\n"
            "dark,right,\"\"\n"
            "axis,wrong,\"too \"\"dim\"\"\"\n"
            "phase,not seen,\"\"\n");
}

TEST(DeviceSelftest, AnEmptyLineIsNoAnswer) {
  const TemporaryFolder folder;
  const auto verdicts = [&](const std::string& answers) {
    const std::string file = folder.write("answers", answers).string();
    std::filesystem::remove(folder / "verdicts.csv");
    const ProgramResult result = runProgram("device selftest --device null --profile test --pattern dark axis -o '" +
                                            folder.path().string() + "' < '" + file + "'");
    EXPECT_EQ(result.exitCode, 0) << result.error;
    EXPECT_THAT(result.output, HasSubstr("y (it looks so), n (it does not), b (back) or q (quit)")) << answers;
    return fileBytes(folder / "verdicts.csv");
  };
  // The end of the answers keeps what was answered until then.
  EXPECT_EQ(verdicts("\n\n \n"), "pattern,verdict,note\ndark,not seen,\"\"\naxis,not seen,\"\"\n");
  EXPECT_EQ(verdicts("\nyes\n\nno top is missing"),
            "pattern,verdict,note\ndark,right,\"\"\naxis,wrong,\"top is missing\"\n");
  EXPECT_EQ(verdicts("yellow\nnothing\nN\nQ\n"), "pattern,verdict,note\ndark,wrong,\"\"\naxis,not seen,\"\"\n");
}

TEST(DeviceSelftest, AnswersWrongNames) {
  const ProgramResult pattern = runProgram("device selftest --pattern nothing");
  EXPECT_EQ(pattern.exitCode, 2);
  EXPECT_THAT(pattern.error, HasSubstr("orientation"));
  const ProgramResult profile = runProgram("device selftest --profile nothing");
  EXPECT_EQ(profile.exitCode, 2);
  EXPECT_THAT(profile.error, HasSubstr("nothing"));
}

TEST(DeviceSelftest, FailsWhereTheFolderCannotBeMade) {
  const TemporaryFolder folder;
  const std::string file = folder.write("file", "").string();
  const ProgramResult result = runProgram("device selftest --profile test --pattern dark -o '" + file + "'");
  EXPECT_EQ(result.exitCode, 1);
  EXPECT_THAT(result.error, HasSubstr(file));
}

TEST(DeviceSelftestPage, HasABoxForEachCheckAndARowForEachWrongLook) {
  std::vector<SelftestSection> sections;
  size_t boxes = 0;
  size_t rows = 0;
  for (const TestPattern& pattern : testPatterns()) {
    sections.push_back({&pattern,
                        pattern.name + ".svol",
                        {{pattern.name + ".png", "From <here>", 3, 3}},
                        std::vector<SelftestImage>(pattern.wrong.size())});
    sections.back().wrong[0] = {pattern.name + "-wrong.png", "From <here>", 3, 3};
    boxes += pattern.lookFor.size();
    rows += pattern.wrong.size();
  }
  DisplayProfile profile = loadProfile("vortex");
  profile.channelTiming = ChannelTiming::kInTurn;
  const std::string html = selftestPage(sections, profile, "1.2.3");
  const std::vector<std::string> types = attributes(html, "type");
  EXPECT_EQ(static_cast<size_t>(std::ranges::count(types, "checkbox")), boxes);
  const std::vector<std::string> scopes = attributes(html, "scope");
  EXPECT_EQ(static_cast<size_t>(std::ranges::count(scopes, "row")), rows);
  // Every link leads somewhere, every image says what it shows, and nothing comes from elsewhere.
  const std::vector<std::string> ids = attributes(html, "id");
  for (const std::string& link : attributes(html, "href")) {
    if (link.starts_with('#')) {
      EXPECT_THAT(ids, testing::Contains(link.substr(1)));
    }
  }
  EXPECT_THAT(attributes(html, "alt"), testing::Each(HasSubstr("From &lt;here&gt;")));
  EXPECT_THAT(html, Not(HasSubstr("http")));
  EXPECT_THAT(html, Not(HasSubstr("<script")));
  EXPECT_THAT(html, HasSubstr("1.2.3"));
  EXPECT_THAT(html, HasSubstr("in turns: seen from above"));
}

/// Where got, reference and difference of an image that has changed are left.
void leaveImages(const std::filesystem::path& folder, const std::string& name, const Image<Rgb8>& got,
                 const Image<Rgb8>& reference) {
  std::filesystem::create_directories(folder);
  writePng(folder / (name + "-got.png"), got);
  if (got.width() != reference.width() || got.height() != reference.height()) {
    return;
  }
  Image<Rgb8> difference(got.width(), got.height());
  for (size_t i = 0; i < got.size(); ++i) {
    difference[i] = Rgb8(glm::abs(glm::ivec3(got[i]) - glm::ivec3(reference[i])));
  }
  writePng(folder / (name + "-reference.png"), reference);
  writePng(folder / (name + "-difference.png"), difference);
}

// An image that changes on purpose: look at it, and copy NAME-got.png over the reference.
TEST(DeviceSelftestImages, LookAsTheyDid) {
  const TemporaryFolder folder;
  const std::filesystem::path references = OCELLI_SOURCE_DIR "/tests/cli/selftest_pictures";
  const std::filesystem::path changed = std::filesystem::temp_directory_path() / "ocelli-selftest-pictures";
  for (const std::string name : {"orientation", "wedges", "colours"}) {
    writeSelftestImages(testPattern(name).volume(loadProfile("test")), folder.path(), name, 96);
    for (const std::string place : {"front", "raised", "above"}) {
      const std::string file = name + "-" + place;
      const Image<Rgb8> got = readPng(folder / (file + ".png"));
      const std::filesystem::path path = references / (file + ".png");
      const Image<Rgb8> reference = std::filesystem::exists(path) ? readPng(path) : Image<Rgb8>();
      int most = 256;
      if (got.width() == reference.width() && got.height() == reference.height()) {
        most = 0;
        for (size_t i = 0; i < got.size(); ++i) {
          const glm::ivec3 apart = glm::abs(glm::ivec3(got[i]) - glm::ivec3(reference[i]));
          most = std::max({most, apart.r, apart.g, apart.b});
        }
      }
      // Light adds up in whole numbers; tones are floating point, which another compiler may round the other way.
      if (most > 1) {
        leaveImages(changed, file, got, reference);
      }
      EXPECT_LE(most, 1) << "see " << (changed / (file + "-*.png"));
    }
  }
}

}  // namespace
}  // namespace ocelli::test
