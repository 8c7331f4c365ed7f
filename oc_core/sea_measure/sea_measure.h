// How good a sea of images is, and how small: against the images that it was made of, beside codecs that take each
// image by itself, and video in the order of the images.
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "oc_core/base/progress.h"
#include "oc_core/sea/sea_file.h"
#include "oc_core/sea/sea_source.h"

namespace ocelli {

struct SeaErrors {
  size_t images = 0;
  double flip = 0;  ///< mean over the images, as of SSIM
  double mostFlip = 0;
  double ssim = 0;
  double leastSsim = 1;
  double psnrDecibels = 0;  ///< of the mean squared error over all
};

/// What another way takes for the same images at the same FLIP.
struct SeaPeerResult {
  std::string name;
  std::string missing;  ///< why it could not be tried; then the rest is 0
  double quality = 0;   ///< as the codec has it
  double bytesPerImage = 0;
  double flip = 0;
  double ssim = 0;  ///< 0 where it was not asked for
  /// To have an image at random, seconds, one at a time; 0 where that was not measured.
  double secondsPerImage = 0;
};

struct SeaMeasureResult {
  SeaErrors errors;
  double bytesPerImage = 0;  ///< of the file
  double ratio = 0;          ///< of three bytes a pixel to that
  /// Images at random, whose pages the system has let go of, on all threads; and one after the other.
  double imagesPerSecond = 0;
  double secondsPerImage = 0;
  std::vector<SeaPeerResult> peers;
};

struct SeaMeasureOptions {
  size_t images = 24;                ///< that are compared, evenly chosen
  size_t timed = 64;                 ///< that are had at random
  size_t run = 120;                  ///< in a row, for video
  std::vector<std::string> peers{};  ///< names of rows of seaPeers()
};

/// What a peer is given.
struct SeaPeerInput {
  const SeaSource& source;
  std::span<const uint32_t> sample;  ///< the images that are compared
  size_t run = 0;                    ///< of video, images from the first on
  double flip = 0;                   ///< that it should have
  Progress progress;
};

/// Recipe for a new one: a row of the table in oc_core/sea_measure/sea_peers.cpp.
struct SeaPeer {
  std::string_view name;
  std::string_view meaning;
  std::function<SeaPeerResult(const SeaPeerInput& input)> measure;
};

const std::vector<SeaPeer>& seaPeers();
/// Throws InputError that lists them.
const SeaPeer& requireSeaPeer(const std::string& name);

/// Of the images that were chosen, which `image` gives as they come back. On all threads.
SeaErrors compareImages(const SeaSource& source, std::span<const uint32_t> sample,
                        const std::function<Image<Rgb8>(size_t index)>& image, bool withSsim = true,
                        const Progress& progress = {});

/// `source` holds the images that the sea was made of, in the same order. Throws InputError where it has another number
/// of them, or of another size.
SeaMeasureResult measureSea(const SeaFile& sea, const SeaSource& source, const SeaMeasureOptions& options,
                            const Progress& progress = {});

}  // namespace ocelli
