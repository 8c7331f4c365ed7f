#include "oc_core/camera/gpc_fold.h"

namespace ocelli {

double leastUnfoldedZoom(const GpcSampling& sampling, double outer) {
  double folds = 0;
  double works = 1;
  for (int i = 0; i < 60; ++i) {
    const double middle = (folds + works) / 2;
    (GpcProfile(sampling, middle, outer).isIncreasing() ? works : folds) = middle;
  }
  return works;
}

}  // namespace ocelli
