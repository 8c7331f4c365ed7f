// One client of remote visualisation, as the server sees it: what it says is put together, limited and read, and what
// it is to hear waits for its link. Without sockets and clocks: the caller says what time it is.
#pragma once

#include <cstddef>
#include <cstdint>
#include <deque>
#include <optional>
#include <string>
#include <string_view>

#include "oc_core/remote/remote_request.h"
#include "oc_core/remote/server/client_outbox.h"
#include "oc_core/remote/server/remote_limits.h"
#include "oc_core/remote/server/slow_link.h"

namespace ocelli {

/// Why a connection is closed: a code of RFC 6455, section 7.4.1, and a text of at most 123 bytes.
struct CloseReason {
  int code = 0;
  std::string text;
};

/// No thread may call it while another does. Times are nanoseconds of one clock.
class ClientSession {
 public:
  ClientSession(const RemoteLimits& limits, const SlowLinkSettings& link, int64_t now);

  /// At most one of them.
  struct Received {
    std::optional<RemoteRequest> look{};
    std::optional<CloseReason> close{};
  };
  /// A part of a message. A message that is no request gets an answer, and too many of them end the connection, as does
  /// one that is too long or binary, and too many a second.
  Received receive(std::string_view part, bool isBinary, bool isLast, int64_t now);
  /// Whether it is to be closed as nothing came for too long, or not the rest of a message.
  std::optional<CloseReason> outOfTime(int64_t now) const;

  ClientOutbox& outbox() { return outbox_; }
  const ClientOutbox& outbox() const { return outbox_; }
  /// The next message that may leave now. Nothing where none waits, or the one that waits leaves later: leavesAt().
  std::optional<OutgoingMessage> nextDue(int64_t now);
  /// When to ask nextDue() again. Nothing where it found nothing that waits.
  std::optional<int64_t> leavesAt() const;
  /// Taken from the outbox, and on their way on a slow link.
  size_t heldBytes() const { return heldBytes_; }

  size_t looks() const { return looks_; }
  size_t bytesSent() const { return bytesSent_; }

 private:
  struct Held {
    OutgoingMessage message;
    int64_t until = 0;
  };
  /// Whether the next message of the outbox may begin its way.
  bool isFree(int64_t now) const;
  Received readMessage(int64_t now);
  bool takeToken(int64_t now);

  RemoteLimits limits_;
  SlowLink link_;
  ClientOutbox outbox_;
  /// On a slow link: no more than it holds at its rate over its delay, and one, as the next is taken when it is free.
  std::deque<Held> held_;
  size_t heldBytes_ = 0;
  std::string message_;  ///< as far as it has come
  bool isInMessage_ = false;
  int64_t messageBegan_ = 0;
  int64_t lastMessage_;
  double tokens_;
  int64_t tokensAt_;
  int badMessages_ = 0;
  size_t looks_ = 0;
  size_t bytesSent_ = 0;
};

}  // namespace ocelli
