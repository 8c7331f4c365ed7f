// Requests that no client of ours sends: broken HTTP, wrong frames of WebSockets, messages that are no looks, and
// clients that go in the middle of it all. From a seed: the same ones each time.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>

#include "oc_core/remote/server/remote_server.h"

namespace ocelli::test {

/// A server that lets them try: with a token, short time-outs and room for many.
RemoteServerSetup besiegedSetup();

/// Sends so many, one connection each, from several addresses of this computer, of all kinds in turn.
void sendHostileRequests(int port, const std::string& token, size_t count, uint64_t seed);

/// Sends them to a server, after some to warm up; then expects that nothing of them is left in it, neither connections
/// nor memory, and that it serves an honest client as before.
void expectToSurvive(size_t count, uint64_t seed);

}  // namespace ocelli::test
