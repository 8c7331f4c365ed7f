#include "display_driver/firmware/rotor.h"

#include <algorithm>
#include <cmath>

#include "oc_core/base/check.h"

namespace ocelli {
namespace {

/// A standard normal deviate to within the tails that no motor has: the sum of twelve uniform ones (Irwin and Hall).
double normalDeviate(Random& random) {
  double sum = -6;
  for (int i = 0; i < 12; ++i) {
    sum += static_cast<double>(random.inRange(0, 1));
  }
  return sum;
}

}  // namespace

Rotor::Rotor(const DisplayProfile& profile, const RotorOptions& options)
    : slices_(profile.storedSlices()),
      idealMicroseconds_(1e6 / profile.refreshHertz()),
      degreesPerRefresh_(profile.secondHalfTurn == SecondHalfTurn::kOwn ? 360 : 180),
      options_(options),
      random_(options.seed) {
  OC_CHECK(options.jitter >= 0 && options.jitter < 0.1, "a rotor with so much jitter does not turn");
  drawLength();
}

void Rotor::drawLength() {
  const double error = begin_ - static_cast<double>(refresh_) * idealMicroseconds_;
  const double free = idealMicroseconds_ / rate_ * (1 + options_.jitter * normalDeviate(random_));
  // A motor has its limits.
  length_ = std::clamp(free - options_.controllerGain * error, 0.5 * free, 2 * free);
}

void Rotor::nextRefresh() {
  begin_ += length_;
  ++refresh_;
  drawLength();
}

DeviceMicroseconds Rotor::begin() const {
  return static_cast<DeviceMicroseconds>(std::ceil(begin_));
}

DeviceMicroseconds Rotor::end() const {
  return static_cast<DeviceMicroseconds>(std::ceil(begin_ + length_));
}

int Rotor::sliceAt(DeviceMicroseconds now) const {
  const double share = (static_cast<double>(now) - begin_) / length_;
  int slice = std::clamp(static_cast<int>(share * slices_), 0, slices_ - 1);
  // The share may be rounded to the other side of a slice's begin.
  if (slice + 1 < slices_ && beginOf(slice + 1) <= now) {
    ++slice;
  } else if (slice > 0 && now < beginOf(slice)) {
    --slice;
  }
  return slice;
}

DeviceMicroseconds Rotor::beginOf(int slice) const {
  return static_cast<DeviceMicroseconds>(std::ceil(begin_ + length_ * slice / slices_));
}

double Rotor::phaseErrorDegrees() const {
  const double late = begin_ - static_cast<double>(refresh_) * idealMicroseconds_;
  return -late / idealMicroseconds_ * degreesPerRefresh_;
}

bool Rotor::locked() const {
  return std::abs(phaseErrorDegrees()) <= degreesPerRefresh_ / slices_;
}

}  // namespace ocelli
