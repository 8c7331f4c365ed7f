// A server whose images cost nothing, for tests of the server itself; and a client that reads it honestly.
#pragma once

#include <functional>
#include <optional>
#include <string>

#include "oc_core/remote/remote_message.h"
#include "oc_core/remote/server/remote_server.h"
#include "tests/remote_server/raw_socket.h"

namespace ocelli::test {

/// Its bytes tell which image it is.
RemoteImage fakeImage(const RemoteRequest& request, uint32_t id, size_t colorBytes, size_t depthBytes);

/// Serves fakeImage()s of 100 KB and 20 KB and a small page. Change what a test needs.
RemoteServerSetup fakeSetup();

std::string lookText(uint32_t sequence);

struct ReceivedImage {
  RemoteImageHeader header;
  std::vector<std::byte> color;
  std::vector<std::byte> depth;
};
/// Reads messages until an image is complete, which pieces of at most 32 KiB bring in order. Nothing where the
/// connection ends, or something came that is no message of a server. `heard` is called for each text.
std::optional<ReceivedImage> awaitImage(TestWebSocket& client,
                                        const std::function<void(const RemoteServerMessage&)>& heard = {});

/// Looks, and checks that the image for it comes whole and is what was drawn.
void expectHonestService(int port);

/// Asks again and again until it holds; false where it does not in time.
bool eventually(const std::function<bool()>& holds);

}  // namespace ocelli::test
