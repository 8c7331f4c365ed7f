// Serves the experimenter's page to this computer alone: 127.0.0.1, GET, and only where the browser asks for that very
// address, so that no page of the network reaches it through a name of its own (DNS rebinding). Whoever else is logged
// in at this computer can read it.
#pragma once

#include <functional>
#include <memory>
#include <string>

namespace ocelli {

class LiveServer {
 public:
  /// Answers on a thread of its own until it is destroyed; `status` is called there. Port 0 takes a free one. Throws
  /// WorkError where the port is in use, or may not be used.
  LiveServer(int port, std::function<std::string()> status);
  ~LiveServer();
  LiveServer(const LiveServer&) = delete;
  LiveServer& operator=(const LiveServer&) = delete;

  int port() const;
  /// "http://127.0.0.1:8765/".
  std::string address() const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace ocelli
