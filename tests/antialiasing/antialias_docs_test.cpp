// docs/antialiasing.md says of ways and keys what their rows say.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "oc_core/antialiasing/antialias_option.h"
#include "oc_core/base/file_bytes.h"

namespace ocelli {
namespace {

std::string withEscapedBars(const std::string& text) {
  std::string escaped;
  for (const char c : text) {
    escaped += c == '|' ? "\\|" : std::string(1, c);
  }
  return escaped;
}

TEST(AntialiasDocs, describeEveryWayAndKey) {
  const std::string guide = readFile(OCELLI_ANTIALIASING_GUIDE);
  for (const AntialiasMethod& each : antialiasMethods()) {
    const std::string name = std::string(each.name) + (each.allows != nullptr ? "-N" : "");
    EXPECT_THAT(guide, testing::HasSubstr("| `" + name + "` | " + each.description + " |"));
  }
  for (const AntialiasKey& each : antialiasKeys()) {
    EXPECT_THAT(guide, testing::HasSubstr("| `" + std::string(each.name) + "=" + withEscapedBars(each.values) + "` |"));
    EXPECT_THAT(guide, testing::HasSubstr("| " + describeAntialiasKey(each) + " |"));
  }
}

}  // namespace
}  // namespace ocelli
