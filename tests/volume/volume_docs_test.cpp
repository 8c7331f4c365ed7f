// docs/volumes.md says of made volumes, presets and scales what their rows say.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "oc_core/base/file_bytes.h"
#include "oc_core/volume/builtin_volumes.h"
#include "oc_core/volume/transfer_presets.h"
#include "oc_core/volume/volume_formats.h"

namespace ocelli {
namespace {

std::string rowOf(std::string_view name, std::string_view summary) {
  return "| `" + std::string(name) + "` | " + std::string(summary) + " |";
}

TEST(VolumeDocs, describeEveryMadeVolumePresetAndScale) {
  const std::string guide = readFile(OCELLI_VOLUMES_GUIDE);
  for (const BuiltinVolumeKind& kind : listBuiltinVolumes()) {
    EXPECT_THAT(guide, testing::HasSubstr(rowOf(kind.name, kind.summary)));
  }
  for (const TransferPreset& preset : transferPresets()) {
    EXPECT_THAT(guide, testing::HasSubstr(rowOf(preset.name, preset.summary)));
  }
  for (const TransferScale& scale : transferScales()) {
    EXPECT_THAT(guide, testing::HasSubstr(rowOf(scale.name, scale.summary)));
  }
}

// A line of the table of files: the name, and every ending.
TEST(VolumeDocs, describeEveryFormatAndItsEndings) {
  const std::string guide = readFile(OCELLI_VOLUMES_GUIDE);
  for (const VolumeFormat& format : volumeFormats()) {
    const size_t begin = guide.find("\n| " + std::string(format.name));
    ASSERT_NE(begin, std::string::npos) << format.name;
    const std::string line = guide.substr(begin + 1, guide.find('\n', begin + 1) - begin - 1);
    for (const std::string_view ending : format.endings) {
      EXPECT_THAT(line, testing::HasSubstr("`" + std::string(ending) + "`"));
    }
  }
}

}  // namespace
}  // namespace ocelli
