// A share with its interval and a figure, with the component "analysis" alone: with the drawings that it needs, and
// without GLM, the rest of oc_core/ and study/.
#include <cmath>
#include <cstdio>

#include "analysis/inference/binomial_test.h"
#include "oc_core/drawing/figure.h"

int main() {
  const auto share = ocelli::wilsonShare({.successes = 17, .trials = 20});
  const std::string figure = ocelli::svgText({.title = "Nothing", .description = "", .width = 100, .height = 50});
  // Wilson 1927: 0.640 to 0.948 for 17 of 20.
  const bool good = std::abs(share.lower - 0.640) < 5e-4 && std::abs(share.upper - 0.948) < 5e-4 &&
                    figure.find("<svg") < figure.size();
  std::printf("the component \"analysis\" %s: %.3f to %.3f\n", good ? "works" : "does not work", share.lower,
              share.upper);
  return good ? 0 : 1;
}
