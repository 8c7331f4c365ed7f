// docs/volumes.md says of made volumes, presets and scales what their rows say.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "oc_core/base/file_bytes.h"
#include "oc_core/volume/builtin_volumes.h"
#include "oc_core/volume/transfer_presets.h"

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

}  // namespace
}  // namespace ocelli
