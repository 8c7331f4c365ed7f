// What the server of remote visualisation lets clients do at most.
#pragma once

#include <span>

namespace ocelli {

struct RemoteLimits {
  int clients = 8;
  int connectionsPerAddress = 16;
  int looksPerSecond = 60;
  int messageBytes = 16384;
  int screenPixels = 4096;
  int handshakeSeconds = 10;
  int idleSeconds = 3600;
  int pingSeconds = 15;
};

/// One limit: the options of programs and their help come from these rows.
struct RemoteLimitRow {
  const char* name;  ///< of the option, without dashes
  const char* unit;
  int RemoteLimits::*field;
  int min;
  int max;
  const char* meaning;
};

std::span<const RemoteLimitRow> remoteLimitRows();

/// TCP connections at a time, of all addresses: those of clients, and as many again and some for the page's files.
int maxConnections(const RemoteLimits& limits);

}  // namespace ocelli
