// Serves pages to this computer alone: 127.0.0.1, GET and HEAD, and only where the browser asks for that very address,
// so that no page of the network reaches it through a name of its own (DNS rebinding). Whoever else is logged in at
// this computer can read it. The only room that knows libmicrohttpd.
#pragma once

#include <cstddef>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

namespace ocelli {

/// What stands at a path.
struct LocalAnswer {
  std::string type;  ///< "text/html; charset=utf-8"
  std::string body;
  /// Instead of a body: writes up to `size` bytes and returns how many, 0 at the end. It may wait where each browser
  /// has a thread of its own.
  std::function<size_t(char* bytes, size_t size)> stream = {};
};

struct LocalServerOptions {
  std::string option;  ///< of the command line that asks for it, for errors: "--page"
  unsigned maxConnections = 16;
  unsigned timeoutSeconds = 10;
  bool hasThreads = false;        ///< a thread for each browser
  std::string images = "'self'";  ///< where images of the page come from, as Content-Security-Policy has it
};

class LocalServer {
 public:
  /// Nothing stands at paths for which `answer` gives nothing. It is called on other threads until the server is
  /// destroyed; where it throws, the connection ends without an answer. Port 0 takes a free one. Throws WorkError where
  /// the port is in use, or may not be used.
  LocalServer(int port, const LocalServerOptions& options,
              std::function<std::optional<LocalAnswer>(std::string_view path)> answer);
  /// Waits for streams: let them end first.
  ~LocalServer();
  LocalServer(const LocalServer&) = delete;
  LocalServer& operator=(const LocalServer&) = delete;

  int port() const;
  /// "http://127.0.0.1:8765/".
  std::string address() const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace ocelli
