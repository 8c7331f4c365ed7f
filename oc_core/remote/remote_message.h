// What a server of remote visualisation and its clients tell each other, written and read in one place:
// docs/remote_protocol.md. A client sends requests alone (remote_request.h).
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <variant>
#include <vector>

#include "oc_core/camera/view.h"
#include "oc_core/remote/remote_image.h"
#include "oc_core/remote/remote_request.h"
#include "oc_core/remote/remote_settings.h"
#include "oc_core/scene/box.h"

namespace ocelli {

/// The first message of a server.
struct RemoteHello {
  static constexpr int kVersion = 1;

  int version = kVersion;
  std::string scene;                    ///< its name
  View view;                            ///< to begin with
  Box box{glm::vec3(0), glm::vec3(0)};  ///< around the scene
  RemoteSettings settings;
  int maxScreen = RemoteRequest::kMaxScreen;  ///< pixels a side of the screens that it draws for
};

/// A request waits.
struct RemoteQueued {
  uint32_t sequence = 0;
  int before = 0;  ///< requests of other clients that come before it
};

/// Its image is being drawn.
struct RemoteDrawing {
  uint32_t sequence = 0;
};

struct RemoteFailure {
  std::string message;
  std::optional<uint32_t> sequence{};  ///< of the request that failed, where it is known
};

using RemoteServerMessage = std::variant<RemoteHello, RemoteQueued, RemoteDrawing, RemoteImageHeader, RemoteFailure>;

std::string jsonText(const RemoteHello& hello);
std::string jsonText(const RemoteQueued& queued);
std::string jsonText(const RemoteDrawing& drawing);
std::string jsonText(const RemoteFailure& failure);
/// Throws InputError for a text that is no message of a server.
RemoteServerMessage remoteServerMessageFromJson(const std::string& text);

enum class RemotePlane : uint8_t { kColor = 0, kDepth = 1 };

/// A part of the bytes of an image.
struct RemotePiece {
  static constexpr size_t kHeaderBytes = 12;
  static constexpr size_t kMaxMessageBytes = size_t{32} << 10;
  static constexpr size_t kMaxBytes = kMaxMessageBytes - kHeaderBytes;

  uint32_t id = 0;  ///< of the image
  RemotePlane plane = RemotePlane::kColor;
  uint32_t offset = 0;  ///< of the first of the bytes in the plane
  std::span<const std::byte> bytes;
};

/// The binary message of a piece; it has 1 to kMaxBytes bytes.
std::vector<std::byte> messageOf(const RemotePiece& piece);
/// Its bytes are those of `message`. Throws InputError for one that is no piece.
RemotePiece pieceOf(std::span<const std::byte> message);
/// Of all bytes of an image, in the order in which they are sent: colours, then depths. They refer to the image.
std::vector<RemotePiece> piecesOf(const RemoteImage& image);

/// Gathers the bytes of one image from its pieces, in any order.
class RemoteAssembly {
 public:
  explicit RemoteAssembly(RemoteImageHeader header);

  const RemoteImageHeader& header() const { return header_; }
  /// Throws InputError for a piece of another image, beyond the bytes that the header promises, or one of which a
  /// byte has come already.
  void add(const RemotePiece& piece);
  bool hasColor() const { return color_.missing == 0; }
  bool hasDepth() const { return depth_.missing == 0; }
  size_t received() const;
  size_t expected() const { return header_.colorBytes + header_.depthBytes; }
  const std::vector<std::byte>& color() const { return color_.bytes; }
  const std::vector<std::byte>& depth() const { return depth_.bytes; }

 private:
  struct Plane {
    std::vector<std::byte> bytes;
    std::vector<bool> has;
    size_t missing = 0;
  };

  RemoteImageHeader header_;
  Plane color_;
  Plane depth_;
};

}  // namespace ocelli
