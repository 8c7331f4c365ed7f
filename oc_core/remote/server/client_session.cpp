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
/// Of messages on a slow link whose rate has no bound, or whose delay is long.
constexpr size_t kMaxHeldBytes = size_t{16} << 20;

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

bool ClientSession::isFree(int64_t now) const {
  return link_.freeAt() <= now && heldBytes_ < kMaxHeldBytes;
}

std::optional<OutgoingMessage> ClientSession::nextDue(int64_t now) {
  if (!link_.isSlow()) {
    std::optional<OutgoingMessage> message = outbox_.next();
    bytesSent_ += message ? message->bytes.size() : 0;
    return message;
  }
  while (!outbox_.isEmpty() && isFree(now)) {
    OutgoingMessage message = *outbox_.next();
    heldBytes_ += message.bytes.size();
    const int64_t until = link_.leavesAt(message.bytes.size(), message.readyAt);
    held_.push_back({std::move(message), until});
  }
  if (held_.empty() || held_.front().until > now) {
    return std::nullopt;
  }
  OutgoingMessage message = std::move(held_.front().message);
  held_.pop_front();
  heldBytes_ -= message.bytes.size();
  bytesSent_ += message.bytes.size();
  return message;
}

std::optional<int64_t> ClientSession::leavesAt() const {
  std::optional<int64_t> next;
  if (!held_.empty()) {
    next = held_.front().until;
  }
  if (!outbox_.isEmpty() && heldBytes_ < kMaxHeldBytes) {
    next = std::min(next.value_or(link_.freeAt()), link_.freeAt());
  }
  return next;
}

}  // namespace ocelli
