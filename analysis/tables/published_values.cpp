#include "analysis/tables/published_values.h"

#include <array>

namespace ocelli {
namespace {

using Sessions = std::array<PublishedPair, 3>;

PublishedPair ofSession(const Sessions& sessions, int session) {
  return session >= 1 && session <= 3 ? sessions[static_cast<size_t>(session - 1)] : PublishedPair{};
}

}  // namespace

PublishedPair publishedFindSeconds(bool moving) {
  return moving ? PublishedPair{12.6, 9.11} : PublishedPair{20.4, 13.3};
}

double publishedFindImprovement(bool moving) {
  return moving ? 27.8 : 34.8;
}

PublishedPair publishedTimeouts(bool moving) {
  return moving ? PublishedPair{1.90, 0.27} : PublishedPair{6.35, 6.35};
}

PublishedPair publishedTable71(bool moving, int session) {
  static const Sessions stationary{{{19.7, 12.9}, {15.7, 10.9}, {14.3, 9.2}}};
  static const Sessions ofMoving{{{11.6, 8.6}, {10.8, 8.5}, {9.0, 8.2}}};
  return ofSession(moving ? ofMoving : stationary, session);
}

std::optional<double> publishedImprovement71(bool moving, int session) {
  constexpr std::array<double, 3> kStationary{34.8, 30.6, 35.4};
  return !moving && session >= 1 && session <= 3 ? std::optional(kStationary[static_cast<size_t>(session - 1)])
                                                 : std::nullopt;
}

std::optional<double> publishedImprovement75(bool moving, int caseNumber) {
  return !moving && caseNumber == 3 ? std::optional(90.7) : std::nullopt;
}

PublishedPair publishedCounts(bool moving) {
  return moving ? PublishedPair{40.4, 92.4} : PublishedPair{43.6, 90.2};
}

PublishedPair publishedTable72(bool moving, double exposureSeconds) {
  if (moving) {
    return {};
  }
  return exposureSeconds == 5    ? PublishedPair{41.3, 84.7}
         : exposureSeconds == 10 ? PublishedPair{37.6, 93.0}
         : exposureSeconds == 20 ? PublishedPair{56.5, 90.8}
                                 : PublishedPair{};
}

PublishedPair publishedTable72(bool moving, bool duplicateColors) {
  if (moving) {
    return {};
  }
  return duplicateColors ? PublishedPair{40.9, 84.9} : PublishedPair{45.5, 94.4};
}

PublishedPair publishedTable73(bool moving, int session) {
  static const Sessions stationary{{{38.8, 89.6}, {50.4, 98.4}, {58.4, 98.4}}};
  static const Sessions ofMoving{{{39.6, 90.8}, {46.0, 98.0}, {47.6, 95.6}}};
  return ofSession(moving ? ofMoving : stationary, session);
}

PublishedPair publishedPaths(int session) {
  static const Sessions sessions{{{60.8, 64.0}, {72.0, 73.6}, {78.4, 76.0}}};
  return session == 0 ? PublishedPair{66.7, 69.8} : ofSession(sessions, session);
}

std::optional<double> publishedSurvey(const std::string& field) {
  return field == "easier_find"    ? std::optional(4.5)
         : field == "easier_count" ? std::optional(4.98)
         : field == "easier_path"  ? std::optional(2.7)
                                   : std::nullopt;
}

}  // namespace ocelli
