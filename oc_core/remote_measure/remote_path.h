// Paths of views for measuring remote visualisation: what a user would look at, a view a frame.
//
// A path is built in (a row of remotePaths()) or a JSON file with views at moments (remote_path.schema.json); between
// them eye, target, up and the logarithm of the zoom go on smoothly.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "oc_core/camera/view.h"

namespace ocelli {

struct RemotePath {
  std::string name;
  double framesPerSecond = 60;
  std::vector<View> views;  ///< with fields of view in degrees; at least one

  double secondsOf(size_t frame) const { return static_cast<double>(frame) / framesPerSecond; }
  double seconds() const { return secondsOf(views.size()); }
};

struct RemotePathKind {
  const char* name;
  const char* meaning;
  /// The view at a moment, of a path that begins at `start`.
  View (*at)(const View& start, double seconds);
};
std::span<const RemotePathKind> remotePaths();

inline constexpr size_t kMaxPathFrames = 100000;

/// A built-in path, or that of a file, whose own views and length are taken. Throws InputError for an unknown name and
/// for a file that is wrong. `frames` and `framesPerSecond` are positive; 0 frames stand for all of a file, and for 900
/// of a built-in one.
RemotePath remotePath(const std::string& nameOrFile, const View& start, size_t frames, double framesPerSecond);

/// The text of such a file.
RemotePath remotePathFromJson(const std::string& text, const std::string& where, size_t frames, double framesPerSecond);

}  // namespace ocelli
