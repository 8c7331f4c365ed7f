// Sort-last compositing: each rank has drawn its share of a scene, and at each pixel the nearest of what they hold is
// kept. Which of two is nearer depends on nothing but the two (depth, then the triangle's index), so the image is the
// same, byte for byte, for any number of ranks and both ways to bring the pixels together.
//
// Direct send (Hsu 1993; Neumann 1994): each rank owns a part of the image, gets it from all others and keeps the
// nearest. Binary swap (Ma, Painter, Hansen and Krogh 1994): in log2(N) rounds pairs of ranks halve the part that both
// hold. DEVIATION: numbers of ranks that are no power of two are folded first: each rank above the largest power hands
// its image to one below. Then all parts go to all ranks, since each goes on with the whole image: what it decides from
// it, all decide alike.
#pragma once

#include <algorithm>
#include <bit>
#include <span>
#include <string>

#include "oc_core/compositing/pixel_runs.h"
#include "oc_core/render/fragment_image.h"

namespace ocelli {

enum class Compositing {
  kDirectSend,
  kBinarySwap,
};

/// "direct" and "swap". Throws InputError, naming `where`, for others.
Compositing compositingFromText(const std::string& text, const std::string& where);

/// How fragments are compared: `holds(pixel)`, and whether `a` is nearer than `b`.
struct NearestFragment {
  static bool holds(const Fragment& f) { return f.covered(); }
  static bool isNearer(const Fragment& a, const Fragment& b) {
    return a.covered() && (!b.covered() || a.t < b.t || (a.t == b.t && a.triangle < b.triangle));
  }
};

/// One composite of the pixels of a rank with those of the others; all ranks have as many pixels. `Order` as
/// NearestFragment.
template <class Order, class Pixel>
class Composite {
 public:
  Composite(std::span<Pixel> pixels, Ranks& ranks) : pixels_(pixels), ranks_(ranks) {}

  /// Afterwards each rank has the nearest at every pixel.
  void run(Compositing how) {
    if (ranks_.size() == 1) {
      return;
    }
    const RankShare mine = how == Compositing::kDirectSend ? sendDirectly() : swap();
    const Bytes packed = pack(mine);
    for (const Bytes& part : ranks_.gatherToAll(packed)) {
      unpackRuns<Pixel>(part, pixels_.size(), [&](size_t i, const Pixel& pixel) { pixels_[i] = pixel; });
    }
  }

 private:
  Bytes pack(const RankShare& part) const {
    return packRuns<Pixel>(std::span<const Pixel>(pixels_), part.begin, part.end, Order::holds);
  }
  void merge(std::span<const std::byte> bytes) {
    unpackRuns<Pixel>(bytes, pixels_.size(), [&](size_t i, const Pixel& pixel) {
      if (Order::isNearer(pixel, pixels_[i])) {
        pixels_[i] = pixel;
      }
    });
  }

  /// Both return the part of the image that is finished here.
  RankShare sendDirectly() {
    std::vector<Bytes> pieces(static_cast<size_t>(ranks_.size()));
    for (int rank = 0; rank < ranks_.size(); ++rank) {
      if (rank != ranks_.rank()) {
        pieces[static_cast<size_t>(rank)] = pack(shareOfRank(pixels_.size(), rank, ranks_.size()));
      }
    }
    for (const Bytes& piece : ranks_.exchangeAll(pieces)) {
      merge(piece);
    }
    return shareOfRank(pixels_.size(), ranks_.rank(), ranks_.size());
  }
  RankShare swap() {
    const int power = static_cast<int>(std::bit_floor(static_cast<unsigned>(ranks_.size())));
    const int rank = ranks_.rank();
    const RankShare all{0, pixels_.size()};
    if (rank >= power) {
      ranks_.exchange(rank - power, pack(all));
      return {0, 0};
    }
    if (rank + power < ranks_.size()) {
      merge(ranks_.exchange(rank + power, {}));
    }
    RankShare held = all;
    for (int bit = 1; bit < power; bit <<= 1) {
      const size_t middle = held.begin + held.size() / 2;
      const RankShare first{held.begin, middle};
      const RankShare second{middle, held.end};
      const bool keepsFirst = (rank & bit) == 0;
      const Bytes other = ranks_.exchange(rank ^ bit, pack(keepsFirst ? second : first));
      held = keepsFirst ? first : second;
      merge(other);
    }
    return held;
  }

  std::span<Pixel> pixels_;
  Ranks& ranks_;
};

/// The nearest fragment at each pixel of the images that all ranks hold, of the same size.
inline void compositeNearest(FragmentImage& image, Ranks& ranks, Compositing how) {
  Composite<NearestFragment, Fragment>({image.data(), image.size()}, ranks).run(how);
}

}  // namespace ocelli
