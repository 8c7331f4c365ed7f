// How a sea was built: what its file says of itself, as JSON.
#pragma once

#include <string>

#include "oc_core/sea/sea_projection.h"
#include "oc_core/sea/sea_tree.h"
#include "oc_core/sea/warp_map.h"

namespace ocelli {

struct SeaSettings {
  std::string source;  ///< of the images: as the user wrote it
  SeaProjection projection;
  SeaWay way = SeaWay::kDirect;
  int spacing = 4;  ///< levels of the tree below an I-node, as in the text
  /// Codecs of oc_core/image_codecs by name, and their qualities. The text has JPEG at 75 and 65; images that are coded
  /// well predict so much better that fewer bytes are left for the same error (docs/sea_of_images.md).
  std::string iCodec = "jpeg_baseline";
  std::string pCodec = "jpeg_baseline";
  double iQuality = 92;
  double pQuality = 30;
  /// Residuals of little energy get a quality that is lower by up to this share (text: 0.3).
  double adaptive = 0.3;
  std::string refinement = "none";  ///< of poses: a name of pose_refinement.h
  int warpCell = kWarpCell;
  /// The kind of reference image (oc_core/ocri) that chose the hidden samples of I-nodes (hidden_samples.h), or
  /// kNoHidden.
  std::string hidden = kNoHidden;
  double hiddenQuality = 30;  ///< of their colours, in the codec of I-nodes
  int hiddenViews = 3;        ///< images that hang on an I-node and see a sample, at least, for it to be stored

  static constexpr const char* kNoHidden = "none";
  bool hasHidden() const { return hidden != kNoHidden; }

  bool operator==(const SeaSettings&) const = default;
};

/// Throws InputError, naming `where`, for codecs and refinements that this build does not know, and numbers out of
/// range.
void validate(const SeaSettings& settings, const std::string& where);

std::string jsonText(const SeaSettings& settings);
/// Throws InputError as validate() does, and for fields that are missing or unknown.
SeaSettings seaSettingsFromJson(const std::string& text, const std::string& where);

}  // namespace ocelli
