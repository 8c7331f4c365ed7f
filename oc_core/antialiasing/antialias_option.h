// How an image is antialiased, as a user writes it: `none`, `msaa-16`, `uniform-64`, `area-256`,
// `extreme,tile=640x720,regions=auto`. Ways are rows of antialiasMethods(), and what can be said of them, rows of
// antialiasKeys(): the parser, the help of `ocelli render` and the documentation come from them.
//
// A new way is a row in antialias_option.cpp, with the rule that it makes of a choice.
#pragma once

#include <memory>
#include <span>
#include <string>
#include <vector>

#include "oc_core/antialiasing/antialias_regions.h"
#include "oc_core/antialiasing/region_file.h"

namespace ocelli {

struct AntialiasMethod;

struct AntialiasChoice {
  const AntialiasMethod* method = nullptr;
  std::string text;  ///< as the user wrote it
  int samples = 1;   ///< a pixel
  // What follows is as the way's keys say, or their defaults; of ways without the key it says nothing.
  const SamplePlacement* placement = nullptr;
  size_t maxExactTriangles = 0;
  AntialiasTile tile;
  double dense = 0;                                ///< triangles a pixel from which on there is a region
  std::string regions;                             ///< "auto", "objects", or "file"
  std::vector<RegionRequest> requested;            ///< of the file
  std::shared_ptr<const AntialiasChoice> outside;  ///< of the regions
};

struct AntialiasMethod {
  const char* name;
  const char* description;
  /// Whether it may have so many samples a pixel; none where it has no number.
  bool (*allows)(int samples);
  const char* allowed;            ///< the same in words; empty where it has no number
  std::vector<const char*> keys;  ///< rows of antialiasKeys()
  PixelRule (*rule)(const AntialiasChoice& choice);
  bool hasRegions = false;  ///< then the rule is that of its outside
};

struct AntialiasKey {
  const char* name;
  const char* values;    ///< what may stand after "="
  const char* standard;  ///< the value where it is not given
  const char* description;
  /// Throws InputError for a value that is wrong.
  void (*read)(const AntialiasKey& key, AntialiasChoice& choice, const std::string& value, const std::string& where);
  double min = 0;  ///< of numbers; of others both are 0
  double max = 0;
};

const std::vector<AntialiasMethod>& antialiasMethods();
const std::vector<AntialiasKey>& antialiasKeys();
/// What it means, its range and its default, as the help and the documentation say.
std::string describeAntialiasKey(const AntialiasKey& key);
/// A line for each way, and one for each key.
std::string antialiasHelp();

/// Throws InputError that lists the valid ways, numbers, keys or values. `where` is the option.
AntialiasChoice antialiasChoice(const std::string& text, const std::string& where);

/// The most samples of all regions of an image together: they take time, though no memory.
inline constexpr int64_t kMaxRegionSamples = int64_t{1} << 34;

/// The regions of a choice in an image. Throws InputError where one is smaller than a pixel, where they have more
/// samples than that, and where regions are asked for by objects but there is none. `objectOfTriangle` is that of the
/// mesh: only for regions by objects.
std::vector<AntialiasRegion> antialiasRegions(const AntialiasChoice& choice, const AntialiasScene& scene,
                                              const std::vector<uint32_t>& objectOfTriangle = {});

/// How each pixel is drawn, with these regions where the choice has some.
AntialiasPlan antialiasPlan(const AntialiasChoice& choice, const AntialiasView& view,
                            const std::vector<AntialiasRegion>& regions);

/// For cameras that are drawn by rays alone. Throws InputError for ways that are not of samples everywhere.
SamplePattern rayPattern(const AntialiasChoice& choice, const std::string& where);

}  // namespace ocelli
