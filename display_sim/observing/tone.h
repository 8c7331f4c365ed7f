// From linear light to what an image file can hold.
#pragma once

#include <glm/vec3.hpp>
#include <optional>

#include "oc_core/image/image.h"

namespace ocelli {

enum class ToneCurve {
  kClip,      ///< as it is: above 1 is white
  kReinhard,  ///< L / (1 + L) of the luminance L; colours keep their proportions. E. Reinhard et al., SIGGRAPH 2002
  kFilmic,    ///< x (2.51 x + 0.03) / (x (2.43 x + 0.59) + 0.14) of each channel: K. Narkowicz's fit to ACES, 2015
};

struct Tone {
  double gain = 1;
  ToneCurve curve = ToneCurve::kClip;
  double gamma = 1;
};

/// The gain that takes the 99th percentile of the brightest channel of the lit pixels to 0.95, just below white; 1 for
/// an image without light.
double automaticGain(const Image<glm::vec3>& light);

/// The least automaticGain() of the images with light; 1 where none has any.
class CommonGain {
 public:
  void add(const Image<glm::vec3>& light);
  double gain() const { return least_.value_or(1); }

 private:
  std::optional<double> least_;
};

/// curve(light x gain)^(1 / gamma), where values above 1 stand for overexposure. `gamma` is that of the eye's or
/// camera's response; PNG files have their own encoding beside it.
void applyTone(Image<glm::vec3>& image, const Tone& tone);

}  // namespace ocelli
