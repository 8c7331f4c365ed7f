// What a client of remote visualisation (section 5.2.1) asks for: what it looks at, how large its screen is, and where
// its lenses are. Its JSON form is the message "look" of docs/remote_protocol.md.
#pragma once

#include <cstddef>
#include <cstdint>
#include <glm/vec2.hpp>
#include <string>
#include <vector>

#include "oc_core/camera/gpc_layout.h"
#include "oc_core/camera/view.h"

namespace ocelli {

struct RemoteRequest {
  static constexpr int kMinScreen = 16;
  static constexpr int kMaxScreen = 4096;
  static constexpr size_t kMaxLenses = 8;
  static constexpr size_t kMaxTextBytes = size_t{16} << 10;
  static constexpr double kMinFovDegrees = 1e-3;  ///< vertical: below it, rays are the same in single precision

  uint32_t sequence = 0;  ///< from 0 to 2^31 - 1; answers repeat it
  View view;
  glm::ivec2 screen{1280, 720};  ///< pixels
  /// Where the screen shows more, in shares of its width and height. Each lies in the screen with its middle; they may
  /// overlap, and reach over the borders.
  std::vector<GpcRegion> lenses{};

  bool operator==(const RemoteRequest&) const = default;
};

/// Throws InputError where a number is out of the ranges above, or the view is not valid (view.h).
void validate(const RemoteRequest& request, const std::string& where);

/// Strict: throws InputError for a text that is too long, is no JSON, or has a field that is missing, unknown or out of
/// its range, and as validate().
RemoteRequest remoteRequestFromJson(const std::string& text);
std::string jsonText(const RemoteRequest& request);

}  // namespace ocelli
