// What is still to be sent to one client: some short texts, and images in pieces.
//
// Memory is bounded: one text of each kind, and one image. The next image is drawn when the last byte of this one has
// been handed to the socket: then the view that was asked for last is the one that is drawn, however slow the link, and
// no image is cut short. What the socket itself still holds (listening_socket.cpp) keeps the link busy meanwhile.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "oc_core/remote/remote_image.h"

namespace ocelli {

/// One message of a WebSocket.
struct OutgoingMessage {
  bool isText = false;
  std::vector<std::byte> bytes;
  int64_t readyAt = 0;  ///< when it was added, as `now` said then
};

/// No thread may call it while another does.
class ClientOutbox {
 public:
  /// A text takes the place of an unsent one of the same kind.
  enum class Kind { kHello, kQueued, kDrawing, kError };
  void addText(Kind kind, std::string text, int64_t now);
  /// Only where hasImage() does not hold.
  void addImage(RemoteImage image, int64_t now);
  /// Whether a part of an image is still to be handed out.
  bool hasImage() const { return sending_.has_value(); }

  bool isEmpty() const;
  /// The next message: texts first, then the image's header, then its colour and its depth in pieces. Nothing where
  /// isEmpty().
  std::optional<OutgoingMessage> next();

  /// Of the image, unsent.
  size_t heldBytes() const;
  size_t imagesSent() const { return sent_; }

 private:
  struct Text {
    Kind kind;
    std::string text;
    int64_t readyAt;
  };
  struct Sending {
    RemoteImage image;
    int64_t readyAt = 0;
    bool hasBegun = false;  ///< the header has gone
    size_t sent = 0;        ///< bytes of colour and depth together
    size_t size() const { return image.color.size() + image.depth.size(); }
  };
  OutgoingMessage nextOfImage();

  std::vector<Text> texts_;
  std::optional<Sending> sending_;
  size_t sent_ = 0;
};

}  // namespace ocelli
