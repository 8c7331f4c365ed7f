// Which cameras have rays that differ smoothly between neighbours: those of a small part of an image can then be placed
// between the rays of its corners.
#pragma once

namespace ocelli {

class CurvedRayCamera;

/// Whether all rays of a camera have as many points, each a smooth function of the pixel all over the image, and it is
/// worth placing them so: a camera for which that is so gets a row here. A pinhole's rays cost little as they are, and
/// placed so the light of nearly flat places differed by 4e-4.
template <class C>
inline constexpr bool kHasSmoothRays = false;
template <>
inline constexpr bool kHasSmoothRays<CurvedRayCamera> = true;

}  // namespace ocelli
