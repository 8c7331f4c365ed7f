// A light-field display as data: it takes one image, a quilt, whose tiles are views from viewpoints along a line.
//
// The built-in rows, the order of the tiles, the names of files and the cone of 40 degrees are those that Looking Glass
// Factory publishes (its documentation; the library Looking-Glass/looking-glass-webxr on GitHub).
//
// Tiles stand in columns and rows. View 0 is seen from the left end of the line and lies at the bottom left; the others
// follow to the right, then upwards. A tile has the aspect of the display, so its pixels need not be square.
//
// To add a display: one row in quilt_display.cpp. A display of your own needs no build: `--display FILE.json`, whose
// fields quilt_display.schema.json describes. From outside of the tree: registerQuiltDisplay().
#pragma once

#include <cstddef>
#include <glm/vec2.hpp>
#include <string>
#include <vector>

#include "oc_core/base/registry.h"

namespace ocelli {

struct QuiltDisplay {
  std::string name;
  int columns = 8;
  int rows = 6;
  int width = 3360;  ///< of the quilt, pixels
  int height = 3360;
  double aspect = 0.75;  ///< width to height of what the display shows
  /// The angle between the outermost views, as seen from the middle of the display. A display's own calibration says
  /// it; 40 degrees is what one public library takes without.
  double coneDegrees = 40;

  int viewCount() const { return columns * rows; }
  /// Pixels; what a division leaves over stays black, on the right and at the top.
  int tileWidth() const { return width / columns; }
  int tileHeight() const { return height / rows; }
  /// Of all tiles together.
  size_t tilePixels() const {
    return static_cast<size_t>(tileWidth()) * static_cast<size_t>(tileHeight()) * static_cast<size_t>(viewCount());
  }
  /// Width to height of a pixel of a tile, as the display shows it.
  double pixelAspect() const { return aspect * tileHeight() / tileWidth(); }

  bool operator==(const QuiltDisplay&) const = default;
};

inline constexpr int kMaxQuiltSide = 16384;  ///< pixels
inline constexpr double kMinConeDegrees = 1;
inline constexpr double kMaxConeDegrees = 120;

/// The built-in ones, then those that were registered.
Rows<QuiltDisplay> quiltDisplays();
/// Throws InputError where its name is taken, and as validate() does.
void registerQuiltDisplay(QuiltDisplay display);

/// Throws InputError where a number is out of range, a tile has no pixel, or there are fewer than two views.
void validate(const QuiltDisplay& display, const std::string& where);

/// Throws InputError naming the field that is missing, unknown or out of range.
QuiltDisplay quiltDisplayFromJsonText(const std::string& text, const std::string& where);
std::string jsonText(const QuiltDisplay& display);
/// The text of quilt_display.schema.json.
std::string quiltDisplaySchemaText();
/// What `--display` takes: the name of a display, or a file whose name ends in `.json`. Throws InputError.
QuiltDisplay loadQuiltDisplay(const std::string& nameOrFile);

/// The top left pixel of the tile of a view.
glm::ivec2 tileOriginOf(const QuiltDisplay& display, int view);

/// What readers of quilts expect at the end of a file's name: "_qs8x6a0.75".
std::string quiltSuffix(const QuiltDisplay& display);
/// `path` with the suffix before its ending. One that has it already stays. Throws InputError where it has that of
/// another quilt.
std::string quiltFileName(const std::string& path, const QuiltDisplay& display);

}  // namespace ocelli
