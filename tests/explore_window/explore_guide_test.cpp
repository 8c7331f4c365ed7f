// docs/explore.md keeps up with the table of keys.
#include <gtest/gtest.h>

#include "oc_core/explore_window/explore_keys.h"
#include "tests/base/temporary_folder.h"

namespace ocelli {
namespace {

TEST(ExploreGuide, listsEveryKey) {
  const std::string guide = test::fileBytes(OCELLI_SOURCE_DIR "/docs/explore.md");
  const auto expectRow = [&](const auto& row) {
    if (*row.keys != '\0') {
      const std::string line = std::string("| ") + row.keys + " | " + row.meaning + " | " + row.pad + " |";
      EXPECT_NE(guide.find(line), std::string::npos) << "add to docs/explore.md:\n" << line;
    }
  };
  for (const ExploreHeldKey& row : exploreHeldKeys()) {
    expectRow(row);
  }
  for (const ExploreKeyAction& row : exploreKeyActions()) {
    expectRow(row);
  }
  for (const ExplorePointerRow& row : explorePointerRows()) {
    EXPECT_NE(guide.find(std::string("| ") + row.what + " | " + row.meaning + " | |"), std::string::npos) << row.what;
  }
}

}  // namespace
}  // namespace ocelli
