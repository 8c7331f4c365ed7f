#include "oc_core/remote/remote_message.h"

#include <gtest/gtest.h>

#include "oc_core/base/error.h"

namespace ocelli {
namespace {

using Bytes = std::vector<std::byte>;

Bytes countingBytes(size_t count) {
  Bytes bytes(count);
  for (size_t i = 0; i < count; ++i) {
    bytes[i] = static_cast<std::byte>(i * 7);
  }
  return bytes;
}

TEST(RemoteMessage, WhatAServerSaysIsReadBack) {
  RemoteHello hello{
      .scene = "builtin:statues", .view = {}, .box = {glm::vec3(-1, -2, -3), glm::vec3(1, 2, 3)}, .settings = {}};
  hello.settings.reach = 2;
  hello.maxScreen = 1000;
  hello.view.fovVerticalDegrees = 30;
  const RemoteServerMessage read = remoteServerMessageFromJson(jsonText(hello));
  const auto& again = std::get<RemoteHello>(read);
  EXPECT_EQ(again.scene, hello.scene);
  EXPECT_EQ(again.view, hello.view);
  EXPECT_EQ(again.box.lower, hello.box.lower);
  EXPECT_EQ(again.box.upper, hello.box.upper);
  EXPECT_EQ(again.settings, hello.settings);
  EXPECT_EQ(again.maxScreen, 1000);

  const auto queued = std::get<RemoteQueued>(remoteServerMessageFromJson(jsonText(RemoteQueued{7, 2})));
  EXPECT_EQ(queued.sequence, 7u);
  EXPECT_EQ(queued.before, 2);
  EXPECT_EQ(std::get<RemoteDrawing>(remoteServerMessageFromJson(jsonText(RemoteDrawing{9}))).sequence, 9u);
  const auto failure = std::get<RemoteFailure>(remoteServerMessageFromJson(jsonText(RemoteFailure{"no", 3u})));
  EXPECT_EQ(failure.message, "no");
  EXPECT_EQ(failure.sequence, 3u);
  EXPECT_FALSE(std::get<RemoteFailure>(remoteServerMessageFromJson(jsonText(RemoteFailure{"no"}))).sequence);
}

TEST(RemoteMessage, HeadersAreReadBack) {
  const RemoteImageHeader header{.id = 3,
                                 .sequence = 7,
                                 .view = {.fovVerticalDegrees = 33},
                                 .size = {320, 200},
                                 .layout = {.regions = {GpcRegion{{0.5f, 0.5f}, {0.3f, 0.3f}, 2.5f, 0.5f}}},
                                 .colorCodec = "png",
                                 .colorBytes = 100,
                                 .depthCodec = "deflate",
                                 .depthBytes = 50,
                                 .inverseNear = 0.5,
                                 .inverseFar = 0.25,
                                 .levels = 1000,
                                 .drawSeconds = 0.5,
                                 .encodeSeconds = 0.25};
  EXPECT_EQ(remoteImageHeaderFromJson(jsonText(header)), header);
  EXPECT_EQ(std::get<RemoteImageHeader>(remoteServerMessageFromJson(jsonText(header))), header);
  RemoteImageHeader plain = header;
  plain.layout = {.sampling = findGpcSampling("quadratic"), .regions = {}};
  EXPECT_EQ(remoteImageHeaderFromJson(jsonText(plain)), plain);
}

TEST(RemoteMessage, UnknownAndBrokenOnesAreRefused) {
  for (const char* wrong : {"", "[]", "{}", R"({"type":"look"})", R"({"type":7})", R"({"type":"queued","sequence":1})",
                            R"({"type":"drawing","sequence":1,"more":2})", R"({"type":"error","message":""})",
                            R"({"type":"hello","version":2})"}) {
    EXPECT_THROW(remoteServerMessageFromJson(wrong), InputError) << wrong;
  }
}

TEST(RemotePiece, HasTheBytesOfTheProtocol) {
  const Bytes bytes = countingBytes(3);
  const Bytes message = messageOf({.id = 0x01020304, .plane = RemotePlane::kDepth, .offset = 0x0a0b, .bytes = bytes});
  const int expected[] = {4, 3, 2, 1, 1, 0, 0, 0, 0x0b, 0x0a, 0, 0, 0, 7, 14};
  ASSERT_EQ(message.size(), std::size(expected));
  for (size_t i = 0; i < message.size(); ++i) {
    EXPECT_EQ(static_cast<int>(message[i]), expected[i]) << i;
  }
  const RemotePiece piece = pieceOf(message);
  EXPECT_EQ(piece.id, 0x01020304u);
  EXPECT_EQ(piece.offset, 0x0a0bu);
  EXPECT_EQ(Bytes(piece.bytes.begin(), piece.bytes.end()), bytes);
}

TEST(RemotePiece, OthersAreRefused) {
  const Bytes whole = messageOf({.id = 1, .plane = RemotePlane::kColor, .offset = 0, .bytes = countingBytes(5)});
  EXPECT_THROW(pieceOf(std::span(whole).first(RemotePiece::kHeaderBytes)), InputError);
  EXPECT_THROW(pieceOf({}), InputError);
  Bytes plane = whole;
  plane[4] = std::byte{2};
  EXPECT_THROW(pieceOf(plane), InputError);
  Bytes padding = whole;
  padding[6] = std::byte{1};
  EXPECT_THROW(pieceOf(padding), InputError);
  EXPECT_THROW(pieceOf(Bytes(RemotePiece::kMaxMessageBytes + 1)), InputError);
}

RemoteImage someImage() {
  return {.id = 5,
          .sequence = 1,
          .headerJson = {},
          .color = countingBytes(RemotePiece::kMaxBytes + 10),
          .depth = countingBytes(20)};
}

RemoteAssembly assemblyFor(const RemoteImage& image) {
  RemoteImageHeader header;
  header.id = image.id;
  header.colorBytes = image.color.size();
  header.depthBytes = image.depth.size();
  return RemoteAssembly(header);
}

TEST(RemoteAssembly, GathersPiecesInAnyOrder) {
  const RemoteImage image = someImage();
  std::vector<RemotePiece> pieces = piecesOf(image);
  ASSERT_EQ(pieces.size(), 3u);  // two of the colours, one of the depths
  std::swap(pieces[0], pieces[2]);
  RemoteAssembly assembly = assemblyFor(image);
  assembly.add(pieces[0]);
  EXPECT_TRUE(assembly.hasDepth());
  EXPECT_FALSE(assembly.hasColor());
  EXPECT_EQ(assembly.received(), 20u);
  assembly.add(pieces[1]);
  assembly.add(pieces[2]);
  EXPECT_TRUE(assembly.hasColor());
  EXPECT_EQ(assembly.received(), assembly.expected());
  EXPECT_EQ(assembly.color(), image.color);
  EXPECT_EQ(assembly.depth(), image.depth);
}

TEST(RemoteAssembly, RefusesWhatDoesNotBelong) {
  const RemoteImage image = someImage();
  RemoteAssembly assembly = assemblyFor(image);
  const Bytes bytes = countingBytes(20);
  EXPECT_THROW(assembly.add({.id = 6, .plane = RemotePlane::kDepth, .offset = 0, .bytes = bytes}), InputError);
  EXPECT_THROW(assembly.add({.id = 5, .plane = RemotePlane::kDepth, .offset = 1, .bytes = bytes}), InputError);
  EXPECT_THROW(assembly.add({.id = 5, .plane = RemotePlane::kDepth, .offset = 0xffffffff, .bytes = bytes}), InputError);
  assembly.add({.id = 5, .plane = RemotePlane::kDepth, .offset = 0, .bytes = bytes});
  EXPECT_THROW(assembly.add({.id = 5, .plane = RemotePlane::kDepth, .offset = 0, .bytes = bytes}), InputError);
}

}  // namespace
}  // namespace ocelli
