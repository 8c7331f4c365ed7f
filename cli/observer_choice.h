// The options of `ocelli observe` that say who looks, for how long, and at what kind of screen.
#pragma once

#include <string>

#include "display_sim/observing/observer.h"

namespace CLI {
class App;
}

namespace ocelli {

/// As the user gives them; lengths in metres where the help says so.
struct ObserverChoice {
  std::string eye;
  std::string size = "768x768";
  double fovVerticalDegrees = 0;
  std::string exposure;
  double missingSectorDegrees = 0;
  std::string start;
  std::string emission = "screen";
  double transmission = 1;
  double wobbleMetres = 0;
  std::string wobbleDirection = "1,0,0";
  double wobbleFrequency = 1;
  double wobblePhaseDegrees = 0;
  double apertureMetres = 0;
  double focusMetres = 0;
  double deadZoneMetres = 0;
  double ambient = 0;
  double gain = 0;
  double gamma = 1;
  std::string tone = "clip";
};

void addObserverOptions(CLI::App& command, ObserverChoice& choice);

/// Throws InputError where the default eye, at the viewing distance of this display, is inside of it.
void checkDefaultEye(const DisplayProfile& profile);

/// Throws InputError for values that cannot be read; checkObserverOptions() judges them.
ObserverOptions observerOptions(const ObserverChoice& choice, const DisplayProfile& profile);

}  // namespace ocelli
