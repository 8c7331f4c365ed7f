// Serves the experimenter's page to this computer alone (oc_core/local_server/).
#pragma once

#include <functional>
#include <string>

#include "oc_core/local_server/local_server.h"

namespace ocelli {

class LiveServer {
 public:
  /// Answers on a thread of its own until it is destroyed; `status` is called there. Port 0 takes a free one. Throws
  /// WorkError where the port is in use, or may not be used.
  LiveServer(int port, std::function<std::string()> status);

  int port() const { return server_.port(); }
  /// "http://127.0.0.1:8765/".
  std::string address() const { return server_.address(); }

 private:
  LocalServer server_;
};

}  // namespace ocelli
