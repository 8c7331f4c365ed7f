// The colours of a subject as a feed sees it: how often each occurs among the legs, the trunk and the head. They are
// what tells two subjects apart whose bodies overlap in the image.
#pragma once

#include <array>
#include <vector>

#include "oc_core/image/png_file.h"

namespace ocelli {

class SubjectColors {
 public:
  /// The bin of a colour.
  static uint16_t binOf(const Rgb8& color);
  /// The part of a body at a height, as a share of the body's.
  static size_t partAt(float height);

  /// A cell of this colour was seen in a part of the body.
  void add(size_t part, uint16_t bin);
  /// Whether enough was seen to tell anything.
  bool isKnown() const;
  /// What was seen until now counts for a little less.
  void forget();
  /// The logarithm of how much more often a colour occurs in a part than if all were alike; 0 where too little was
  /// seen.
  float likeness(size_t part, uint16_t bin) const;
  /// The mean of that over all that was seen of another one.
  float likenessOf(const SubjectColors& other) const;

 private:
  static constexpr size_t kParts = 3;
  static constexpr int kLightBins = 5;
  static constexpr int kHueBins = 12;  ///< of red and of green among all three
  static constexpr size_t kBins = static_cast<size_t>(kLightBins) * kHueBins * kHueBins;

  struct Part {
    std::vector<float> counts;
    float sum = 0;
  };
  std::array<Part, kParts> parts_;
};

}  // namespace ocelli
