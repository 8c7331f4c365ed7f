// Hidden samples as they stand in the file of a sea: docs/sea_format.md says all of it.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "oc_core/image_codecs/image_codec.h"
#include "oc_core/sea/hidden_samples.h"

namespace ocelli {

/// Nothing where there are no samples. Layers are of `projection`'s size.
std::vector<uint8_t> hiddenBytes(const HiddenSamples& hidden, const SeaProjection& projection, const ColorCodec& codec,
                                 double quality);

/// Throws InputError, naming `where`, for bytes that are no hidden samples of an image of this size.
HiddenSamples hiddenFromBytes(std::span<const uint8_t> bytes, const SeaProjection& projection, const ColorCodec& codec,
                              const std::string& where);

}  // namespace ocelli
