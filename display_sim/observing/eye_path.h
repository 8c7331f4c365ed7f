// Where eyes are: both of a head, around the display, and along a recorded way.
#pragma once

#include <cstddef>
#include <filesystem>
#include <glm/vec3.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace ocelli {

struct EyePair {
  glm::vec3 left;
  glm::vec3 right;
};

/// Two eyes so far apart, on either side of `eye`, level, of a head that faces the display's centre. Both look there.
EyePair eyePair(const glm::vec3& eye, double separation);

/// The eye goes once around the display's axis in so many equal steps, counterclockwise seen from above: the display
/// seems to turn clockwise.
std::vector<glm::vec3> turntableEyes(const glm::vec3& eye, int count);

/// Where a head was at a time.
struct EyePose {
  double seconds = 0;
  glm::vec3 eye{0};  ///< in display radii
};

inline constexpr int kMaxFrames = 100000;

/// The first line of a .csv file.
inline constexpr std::string_view kEyePathHeader = "time,x,y,z";
/// One of its other lines; nullopt where it is none.
std::optional<EyePose> poseFromLine(std::string_view line);
/// What is wrong with a line that is no pose, for people: "3 values instead of 4", "x is not a number".
std::string problemOfLine(std::string_view line);

/// Poses in the order of their times. A .csv file has the header `time,x,y,z` and a line for each pose; a .json file is
/// {"poses": [{"time": 0, "eye": [0, 0, 10]}, ...]}. Throws InputError naming line or field.
std::vector<EyePose> readEyePath(const std::filesystem::path& path);
std::vector<EyePose> eyePathFromCsv(const std::string& text, const std::string& where);
std::vector<EyePose> eyePathFromJson(const std::string& text, const std::string& where);

/// Where the eye is at a time, on straight lines between poses; before the first and after the last it stays there.
glm::vec3 eyeAt(const std::vector<EyePose>& poses, double seconds);

/// The eye at equal intervals from the first pose to the last, on straight lines between poses. Throws InputError for
/// more than kMaxFrames.
std::vector<glm::vec3> eyesAlong(const std::vector<EyePose>& poses, double framesPerSecond);

/// Where one of these frames is: "at pose 3" or "between poses 2 and 3", counted from 1.
std::string placeOnWay(const std::vector<EyePose>& poses, double framesPerSecond, size_t frame);

}  // namespace ocelli
