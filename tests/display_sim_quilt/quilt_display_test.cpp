#include "display_sim/quilt/quilt_display.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "oc_core/base/error.h"
#include "oc_core/base/file_bytes.h"

namespace ocelli {
namespace {

using testing::HasSubstr;

std::string errorOf(const std::function<void()>& work) {
  try {
    work();
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

TEST(QuiltDisplay, tilesAreAsTheMakerPublishesThem) {
  const QuiltDisplay portrait = loadQuiltDisplay("portrait");
  EXPECT_EQ(portrait.viewCount(), 48);
  EXPECT_EQ(portrait.tileWidth(), 420);
  EXPECT_EQ(portrait.tileHeight(), 560);
  EXPECT_EQ(portrait.pixelAspect(), 1);
  const QuiltDisplay go = loadQuiltDisplay("go");
  EXPECT_EQ(go.tileWidth() * go.columns, go.width);
  EXPECT_EQ(go.tileHeight() * go.rows, go.height);
  // 372 x 682 pixels for 0.5625: they are a little wider than high.
  EXPECT_NEAR(go.pixelAspect(), 0.5625 * 682 / 372, 1e-12);
}

TEST(QuiltDisplay, everyRowIsValidAndHasAName) {
  EXPECT_GE(quiltDisplays().size(), 8u);
  for (const QuiltDisplay& display : quiltDisplays()) {
    EXPECT_NO_THROW(validate(display, display.name));
    EXPECT_EQ(loadQuiltDisplay(display.name), display);
    EXPECT_EQ(quiltDisplayFromJsonText(jsonText(display), "text"), display);
  }
}

TEST(QuiltDisplay, viewZeroLiesAtTheBottomLeftAndTheLastAtTheTopRight) {
  const QuiltDisplay display{"d", 4, 3, 402, 304, 1, 40};  // tiles of 100 x 101, 2 columns and 1 row left over
  EXPECT_EQ(tileOriginOf(display, 0), glm::ivec2(0, 304 - 101));
  EXPECT_EQ(tileOriginOf(display, 3), glm::ivec2(300, 304 - 101));
  EXPECT_EQ(tileOriginOf(display, 4), glm::ivec2(0, 304 - 202));
  EXPECT_EQ(tileOriginOf(display, 11), glm::ivec2(300, 1));
}

TEST(QuiltDisplay, anUnknownNameListsTheOthers) {
  EXPECT_THAT(errorOf([] { loadQuiltDisplay("huge"); }), AllOf(HasSubstr("huge"), HasSubstr("go, portrait, 16")));
}

TEST(QuiltDisplay, fieldsAreChecked) {
  const auto read = [](const std::string& text) {
    return errorOf([&] { quiltDisplayFromJsonText(text, "mine.json"); });
  };
  const std::string start = R"({"name": "mine", "columns": 5, "rows": 9, "width": 4096, "height": 4096)";
  EXPECT_EQ(read(start + R"(, "aspect": 1.5})"), "");
  EXPECT_EQ(quiltDisplayFromJsonText(start + R"(, "aspect": 1.5})", "mine.json").coneDegrees, 40);
  EXPECT_THAT(read(start + "}"), HasSubstr("aspect"));
  EXPECT_THAT(read(start + R"(, "aspect": 1.5, "cone": 3})"), HasSubstr("cone"));
  EXPECT_THAT(read(start + R"(, "aspect": 1.5, "cone_degrees": 170})"), HasSubstr("cone_degrees"));
  EXPECT_THAT(read(R"({"name": "one", "columns": 1, "rows": 1, "width": 9, "height": 9, "aspect": 1})"),
              HasSubstr("two views"));
  EXPECT_THAT(read(R"({"name": "thin", "columns": 64, "rows": 1, "width": 9, "height": 9, "aspect": 1})"),
              HasSubstr("no pixel"));
}

TEST(QuiltDisplay, theSchemaIsThatOfTheTable) {
  const std::string file = OCELLI_SOURCE_DIR "/display_sim/quilt/quilt_display.schema.json";
  EXPECT_EQ(readFile(file), quiltDisplaySchemaText()) << "write the text above to " << file;
}

TEST(QuiltDisplay, namesOfFilesSayWhatTheQuiltIs) {
  const QuiltDisplay display = loadQuiltDisplay("portrait");
  EXPECT_EQ(quiltFileName("a/statues.png", display), "a/statues_qs8x6a0.75.png");
  EXPECT_EQ(quiltFileName("a/statues_qs8x6a0.75.png", display), "a/statues_qs8x6a0.75.png");
  EXPECT_EQ(quiltFileName("a.b/statues", display), "a.b/statues_qs8x6a0.75");
  EXPECT_EQ(quiltFileName("a_qsort.mp4", display), "a_qsort_qs8x6a0.75.mp4");
  EXPECT_EQ(quiltSuffix(loadQuiltDisplay("16")), "_qs7x7a1.777");
  EXPECT_THAT(errorOf([&] { quiltFileName("statues_qs11x6a0.5625.png", display); }),
              AllOf(HasSubstr("another quilt"), HasSubstr("_qs8x6a0.75")));
}

TEST(QuiltDisplay, aProgramAddsItsOwn) {
  registerQuiltDisplay({"of-the-test", 2, 1, 20, 10, 1, 10});
  EXPECT_EQ(loadQuiltDisplay("of-the-test").viewCount(), 2);
  EXPECT_THROW(registerQuiltDisplay({"of-the-test", 2, 1, 20, 10, 1, 10}), InputError);
}

}  // namespace
}  // namespace ocelli
