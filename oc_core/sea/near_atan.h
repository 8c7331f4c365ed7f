// The angle of a direction by a polynomial, for loops over many pixels.
#pragma once

#include <algorithm>
#include <cmath>

namespace ocelli {

/// std::atan2(y, x) to within 1e-6; 0 where both are 0. Source: Abramowitz and Stegun, 4.4.49.
inline float nearAtan2(float y, float x) {
  constexpr float kHalfTurn = 3.14159265358979f;
  const float ax = std::abs(x);
  const float ay = std::abs(y);
  const float most = std::max(ax, ay);
  const float t = most > 0 ? std::min(ax, ay) / most : 0.0f;
  const float s = t * t;
  float angle = -0.0040540580f;
  for (const float c :
       {0.0218612288f, -0.0559098861f, 0.0964200441f, -0.1390853351f, 0.1994653599f, -0.3332985605f, 0.9999993329f}) {
    angle = angle * s + c;
  }
  angle *= t;
  angle = ay > ax ? kHalfTurn / 2 - angle : angle;
  angle = x < 0 ? kHalfTurn - angle : angle;
  return y < 0 ? -angle : angle;
}

}  // namespace ocelli
