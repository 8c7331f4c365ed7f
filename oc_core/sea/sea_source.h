// Where the images of a sea come from: files, or a scene that is rendered.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "oc_core/image/image.h"
#include "oc_core/image/png_file.h"
#include "oc_core/sea/sea_projection.h"

namespace ocelli {

class SeaSource {
 public:
  virtual ~SeaSource() = default;

  /// As the user wrote it.
  virtual std::string description() const = 0;
  virtual const SeaProjection& projection() const = 0;
  /// Of all images; each has a place of its own.
  virtual const std::vector<SeaPose>& poses() const = 0;
  /// Of all images, or empty.
  virtual const std::vector<std::string>& names() const = 0;
  /// On the calling thread alone; any may call it. Throws InputError where a file is missing or of another size.
  virtual Image<Rgb8> image(uint32_t index) const = 0;
};

/// Throws InputError, naming `where` and both images, where two stand at one place, or a pose is no pose.
void validatePoses(const std::vector<SeaPose>& poses, const std::vector<std::string>& names, const std::string& where);

/// What messages call an image: its name, or its number.
std::string imageName(const std::vector<std::string>& names, size_t image);

}  // namespace ocelli
