// A program without Recast says so.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "oc_core/base/error.h"
#include "oc_core/walkable/walkable.h"
#include "oc_core/worlds/scene_source.h"

namespace ocelli {
namespace {

TEST(WalkableMissing, SaysWhatToInstall) {
  EXPECT_FALSE(canFindWalkable());
  const Mesh mesh = loadScene("builtin:maze,rows=2,columns=2,landmarks=0", {.fit = false});
  EXPECT_THAT([&] { findWalkMap(mesh, {}); }, testing::ThrowsMessage<InputError>(testing::HasSubstr("librecast-dev")));
}

}  // namespace
}  // namespace ocelli
