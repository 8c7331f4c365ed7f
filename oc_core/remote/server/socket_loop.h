// The event loop of libwebsockets, on a thread of its own: for .cpp files of this room. It knows nothing of what
// clients and server tell each other.
//
// What libwebsockets 4.1 asks for, and what this file hides: only the thread of the loop may call its functions, but
// for lws_cancel_service(), which wakes the loop (post() uses it); messages come in parts; a connection is written to
// only when it is writable, and each message needs LWS_PRE bytes before it; a connection is closed by what a callback
// returns, or by a time-out; exceptions must not pass through it; and it logs to standard error unless told otherwise.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "oc_core/remote/server/client_session.h"
#include "oc_core/remote/server/http_answer.h"
#include "oc_core/remote/server/listening_socket.h"

namespace ocelli {

/// What the loop asks of the server, on its thread. Connections have numbers, which are never used again.
class LoopEvents {
 public:
  virtual ~LoopEvents() = default;
  /// Whether a connection from there is taken.
  virtual bool accepts(const AcceptedSocket& accepted) = 0;
  /// One waits that cannot be taken, for want of a descriptor or of memory; it is tried again after a rest.
  virtual void couldNotAccept() = 0;
  virtual void connected(uint64_t connection, const AcceptedSocket& accepted) = 0;
  /// It is not there any more.
  virtual void closed(uint64_t connection) = 0;
  virtual HttpAnswer answer(uint64_t connection, const HttpRequest& request) = 0;
  /// 101 where it may become a WebSocket.
  virtual HttpAnswer upgradeAnswer(uint64_t connection, const HttpRequest& request) = 0;
  virtual void becameWebSocket(uint64_t connection) = 0;
  virtual std::optional<CloseReason> received(uint64_t connection, std::string_view part, bool isBinary,
                                              bool isLast) = 0;
  /// The next message that may leave now. Where one leaves later, `waitNanoseconds` is set to how long to wait.
  virtual std::optional<OutgoingMessage> nextMessage(uint64_t connection, int64_t& waitNanoseconds) = 0;
  /// Some times a second.
  virtual void tick() = 0;
};

struct LoopSetup {
  int maxConnections = 64;
  int handshakeSeconds = 10;
  int pingSeconds = 15;
};

class SocketLoop {
 public:
  /// `listener` and `events` must outlive it. Nothing happens before start(). Throws WorkError.
  SocketLoop(const LoopSetup& setup, ListeningSocket& listener, LoopEvents& events);
  /// Closes all connections. stop() must have been called where start() was.
  ~SocketLoop();
  SocketLoop(const SocketLoop&) = delete;
  SocketLoop& operator=(const SocketLoop&) = delete;

  void start();
  /// Ends the thread. Connections stay until it is destroyed; no event comes before.
  void stop();

  /// Calls `work` on the thread of the loop, soon. Any thread may call it.
  void post(std::function<void()> work);

  // On the thread of the loop alone. Each does nothing for connections that are not there.
  /// nextMessage() will be asked for.
  void wantToSend(uint64_t connection);
  /// Tells a WebSocket why, and gives it some seconds to answer.
  void closeSoon(uint64_t connection, const CloseReason& reason);
  /// At once, without a word.
  void closeNow(uint64_t connection);

 private:
  class Lws;
  std::unique_ptr<Lws> lws_;
};

}  // namespace ocelli
