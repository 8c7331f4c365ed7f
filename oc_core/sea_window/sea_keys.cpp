#include "oc_core/sea_window/sea_keys.h"

#include <array>

namespace ocelli {
namespace {

constexpr double kTurnPerSecond = 1.2;  // radians

/// A step of an adult, or what the images are close enough for.
double metresPerSecond(const SeaVisit& visit) {
  constexpr double kSpacingsPerSecond = 12;
  return kSpacingsPerSecond * visit.spacing();
}

void goOn(SeaVisit& visit, int64_t images) {
  const auto count = static_cast<int64_t>(visit.positions().size());
  const int64_t next = (visit.nearest() + images % count + count) % count;
  visit.goToImage(static_cast<uint32_t>(next));
}

constexpr std::array kPointerLines{SeaPointerLine{"drag", "look around"}, SeaPointerLine{"wheel", "zoom"},
                                   SeaPointerLine{"click on the map", "go there"}};

}  // namespace

const std::vector<SeaHeldKey>& seaHeldKeys() {
  static const std::vector<SeaHeldKey> kKeys{
      {{Key::kW, Key::kUp},
       "W, Up",
       "walk ahead; with Shift faster, here and below",
       [](SeaVisit& visit, double amount) { visit.walk(metresPerSecond(visit) * amount, 0); }},
      {{Key::kS, Key::kDown},
       "S, Down",
       "walk back",
       [](SeaVisit& visit, double amount) { visit.walk(-metresPerSecond(visit) * amount, 0); }},
      {{Key::kA},
       "A",
       "walk to the left",
       [](SeaVisit& visit, double amount) { visit.walk(0, -metresPerSecond(visit) * amount); }},
      {{Key::kD},
       "D",
       "walk to the right",
       [](SeaVisit& visit, double amount) { visit.walk(0, metresPerSecond(visit) * amount); }},
      {{Key::kQ, Key::kLeft},
       "Q, Left",
       "turn to the left",
       [](SeaVisit& visit, double amount) { visit.turn(kTurnPerSecond * amount, 0); }},
      {{Key::kE, Key::kRight},
       "E, Right",
       "turn to the right",
       [](SeaVisit& visit, double amount) { visit.turn(-kTurnPerSecond * amount, 0); }},
      {{Key::kR}, "R", "look up", [](SeaVisit& visit, double amount) { visit.turn(0, kTurnPerSecond * amount); }},
      {{Key::kF}, "F", "look down", [](SeaVisit& visit, double amount) { visit.turn(0, -kTurnPerSecond * amount); }}};
  return kKeys;
}

const std::vector<SeaKeyAction>& seaKeyActions() {
  static const std::vector<SeaKeyAction> kKeys{
      {{Key::kN, Key::kPageDown}, "N", "go to the next image", [](SeaVisit& v, SeaWindowState&) { goOn(v, 1); }},
      {{Key::kP, Key::kPageUp}, "P", "go to the one before", [](SeaVisit& v, SeaWindowState&) { goOn(v, -1); }},
      {{Key::k0, Key::kHome}, "0, Home", "go to the first image", [](SeaVisit& v, SeaWindowState&) { v.goToImage(0); }},
      {{Key::kEqual}, "=", "zoom in", [](SeaVisit& v, SeaWindowState&) { v.zoom(1); }},
      {{Key::kMinus}, "-", "zoom out", [](SeaVisit& v, SeaWindowState&) { v.zoom(-1); }},
      {{Key::kM}, "M", "show or hide the map", [](SeaVisit&, SeaWindowState& s) { s.hasMap = !s.hasMap; }},
      {{Key::kH, Key::kF1},
       "H, F1",
       "show or hide this help",
       [](SeaVisit&, SeaWindowState& s) { s.hasHelp = !s.hasHelp; }},
      {{Key::kF11}, "F11", "fill the screen, or not", [](SeaVisit&, SeaWindowState& s) { s.wantsFullscreen = true; }},
      {{Key::kEscape}, "Escape", "close the help, then the window", [](SeaVisit&, SeaWindowState& s) {
         s.closeHelpOrWindow();
       }}};
  return kKeys;
}

std::span<const SeaPointerLine> seaPointerLines() {
  return kPointerLines;
}

}  // namespace ocelli
