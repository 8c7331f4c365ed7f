#include "oc_core/remote/remote_settings.h"

#include <gtest/gtest.h>

#include <cctype>
#include <fstream>

#include "oc_core/base/error.h"

namespace ocelli {
namespace {

TEST(RemoteSettings, DefaultsAreValidAndComeBackFromJson) {
  EXPECT_NO_THROW(validate(RemoteSettings{}, "test"));
  RemoteSettings settings;
  settings.reach = 1.75;
  settings.samples = 2;
  settings.depth = "png";
  EXPECT_EQ(remoteSettingsFromJson(jsonText(settings), "test"), settings);
  EXPECT_EQ(remoteSettingsFromJson("{}", "test"), RemoteSettings{});
}

TEST(RemoteSettings, AreRefusedByName) {
  for (const char* wrong : {R"({"reach": 0.9})", R"({"size": "large"})", R"({"color": "gif"})", R"({"samples": 1.5})",
                            R"({"zooom": 2})", R"({"quality": 101})"}) {
    EXPECT_THROW(remoteSettingsFromJson(wrong, "test"), InputError) << wrong;
  }
  RemoteSettings settings;
  settings.sampling = "quartic";
  EXPECT_THROW(validate(settings, "test"), InputError);
  settings = {};
  settings.zoom = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(validate(settings, "test"), InputError);
}

TEST(RemoteSettings, TheProtocolDescribesEach) {
  std::ifstream file(OCELLI_SOURCE_FOLDER "/docs/remote_protocol.md");
  const std::string text((std::istreambuf_iterator<char>(file)), {});
  for (const RemoteOption& option : remoteOptions()) {
    std::string meaning = option.meaning;
    meaning[0] = static_cast<char>(std::tolower(meaning[0]));
    const std::string unit = *option.unit != '\0' ? std::string(", ") + option.unit : "";
    const std::string row =
        std::string("| `") + option.name + "` | " + valueText(option, {}) + " | " + meaning + unit + " |";
    EXPECT_NE(text.find(row), std::string::npos) << row;
  }
}

}  // namespace
}  // namespace ocelli
