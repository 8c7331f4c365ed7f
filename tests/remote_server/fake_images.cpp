#include "tests/remote_server/fake_images.h"

#include <gtest/gtest.h>

#include <thread>

#include "oc_core/base/error.h"

namespace ocelli::test {
namespace {

constexpr size_t kColorBytes = 100'000;
constexpr size_t kDepthBytes = 20'000;

std::vector<std::byte> fakeBytes(uint32_t id, size_t size, uint32_t salt) {
  std::vector<std::byte> bytes(size);
  for (size_t i = 0; i < size; ++i) {
    bytes[i] = static_cast<std::byte>((i * 31 + id * 7 + salt) >> (i % 5));
  }
  return bytes;
}

}  // namespace

RemoteImage fakeImage(const RemoteRequest& request, uint32_t id, size_t colorBytes, size_t depthBytes) {
  RemoteImageHeader header;
  header.id = id;
  header.sequence = request.sequence;
  header.view = request.view;
  header.size = {64, 36};
  header.colorCodec = "png";
  header.colorBytes = colorBytes;
  header.depthCodec = "deflate";
  header.depthBytes = depthBytes;
  header.inverseNear = 0.2;
  header.inverseFar = 0.1;
  return {id, request.sequence, jsonText(header), fakeBytes(id, colorBytes, 0), fakeBytes(id, depthBytes, 3)};
}

RemoteServerSetup fakeSetup() {
  RemoteServerSetup setup;
  RemoteHello hello;
  hello.scene = "fake";
  setup.hello = jsonText(hello);
  setup.assets = {{"/", "text/html; charset=utf-8", "<!doctype html><title>fake</title>"},
                  {"/remote.js", "text/javascript; charset=utf-8", std::string(100'000, ';')}};
  setup.draw = [](const RemoteRequest& request, uint32_t id, const std::function<bool()>&) {
    return fakeImage(request, id, kColorBytes, kDepthBytes);
  };
  return setup;
}

std::string lookText(uint32_t sequence) {
  RemoteRequest request;
  request.sequence = sequence;
  return jsonText(request);
}

std::optional<ReceivedImage> awaitImage(TestWebSocket& client,
                                        const std::function<void(const RemoteServerMessage&)>& heard) {
  std::optional<RemoteAssembly> assembly;
  try {
    while (const std::optional<Frame> frame = client.receive()) {
      if (frame->opcode == Frame::kText) {
        const RemoteServerMessage message = remoteServerMessageFromJson(frame->payload);
        if (heard) {
          heard(message);
        }
        if (const auto* const header = std::get_if<RemoteImageHeader>(&message)) {
          assembly.emplace(*header);
        }
      } else if (frame->opcode == Frame::kBinary && assembly) {
        const RemotePiece piece = pieceOf(std::as_bytes(std::span(frame->payload)));
        EXPECT_EQ(piece.plane == RemotePlane::kDepth, assembly->hasColor()) << "colours come first";
        assembly->add(piece);
      } else {
        return std::nullopt;
      }
      if (assembly && assembly->hasColor() && assembly->hasDepth()) {
        return ReceivedImage{assembly->header(), assembly->color(), assembly->depth()};
      }
    }
  } catch (const InputError& error) {
    ADD_FAILURE() << error.what();
  }
  return std::nullopt;
}

void expectHonestService(int port) {
  TestWebSocket client(port);
  ASSERT_TRUE(client.isOpen()) << client.answer();
  constexpr uint32_t kSequence = 12345;
  ASSERT_TRUE(client.sendText(lookText(kSequence)));
  const std::optional<ReceivedImage> image = awaitImage(client);
  ASSERT_TRUE(image);
  EXPECT_EQ(image->header.sequence, kSequence);
  EXPECT_EQ(image->color, fakeBytes(image->header.id, kColorBytes, 0));
  EXPECT_EQ(image->depth, fakeBytes(image->header.id, kDepthBytes, 3));
}

bool eventually(const std::function<bool()>& holds) {
  const auto end = std::chrono::steady_clock::now() + kPatience;
  while (!holds()) {
    if (std::chrono::steady_clock::now() > end) {
      return false;
    }
    std::this_thread::sleep_for(std::chrono::milliseconds(2));
  }
  return true;
}

}  // namespace ocelli::test
