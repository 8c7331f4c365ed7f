// Pictures of what went wrong: the composed image beside the rendered one, the walker marked in both.
#pragma once

#include <array>
#include <filesystem>
#include <string>
#include <vector>

#include "oc_core/feeds_measure/walker_fates.h"
#include "oc_core/image/png_file.h"

namespace ocelli {

struct ErrorPicture {
  std::string file;  ///< in its folder
  WalkerFate fate = WalkerFate::kRight;
  size_t walker = 0;
  double seconds = 0;
  int width = 0;
  int height = 0;
};

/// `composed` beside `rendered`. A walker has a frame around what the image shows of it; where it shows nothing, a
/// broken one around where it is in the other image.
Image<Rgb8> markedPair(const Image<Rgb8>& composed, const WalkerArea& shown, const Image<Rgb8>& rendered,
                       const WalkerArea& wanted);

/// Keeps a few pictures of each kind of error, a while apart.
class ErrorPictures {
 public:
  explicit ErrorPictures(const std::filesystem::path& folder) : folder_(folder) {}

  bool wants(WalkerFate fate, double seconds) const;
  /// Writes it. Throws WorkError where it cannot.
  void add(WalkerFate fate, size_t walker, double seconds, const Image<Rgb8>& picture);
  const std::vector<ErrorPicture>& list() const { return list_; }

 private:
  std::filesystem::path folder_;
  std::vector<ErrorPicture> list_;
};

}  // namespace ocelli
