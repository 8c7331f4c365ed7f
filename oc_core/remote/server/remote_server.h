// The server of remote visualisation (section 5.2.1): a page over HTTP and a WebSocket at /ws, on one port, for several
// clients at a time. docs/remote_protocol.md says what they tell each other, docs/remote.md what is refused.
//
// One thread serves all connections, others draw (draw_service.h). A client holds the memory of one image at most; one
// that vanishes holds nothing.
#pragma once

#include <cstddef>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "oc_core/remote/server/access_rules.h"
#include "oc_core/remote/server/draw_service.h"
#include "oc_core/remote/server/page_asset.h"
#include "oc_core/remote/server/remote_limits.h"
#include "oc_core/remote/server/slow_link.h"

namespace ocelli {

struct RemoteServerSetup {
  std::string address = "127.0.0.1";  ///< where it listens: listening_socket.h
  int port = 0;                       ///< 0: any that is free
  AccessRules access{};
  RemoteLimits limits{};
  SlowLinkSettings link{};
  int drawThreads = 1;  ///< images that are drawn at the same time, of different clients
  std::string hello;    ///< the first message to each client
  std::vector<PageAsset> assets{};
  RemoteDraw draw;
  /// A line on what happens, for people; called on a thread of its own. It may take its time, as clients do not wait
  /// for it; of very many lines some are left out then (note_queue.h). May be empty.
  std::function<void(const std::string& line)> note{};
};

/// Since the beginning, but for those that are there now.
struct RemoteServerCounts {
  size_t clients = 0;
  size_t clientsNow = 0;
  size_t connectionsNow = 0;
  size_t refused = 0;  ///< requests, messages and connections
  size_t rests = 0;    ///< after a connection that could not be taken, for want of a descriptor or of memory
  size_t looks = 0;
  size_t images = 0;         ///< sent to their last byte
  size_t imageBytesNow = 0;  ///< in memory, to be sent
  size_t bytesSent = 0;
};

class RemoteServer {
 public:
  /// Serves until it is destroyed. Throws InputError for an address that is none, and where one that others reach has
  /// no token; WorkError where the port may not be used.
  explicit RemoteServer(RemoteServerSetup setup);
  ~RemoteServer();
  RemoteServer(const RemoteServer&) = delete;
  RemoteServer& operator=(const RemoteServer&) = delete;

  int port() const;
  /// Of the page, with the token where there is one: "http://127.0.0.1:8080/?token=...".
  std::string pageAddress() const;
  /// Waits for the thread of the connections: not from `note`.
  RemoteServerCounts counts() const;

 private:
  class State;
  std::unique_ptr<State> state_;
};

}  // namespace ocelli
