#include "display_sim/frames/display_profile.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <set>
#include <sstream>

#include "oc_core/base/error.h"

namespace ocelli {
namespace {

using ::testing::HasSubstr;

const std::filesystem::path kProfileFolder = OCELLI_PROFILE_FOLDER;

std::string textOf(const std::filesystem::path& path) {
  std::ostringstream text;
  text << std::ifstream(path).rdbuf();
  return text.str();
}

TEST(DisplayProfile, presetsHoldThePublishedFigures) {
  const DisplayProfile perspecta = loadProfile("perspecta");
  EXPECT_EQ(perspecta.slicesPerHalfTurn, 198);
  EXPECT_EQ(perspecta.width, 768);
  EXPECT_EQ(perspecta.height, 768);
  EXPECT_DOUBLE_EQ(perspecta.radiusMetres, 5 * 0.0254);
  EXPECT_DOUBLE_EQ(perspecta.refreshHertz(), 24);
  EXPECT_DOUBLE_EQ(perspecta.viewingDistanceRadii(), 10);
  EXPECT_EQ(loadProfile("perspecta-99").slicesPerHalfTurn * 2, 198);
  const DisplayProfile vortex = loadProfile("vortex");
  EXPECT_EQ(vortex.width, 128);
  EXPECT_EQ(vortex.height, 64);
  EXPECT_EQ(vortex.height, vortex.width * vortex.halfHeightRadii) << "square pixels";
}

// The recipe of display_profile.h: a file in the folder and its name in the list, nothing else.
TEST(DisplayProfile, recipeHolds) {
  std::set<std::string> files;
  for (const auto& entry : std::filesystem::directory_iterator(kProfileFolder)) {
    if (entry.path().filename() != "display_profile.schema.json") {
      files.insert(entry.path().stem());
    }
  }
  const std::vector<std::string>& names = builtinProfileNames();
  EXPECT_EQ(files, std::set<std::string>(names.begin(), names.end()));
  for (const std::string& name : names) {
    EXPECT_EQ(loadProfile(name).name, name);
    EXPECT_EQ(loadProfile(name), readProfile(kProfileFolder / (name + ".json")));
  }
}

TEST(DisplayProfile, jsonTextReadsBackAsItself) {
  for (const std::string& name : builtinProfileNames()) {
    DisplayProfile profile = loadProfile(name);
    EXPECT_EQ(profileFromJsonText(jsonText(profile), "text"), profile);
    profile.secondHalfTurn = SecondHalfTurn::kOwn;
    EXPECT_EQ(profileFromJsonText(jsonText(profile), "text"), profile);
  }
}

TEST(DisplayProfile, schemaNamesEveryField) {
  const std::string schema = textOf(kProfileFolder / "display_profile.schema.json");
  std::istringstream text(jsonText(loadProfile("test")));
  for (std::string field; std::getline(text, field, '"') && std::getline(text, field, '"');) {
    if (field != "test" && field != "mirrored" && field != "together") {
      EXPECT_THAT(schema, HasSubstr("\"" + field + "\": {"));
    }
  }
}

TEST(DisplayProfile, ownSecondHalfTurnDoublesTheSlicesAndHalvesTheRefresh) {
  DisplayProfile profile = loadProfile("perspecta");
  profile.secondHalfTurn = SecondHalfTurn::kOwn;
  EXPECT_EQ(profile.storedSlices(), 396);
  EXPECT_DOUBLE_EQ(profile.refreshHertz(), 12);
}

struct BadProfile {
  const char* name;
  const char* field;    // part of the text of a good profile
  const char* edit;     // replaces it
  const char* message;  // names the field
};

void PrintTo(const BadProfile& profile, std::ostream* out) {
  *out << profile.name;
}

class BadProfiles : public ::testing::TestWithParam<BadProfile> {};

TEST_P(BadProfiles, areInputErrorsThatNameTheField) {
  std::string text = jsonText(loadProfile("test"));
  const std::string field = GetParam().field;
  ASSERT_NE(text.find(field), std::string::npos);
  text.replace(text.find(field), field.size(), GetParam().edit);
  try {
    profileFromJsonText(text, "bad.json");
    FAIL() << "accepted " << text;
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(), HasSubstr(GetParam().message));
    EXPECT_THAT(error.what(), HasSubstr("bad.json"));
  }
}

constexpr const char* kWidth = "\"width\":64";
INSTANTIATE_TEST_SUITE_P(DisplayProfile, BadProfiles,
                         ::testing::Values(BadProfile{"missing", "\"width\":64,", "", "width"},
                                           BadProfile{"tooSmall", kWidth, "\"width\":1", "width"},
                                           BadProfile{"notWhole", kWidth, "\"width\":64.5", "width"},
                                           BadProfile{"text", kWidth, "\"width\":\"64\"", "width"},
                                           BadProfile{"unknown", kWidth, "\"width\":64,\"weight\":3", "weight"},
                                           BadProfile{"nineBits", "channel\":1", "channel\":9",
                                                      "color_bits_per_channel"},
                                           BadProfile{"timing", "together", "at once", "channel_timing"},
                                           BadProfile{"path", "\"test\"", "\"../x\"", "name"},
                                           BadProfile{"halfTurn", "mirrored", "none", "second_half_turn"},
                                           BadProfile{"tooLarge", "24,\"width\":64,\"height\":64",
                                                      "4096,\"width\":4096,\"height\":4096", "2 GiB"},
                                           BadProfile{"syntax", kWidth, "\"width\":", "not valid JSON"}),
                         ::testing::PrintToStringParamName());

TEST(DisplayProfile, unknownNameListsThePresets) {
  try {
    loadProfile("perspectra");
    FAIL();
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(), HasSubstr("perspecta, perspecta-99, vortex, test"));
  }
  EXPECT_THROW(loadProfile("missing.json"), InputError);
}

}  // namespace
}  // namespace ocelli
