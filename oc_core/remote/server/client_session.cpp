#include "oc_core/remote/server/client_session.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "oc_core/base/error.h"
#include "oc_core/remote/remote_message.h"

namespace ocelli {
namespace {

constexpr int kUnacceptable = 1003;
constexpr int kPolicyViolation = 1008;
constexpr int kTooLarge = 1009;
constexpr int kMaxBadMessages = 16;

int64_t nanosecondsOf(int seconds) {
  return int64_t{seconds} * 1'000'000'000;
}

}  // namespace

ClientSession::ClientSession(const RemoteLimits& limits, const SlowLinkSettings& link, int64_t now)
    : limits_(limits), link_(link), lastMessage_(now), tokens_(limits.looksPerSecond), tokensAt_(now) {}

/// A bucket of one second's messages, which fills again as fast as they may come.
bool ClientSession::takeToken(int64_t now) {
  const double rate = limits_.looksPerSecond;
  tokens_ = std::min(rate, tokens_ + rate * static_cast<double>(now - tokensAt_) * 1e-9);
  tokensAt_ = now;
  if (tokens_ < 1) {
    return false;
  }
  tokens_ -= 1;
  return true;
}

ClientSession::Received ClientSession::receive(std::string_view part, bool isBinary, bool isLast, int64_t now) {
  if (isBinary) {
    return {.close = CloseReason{kUnacceptable, "clients send texts alone"}};
  }
  if (!isInMessage_) {
    isInMessage_ = true;
    messageBegan_ = now;
    if (!takeToken(now)) {
      return {.close = CloseReason{kPolicyViolation,
                                   fmt::format("more than {} messages in a second", limits_.looksPerSecond)}};
    }
  }
  if (message_.size() + part.size() > static_cast<size_t>(limits_.messageBytes)) {
    return {.close = CloseReason{kTooLarge, fmt::format("a message of more than {} bytes", limits_.messageBytes)}};
  }
  message_ += part;
  if (!isLast) {
    return {};
  }
  Received received = readMessage(now);
  message_.clear();
  isInMessage_ = false;
  lastMessage_ = now;
  return received;
}

ClientSession::Received ClientSession::readMessage(int64_t now) {
  std::optional<uint32_t> sequence;
  try {
    RemoteRequest look = remoteRequestFromJson(message_);
    sequence = look.sequence;
    if (std::max(look.screen.x, look.screen.y) > limits_.screenPixels) {
      throw InputError(fmt::format("this server draws for screens of at most {} pixels a side", limits_.screenPixels),
                       "message \"look\", \"screen\"", "make the window smaller");
    }
    ++looks_;
    return {.look = std::move(look)};
  } catch (const InputError& error) {
    if (++badMessages_ >= kMaxBadMessages) {
      return {.close = CloseReason{kPolicyViolation, "too many messages that cannot be read"}};
    }
    outbox_.addText(ClientOutbox::Kind::kError, jsonText(RemoteFailure{.message = error.what(), .sequence = sequence}),
                    now);
    return {};
  }
}

std::optional<CloseReason> ClientSession::outOfTime(int64_t now) const {
  if (isInMessage_ && now - messageBegan_ > nanosecondsOf(limits_.handshakeSeconds)) {
    return CloseReason{kPolicyViolation, "the rest of a message did not come"};
  }
  if (now - lastMessage_ > nanosecondsOf(limits_.idleSeconds)) {
    return CloseReason{kPolicyViolation, fmt::format("nothing came for {} seconds", limits_.idleSeconds)};
  }
  return std::nullopt;
}

std::optional<OutgoingMessage> ClientSession::nextDue(int64_t now) {
  if (!held_) {
    held_ = outbox_.next();
    if (!held_) {
      return std::nullopt;
    }
    heldUntil_ = link_.isSlow() ? link_.leavesAt(held_->bytes.size(), held_->readyAt) : now;
  }
  if (heldUntil_ > now) {
    return std::nullopt;
  }
  bytesSent_ += held_->bytes.size();
  return std::exchange(held_, std::nullopt);
}

std::optional<int64_t> ClientSession::leavesAt() const {
  return held_ ? std::optional(heldUntil_) : std::nullopt;
}

}  // namespace ocelli
