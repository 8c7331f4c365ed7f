// Images of general pinholes through all of the way: planned, drawn, encoded, in pieces, decoded.
#include "oc_core/remote/remote_image.h"

#include <gtest/gtest.h>

#include "oc_core/image/png_file.h"
#include "oc_core/ocri/resample.h"
#include "oc_core/remote/remote_message.h"
#include "oc_core/remote/remote_scene.h"
#include "oc_core/worlds/scene_source.h"

namespace ocelli {
namespace {

RemoteRequest smallRequest() {
  return {.sequence = 7, .view = {}, .screen = {128, 72}};
}

RemoteSettings losslessSettings() {
  RemoteSettings settings;
  settings.color = "png";
  settings.samples = 1;
  return settings;
}

const RemoteScene& statues() {
  static const RemoteScene scene(loadScene("builtin:statues"), "builtin:statues");
  return scene;
}

TEST(RemoteImage, ComesBackInPiecesAsItWasDrawn) {
  const RemoteSettings settings = losslessSettings();
  const RemotePlan plan = planRemoteImage(smallRequest(), settings);
  const ReferenceImage drawn = statues().draw(plan);
  const RemoteImage coded = encodeRemoteImage(drawn, settings, 3, 7);
  RemoteAssembly assembly(remoteImageHeaderFromJson(coded.headerJson));
  for (const RemotePiece& piece : piecesOf(coded)) {
    EXPECT_FALSE(assembly.hasDepth());
    assembly.add(pieceOf(messageOf(piece)));
  }
  ASSERT_TRUE(assembly.hasColor() && assembly.hasDepth());
  EXPECT_EQ(assembly.header().sequence, 7u);

  const ReferenceImage decoded = decodeRemoteImage(coded.headerJson, assembly.color(), assembly.depth());
  EXPECT_EQ(srgbFromLinear(decoded.color), srgbFromLinear(drawn.color));
  EXPECT_EQ(decoded.held, drawn.held);
  EXPECT_EQ(decoded.layout, drawn.layout);
  EXPECT_EQ(decoded.reference(), drawn.reference());
}

TEST(RemoteImage, IsDrawnWithoutDepthFromItsOwnEye) {
  const RemoteRequest request = smallRequest();
  const RemoteImage coded = statues().answer(request, losslessSettings(), 1);
  const PinholeCamera screen(request.view, request.screen.x, request.screen.y);
  const ReferenceImage whole = decodeRemoteImage(coded.headerJson, coded.color, coded.depth);
  const ReferenceImage colors = decodeRemoteImage(coded.headerJson, coded.color, {});
  const ResampledView fromWhole = resample({whole}, screen);
  const ResampledView fromColors = resample({colors}, screen);
  EXPECT_FALSE(fromColors.isWarped);
  EXPECT_EQ(fromColors.holes(), 0);
  EXPECT_EQ(fromColors.color, fromWhole.color);
}

}  // namespace
}  // namespace ocelli
