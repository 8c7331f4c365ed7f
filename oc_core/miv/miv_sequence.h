// Views with depth as a sequence of one frame for the test model of MPEG immersive video (TMIV, ISO/IEC 23090-12): a
// folder of raw video and a JSON file of cameras.
//
//   CONTENT.json                          the sequence: bounding box, cameras
//   NAME_texture_WxH_yuv420p10le.yuv      colours: Y, then Cb and Cr of half the width and height, 10 bits in 16
//   NAME_depth_WxH_yuv420p16le.yuv        depths: 16 bits, in equal steps of 1/z; both chroma planes are neutral
//
// The fields are those that TMIV's own reader asks for (MivBitstream/SequenceConfig.cpp and its test;
// docs/views_with_depth.md has the list). Colours are BT.709, narrow range, of sRGB-encoded light: TMIV converts none.
#pragma once

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <string>
#include <vector>

#include "oc_core/camera/view.h"
#include "oc_core/image/image.h"

namespace ocelli {

/// One view: of a pinhole, or a panorama (panorama_camera.h).
struct MivView {
  std::string name;  ///< letters, digits, "-" and "_": a part of file names
  View view;
  bool isPanorama = false;
  Image<glm::vec3> color;  ///< linear
  /// z along the view direction, of panoramas the length of the ray, world units; 0 where nothing is seen.
  Image<float> depth;
};

struct MivSequence {
  std::string content;  ///< name of the sequence: as MivView::name
  double unitsPerMetre = 1;
  std::vector<MivView> views;
};

inline constexpr int kMivColorBits = 10;
inline constexpr int kMivDepthBits = 16;
inline constexpr int kMaxMivDepthLevel = 65535;
/// TMIV takes a depth from here on for infinity.
inline constexpr double kMivInfinityMetres = 1000;

/// Throws InputError for what has no such form: no views, two of one name, names that are no part of file names, sizes
/// that are odd or differ between colour and depth, a depth that is not finite, a view without depth, and depths of
/// kMivInfinityMetres and more.
void validate(const MivSequence& sequence);

/// Of all views: depths in metres, a little beyond the nearest and the farthest. Far is less than kMivInfinityMetres.
struct MivDepthRange {
  double near = 0;
  double far = 0;
};
MivDepthRange depthRangeOf(const MivView& view, double unitsPerMetre);

std::string mivTextureFile(const std::string& name, int width, int height);
std::string mivDepthFile(const std::string& name, int width, int height);

}  // namespace ocelli
