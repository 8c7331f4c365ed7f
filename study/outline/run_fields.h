// The names of the fields of what a run of a study stores of its screen: a study writes them, an analysis reads them.
#pragma once

namespace ocelli::run_fields {

// Of the environment.
inline constexpr const char* kGraphics = "graphics";
inline constexpr const char* kRenderer = "renderer";
inline constexpr const char* kSoftware = "software";
inline constexpr const char* kMonitor = "monitor";
inline constexpr const char* kName = "name";
inline constexpr const char* kWidth = "width";  ///< pixels
inline constexpr const char* kHeight = "height";
inline constexpr const char* kRefreshHertz = "refresh_hertz";
inline constexpr const char* kWidthMillimeters = "width_millimeters";
inline constexpr const char* kHeightMillimeters = "height_millimeters";
inline constexpr const char* kPacedHertz = "paced_hertz";
inline constexpr const char* kNotMeasured = "not_measured";
/// Of a run without a screen, which a simulated subject makes.
inline constexpr const char* kSimulated = "simulated";

// Of the check of the timing.
inline constexpr const char* kVerdict = "verdict";
inline constexpr const char* kMeasured = "measured";
inline constexpr const char* kHertz = "hertz";
inline constexpr const char* kJitterShare = "jitter_share";
inline constexpr const char* kLateShare = "late_share";

}  // namespace ocelli::run_fields
