#include "oc_core/remote/server/remote_limits.h"

#include <array>

namespace ocelli {
namespace {

constexpr std::array<RemoteLimitRow, 8> kLimitRows{{
    {"clients", "N", &RemoteLimits::clients, 1, 1000, "Serve so many clients at a time"},
    {"connections", "N", &RemoteLimits::connectionsPerAddress, 1, 10000,
     "Take so many connections at a time from one address"},
    {"looks", "N", &RemoteLimits::looksPerSecond, 1, 1000, "Take so many messages a second from a client"},
    {"message-bytes", "BYTES", &RemoteLimits::messageBytes, 256, 16384, "The size of the largest message to take"},
    {"screen", "PIXELS", &RemoteLimits::screenPixels, 16, 4096, "Draw for screens of so many pixels a side"},
    {"handshake-seconds", "S", &RemoteLimits::handshakeSeconds, 1, 600,
     "Give a connection so long to become a client or to fetch a file, and a message to be complete"},
    {"idle-seconds", "S", &RemoteLimits::idleSeconds, 1, 1'000'000, "Close clients that sent nothing for so long"},
    {"ping-seconds", "S", &RemoteLimits::pingSeconds, 1, 3600,
     "Ask clients that say nothing so often whether they are there; after three times so long they are gone"},
}};

}  // namespace

std::span<const RemoteLimitRow> remoteLimitRows() {
  return kLimitRows;
}

int maxConnections(const RemoteLimits& limits) {
  constexpr int kForFiles = 32;
  return 2 * limits.clients + kForFiles;
}

}  // namespace ocelli
