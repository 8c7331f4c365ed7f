// From what is stored of an image of a sea to the image: what building and reading share.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "oc_core/image/image.h"
#include "oc_core/image/png_file.h"
#include "oc_core/image_codecs/image_codec.h"
#include "oc_core/sea/hidden_samples.h"
#include "oc_core/sea/sea_proxy.h"
#include "oc_core/sea/sea_settings.h"
#include "oc_core/sea/warped_image.h"

namespace ocelli {

class SeaDecoder {
 public:
  /// `settings` are validated; `proxy` must outlive it.
  SeaDecoder(const SeaSettings& settings, const SeaProxy& proxy);

  const SeaSettings& settings() const { return settings_; }
  const SeaProxy& proxy() const { return proxy_; }
  const ColorCodec& iCodec() const { return *iCodec_; }
  const ColorCodec& pCodec() const { return *pCodec_; }

  /// These run on the calling thread alone, and any may call them. InputError for bytes that are no such image.
  Image<Rgb8> inner(std::span<const uint8_t> bytes) const;
  /// Of an I-node that has some.
  HiddenSamples hidden(std::span<const uint8_t> bytes) const;
  /// The image of an I-node, ready to be warped, with its hidden samples, unless there are no bytes of these.
  WarpReference innerReference(std::span<const uint8_t> bytes, std::span<const uint8_t> hiddenBytes) const;
  /// What an image looks like from `target`, as far as `reference` and its hidden samples tell; the rest is filled
  /// smoothly.
  Image<Rgb8> predicted(const WarpReference& reference, const SeaPose& referencePose, const SeaPose& target) const;
  Image<Rgb8> residual(std::span<const uint8_t> bytes) const;

 private:
  Image<Rgb8> decoded(const ColorCodec& codec, std::span<const uint8_t> bytes) const;

  SeaSettings settings_;
  const SeaProxy& proxy_;
  const ColorCodec* iCodec_;
  const ColorCodec* pCodec_;
};

}  // namespace ocelli
