// How far a picture of relief tiles is from the traced one.
//
// A pixel is in error where one of the two shows a tile and the other does not, or both do at depths that differ by
// more than 1.5 footprints of the picture: z / focal length in pixels, at the traced depth. Of them
//   missing  are those where the traced picture shows a tile, and the other something that lies farther away;
//   false    are those that show a point that no surface of the tiles is near, within 1.5 footprints: what the object
//            does not have ("rubber bands"). The others in error show a surface that there is, but not where it is
//            seen.
#pragma once

#include "oc_core/relief/relief_picture.h"

namespace ocelli {

enum class ReliefState : uint8_t {
  kElsewhere,  ///< neither shows a tile
  kRight,
  kMissing,
  kFalse,
  kOther,  ///< in error otherwise
};

/// The traced geometry of tiles and of what stands around them.
struct TracedTiles {
  const PlainGeometry& all;
  size_t tileTriangles = 0;  ///< the first ones of it are of tiles
  const RayScene& tiles;     ///< those alone
};

/// Traced eye rays and shadows, as ReliefRenderer::draw() gives them; every tile has the number 0.
ReliefPicture traceTiles(const TracedTiles& traced, const PinholeCamera& camera, const ReliefDrawing& how = {});

Image<ReliefState> reliefStates(const ReliefPicture& truth, const ReliefPicture& picture, const RayScene& tiles,
                                const PinholeCamera& camera);

struct ReliefFigures {
  size_t tilePixels = 0;  ///< that show a tile in the traced picture
  size_t wrong = 0;       ///< in error: the three below together
  size_t missing = 0;
  size_t falseSurface = 0;
  size_t other = 0;
  size_t sunPixels = 0;     ///< which show the same in both
  size_t shadowWrong = 0;   ///< of them, those that are in shadow in one of the two alone
  double squaredError = 0;  ///< of 8-bit sRGB, summed over the pixels and channels of tiles in either picture
  size_t comparedPixels = 0;

  double wrongShare() const;
  double psnrDecibels() const;  ///< infinite where they are equal
  ReliefFigures& operator+=(const ReliefFigures& more);
};

ReliefFigures reliefFigures(const ReliefPicture& truth, const ReliefPicture& picture, const Image<ReliefState>& states);

}  // namespace ocelli
