#include "display_sim/gl/gl_volume.h"

#include <algorithm>
#include <array>
#include <utility>

#include "oc_core/base/error.h"
#include "oc_core/base/parallel.h"
#include "oc_core/gl/gl_api.h"

namespace ocelli {
namespace {

constexpr size_t kSliceGrain = 8;
/// Shaders count voxels, of which a word has eight, in 32 bits.
constexpr size_t kMaxBytes = size_t{1} << 31;

/// The bits of a byte four apart.
constexpr std::array<uint32_t, 256> kSpread = [] {
  std::array<uint32_t, 256> spread{};
  for (uint32_t byte = 0; byte < 256; ++byte) {
    for (uint32_t bit = 0; bit < 8; ++bit) {
      spread[byte] |= (byte >> bit & 1u) << 4 * bit;
    }
  }
  return spread;
}();

/// The other way round: every fourth bit of a word.
uint8_t gathered(uint32_t word) {
  word &= 0x11111111u;
  word = (word | word >> 3) & 0x03030303u;
  word = (word | word >> 6) & 0x000f000fu;
  return static_cast<uint8_t>(word | word >> 12);
}

GlObject makeWords(GlContext& context, const DisplayProfile& profile, size_t words, const uint32_t* data) {
  const GlScope scope(context);
  if (profile.colorBitsPerChannel != 1) {
    throw InputError(
        "the GPU takes displays of one bit a channel, and not of " + std::to_string(profile.colorBitsPerChannel),
        "color_bits_per_channel of profile " + profile.name, "leave out --method gl: slice and observe without OpenGL");
  }
  const size_t bytes = words * sizeof(uint32_t);
  const size_t most = std::min(static_cast<size_t>(context.info().maxStorageBytes), kMaxBytes);
  if (bytes > most) {
    throw GlError("a volume of this display takes " + std::to_string(bytes >> 20) + " MiB, and this GPU's shaders " +
                      "address at most " + std::to_string(most >> 20) + " MiB",
                  "profile " + profile.name, "use a profile with fewer voxels, or slice and observe without OpenGL");
  }
  return makeBuffer(context, bytes, data);
}

std::vector<uint32_t> wordsOf(const Volume& volume) {
  const VolumeLayout& layout = volume.layout();
  std::vector<uint32_t> words(layout.slices * layout.planeBytes);
  parallelFor(layout.slices, kSliceGrain, [&](size_t begin, size_t end) {
    for (size_t i = begin; i < end; ++i) {
      const uint8_t* red = volume.slice(static_cast<int>(i)).data();
      const uint8_t* green = red + layout.planeBytes;
      const uint8_t* blue = green + layout.planeBytes;
      uint32_t* slice = words.data() + i * layout.planeBytes;
      for (size_t at = 0; at < layout.planeBytes; ++at) {
        slice[at] = kSpread[red[at]] | kSpread[green[at]] << 1 | kSpread[blue[at]] << 2;
      }
    }
  });
  return words;
}

}  // namespace

GlVolume::GlVolume(GlContext& context, DisplayProfile profile)
    : context_(&context),
      profile_(std::move(profile)),
      layout_(profile_),
      words_(makeWords(context, profile_, wordCount(), nullptr)) {
  clear();
}

GlVolume::GlVolume(GlContext& context, const Volume& volume)
    : context_(&context),
      profile_(volume.profile()),
      layout_(profile_),
      words_(makeWords(context, profile_, wordCount(), wordsOf(volume).data())) {}

void GlVolume::clear() {
  const GlScope scope(*context_);
  context_->gl().ClearNamedBufferData(words_.id(), GL_R32UI, GL_RED_INTEGER, GL_UNSIGNED_INT, nullptr);
  context_->check("clearing a volume");
}

Volume GlVolume::read() const {
  std::vector<uint32_t> words(wordCount());
  {
    const GlScope scope(*context_);
    readBuffer(*context_, words_, words.size() * sizeof(uint32_t), words.data());
  }
  Volume volume(profile_);
  parallelFor(layout_.slices, kSliceGrain, [&](size_t begin, size_t end) {
    for (size_t i = begin; i < end; ++i) {
      uint8_t* planes = volume.slice(static_cast<int>(i)).data();
      const uint32_t* slice = words.data() + i * layout_.planeBytes;
      for (size_t at = 0; at < layout_.planeBytes; ++at) {
        if (slice[at] != 0) {
          for (size_t channel = 0; channel < kColorChannels; ++channel) {
            planes[channel * layout_.planeBytes + at] = gathered(slice[at] >> channel);
          }
        }
      }
    }
  });
  return volume;
}

}  // namespace ocelli
