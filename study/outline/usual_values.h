// What tasks do where a protocol does not say it, and analyses tell of: each default stands here once.
#pragma once

namespace ocelli {

/// Of the views of who walks in a maze: "fov_horizontal_degrees".
inline constexpr double kUsualFovHorizontalDegrees = 70;
/// How long a subject may search in the task "find": "limit_seconds".
inline constexpr double kUsualFindLimitSeconds = 60;
/// Among how many maps a subject chooses in the task "path": "maps".
inline constexpr int kUsualPathMaps = 3;

}  // namespace ocelli
