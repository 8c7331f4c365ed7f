#include "oc_core/remote/server/client_outbox.h"

#include <algorithm>
#include <span>
#include <utility>

#include "oc_core/base/check.h"
#include "oc_core/remote/remote_message.h"

namespace ocelli {
namespace {

OutgoingMessage textMessage(const std::string& text, int64_t readyAt) {
  const auto bytes = std::as_bytes(std::span(text));
  return {true, {bytes.begin(), bytes.end()}, readyAt};
}

}  // namespace

void ClientOutbox::addText(Kind kind, std::string text, int64_t now) {
  std::erase_if(texts_, [&](const Text& waiting) { return waiting.kind == kind; });
  texts_.push_back({kind, std::move(text), now});
}

void ClientOutbox::addImage(RemoteImage image, int64_t now) {
  OC_CHECK(!sending_, "the next image is drawn when this one has gone");
  sending_ = Sending{.image = std::move(image), .readyAt = now};
}

bool ClientOutbox::isEmpty() const {
  return texts_.empty() && !sending_;
}

std::optional<OutgoingMessage> ClientOutbox::next() {
  if (!texts_.empty()) {
    const Text text = std::move(texts_.front());
    texts_.erase(texts_.begin());
    return textMessage(text.text, text.readyAt);
  }
  if (!sending_) {
    return std::nullopt;
  }
  OutgoingMessage message = nextOfImage();
  if (sending_->hasBegun && sending_->sent == sending_->size()) {
    ++sent_;
    sending_.reset();
  }
  return message;
}

OutgoingMessage ClientOutbox::nextOfImage() {
  Sending& sending = *sending_;
  const RemoteImage& image = sending.image;
  if (!sending.hasBegun) {
    sending.hasBegun = true;
    return textMessage(image.headerJson, sending.readyAt);
  }
  const bool isColor = sending.sent < image.color.size();
  const std::span<const std::byte> plane = isColor ? image.color : image.depth;
  const size_t offset = isColor ? sending.sent : sending.sent - image.color.size();
  const size_t size = std::min(RemotePiece::kMaxBytes, plane.size() - offset);
  OC_CHECK(size > 0, "an image whose bytes have all gone is no longer being sent");
  sending.sent += size;
  return {false,
          messageOf({.id = image.id,
                     .plane = isColor ? RemotePlane::kColor : RemotePlane::kDepth,
                     .offset = static_cast<uint32_t>(offset),
                     .bytes = plane.subspan(offset, size)}),
          sending.readyAt};
}

size_t ClientOutbox::heldBytes() const {
  return sending_ ? sending_->size() - sending_->sent : 0;
}

}  // namespace ocelli
