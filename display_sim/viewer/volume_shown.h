// What the viewer shows of a volume, as plain data.
#pragma once

#include <array>
#include <glm/vec2.hpp>
#include <optional>
#include <vector>

#include "display_sim/viewer/transfer_editor.h"
#include "display_sim/viewer/value_axis.h"

namespace ocelli {

struct VolumeShown {
  static constexpr std::array<glm::dvec2, 3> kWhole{{{0, 1}, {0, 1}, {0, 1}}};

  bool on = false;                           ///< the scene is a volume, or is to be one that is being loaded
  std::optional<TransferEditor> transfer{};  ///< nothing before the volume has come
  ValueAxis values{};                        ///< all that the pane of the transfer function can show
  ValueAxis axis{};                          ///< those that it shows
  /// What is shown along x, y and z of the scene, as shares of the volume's box: the rest is clipped.
  std::array<glm::dvec2, 3> kept = kWhole;
  /// A constructor of graph or curved ray cameras, by its name or file, along whose rays the volume is seen; empty: the
  /// camera of the other panes.
  std::string rays{};
};

/// The planes that clip a volume in the viewer: those it was loaded with, and those of what `kept` leaves out.
std::vector<ClipPlane> clipsOf(const VolumeScene& scene, const std::array<glm::dvec2, 3>& kept);
/// The planes that clip what `kept` leaves out; none where it leaves out nothing.
std::vector<ClipPlane> clipPlanesOf(const std::array<glm::dvec2, 3>& kept, const Box& bounds);

}  // namespace ocelli
