// Images of general pinholes through all of the way: planned, drawn, encoded, in pieces, decoded.
#include "oc_core/remote/remote_image.h"

#include <gtest/gtest.h>

#include <glm/geometric.hpp>

#include "oc_core/base/error.h"
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

TEST(RemoteImage, DepthsAreWithinAStep) {
  const RemoteSettings settings = losslessSettings();
  const ReferenceImage drawn = statues().draw(planRemoteImage(smallRequest(), settings));
  const RemoteImage coded = encodeRemoteImage(drawn, settings, 3, 7);
  const RemoteImageHeader header = remoteImageHeaderFromJson(coded.headerJson);
  const ReferenceImage decoded = decodeRemoteImage(coded.headerJson, coded.color, coded.depth);
  const double step = (header.inverseNear - header.inverseFar) / (header.levels - 1);
  for (size_t i = 0; i < drawn.t.size(); ++i) {
    if (drawn.holds(i)) {
      // Rounded to half a step, and smoothed by another. Single floats of 1/z around 0.1 add some 1e-8.
      ASSERT_NEAR(1 / static_cast<double>(decoded.t[i]), 1 / static_cast<double>(drawn.t[i]), step + 3e-8);
      // Where the pinhole sees a sample is what its layout says, but for single floats.
      ASSERT_NEAR(glm::distance(decoded.displacement[i], drawn.displacement[i]), 0, 1e-3);
    }
  }
}

TEST(RemoteImage, NothingToSeeIsAnImageToo) {
  RemoteRequest request = smallRequest();
  request.view.eye = {0, 0, 50};
  request.view.target = {0, 0, 100};
  const RemoteImage coded = statues().answer(request, losslessSettings(), 1);
  const ReferenceImage decoded = decodeRemoteImage(coded.headerJson, coded.color, coded.depth);
  EXPECT_EQ(decoded.sampleCount(), 0u);
}

TEST(RemoteImage, BytesThatDoNotFitTheHeaderAreRefused) {
  const RemoteImage coded = statues().answer(smallRequest(), losslessSettings(), 1);
  const std::span<const std::byte> color = coded.color;
  const std::span<const std::byte> depth = coded.depth;
  const auto decode = [&](std::span<const std::byte> c, std::span<const std::byte> d) {
    return decodeRemoteImage(coded.headerJson, c, d);
  };
  EXPECT_NO_THROW(decode(color, depth));
  EXPECT_THROW(decode(color.first(color.size() / 2), depth), InputError);
  EXPECT_THROW(decode(color, depth.first(depth.size() / 2)), InputError);
  EXPECT_THROW(decode({}, depth), InputError);
  EXPECT_THROW(decode(depth, color), InputError);

  // A header of fewer levels than the depths have.
  RemoteImageHeader header = remoteImageHeaderFromJson(coded.headerJson);
  header.levels = 2;
  EXPECT_THROW(decodeRemoteImage(jsonText(header), color, depth), InputError);
}

TEST(RemoteImage, HeadersBeyondTheLimitsAreRefused) {
  const RemoteImage coded = statues().answer(smallRequest(), losslessSettings(), 1);
  const RemoteImageHeader header = remoteImageHeaderFromJson(coded.headerJson);
  const auto refused = [&](const auto& change) {
    RemoteImageHeader wrong = header;
    change(wrong);
    EXPECT_THROW(remoteImageHeaderFromJson(jsonText(wrong)), InputError) << jsonText(wrong);
  };
  refused([](RemoteImageHeader& h) { h.size = {16000, 16000}; });
  refused([](RemoteImageHeader& h) { h.size = {0, 10}; });
  refused([](RemoteImageHeader& h) { h.colorBytes = RemoteImageHeader::kMaxPlaneBytes + 1; });
  refused([](RemoteImageHeader& h) { h.colorCodec = "gif"; });
  refused([](RemoteImageHeader& h) { h.depthCodec = "jpeg"; });
  refused([](RemoteImageHeader& h) { h.levels = 70000; });
  refused([](RemoteImageHeader& h) { h.inverseFar = 2 * h.inverseNear; });
  refused([](RemoteImageHeader& h) { h.inverseFar = 0; });
  refused([](RemoteImageHeader& h) { h.view.target = h.view.eye; });
  refused([](RemoteImageHeader& h) { h.layout.regions = {GpcRegion{}, GpcRegion{}}; });
}

}  // namespace
}  // namespace ocelli
