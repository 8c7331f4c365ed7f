#include "oc_core/sea/sea_decoder.h"

#include <utility>

#include "oc_core/base/parallel.h"
#include "oc_core/sea/hidden_bytes.h"

namespace ocelli {

SeaDecoder::SeaDecoder(const SeaSettings& settings, const SeaProxy& proxy)
    : settings_(settings),
      proxy_(proxy),
      iCodec_(findColorCodec(settings.iCodec)),
      pCodec_(findColorCodec(settings.pCodec)) {
  OC_CHECK(iCodec_ != nullptr && pCodec_ != nullptr, "settings are validated");
}

Image<Rgb8> SeaDecoder::decoded(const ColorCodec& codec, std::span<const uint8_t> bytes) const {
  Image<Rgb8> image;
  runAlone([&] {
    image = codec.decode(std::as_bytes(bytes), {settings_.projection.width, settings_.projection.height});
  });
  return image;
}

Image<Rgb8> SeaDecoder::inner(std::span<const uint8_t> bytes) const {
  return decoded(*iCodec_, bytes);
}

HiddenSamples SeaDecoder::hidden(std::span<const uint8_t> bytes) const {
  HiddenSamples hidden;
  runAlone([&] { hidden = hiddenFromBytes(bytes, settings_.projection, *iCodec_, "the hidden samples of an I-node"); });
  return hidden;
}

WarpReference SeaDecoder::innerReference(std::span<const uint8_t> bytes, std::span<const uint8_t> hiddenBytes) const {
  WarpReference reference(inner(bytes), settings_.projection);
  if (!hiddenBytes.empty()) {
    reference.setHidden(std::make_shared<const HiddenSamples>(hidden(hiddenBytes)));
  }
  return reference;
}

Image<Rgb8> SeaDecoder::predicted(const WarpReference& reference, const SeaPose& referencePose,
                                  const SeaPose& target) const {
  PartialImage partial =
      warpedOver(proxy_, reference, referencePose, {settings_.projection, target}, settings_.warpCell);
  if (reference.hidden() != nullptr) {
    addHidden(partial, proxy_, {settings_.projection, target}, {settings_.projection, referencePose},
              *reference.hidden());
  }
  fillUnknown(partial);
  return std::move(partial.image);
}

Image<Rgb8> SeaDecoder::residual(std::span<const uint8_t> bytes) const {
  return decoded(*pCodec_, bytes);
}

}  // namespace ocelli
