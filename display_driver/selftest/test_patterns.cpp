#include "display_driver/selftest/test_patterns.h"

#include <fmt/format.h>

#include <algorithm>

#include "display_driver/selftest/misbuilt_displays.h"
#include "display_driver/selftest/pattern_figures.h"
#include "display_driver/selftest/pattern_volumes.h"
#include "oc_core/base/error.h"

namespace ocelli {

const std::vector<TestPattern>& testPatterns() {
  static const std::vector<TestPattern> patterns{
      {"dark",
       "Nothing lit",
       "Every voxel is dark, while the screen turns at its full rate.",
       {"In a dark room, with eyes that are used to it, no light comes from the display."},
       {{"Thin bright rings", "pixels that are always on: at the height of a ring and its distance from the axis",
         "note column and row, then look at the driver of that pixel", pixelsStuck, PatternView::kRaised},
        {"A haze over the whole volume",
         "the screen's dark level is not dark, or light leaks past the projector's mirror",
         "lower the dark level, cover the leak; a haze takes contrast from every image"},
        {"One sector glows", "slices that keep what was there before: a buffer that is not cleared",
         "send the pattern twice; if the sector stays, check which buffer is shown"}},
       darkPattern,
       darkFigures},
      {"axis",
       "Axis and columns",
       "The axis as a thin line, rings around it on the equator, and two small rings far up and down. The middle third "
       "of "
       "the line is its front half alone, the lower third its back half.",
       {"The line is straight, thin and does not flicker, from every side.",
        "From the right, the middle third lies just in front of the axis and the lower third just behind it: side by "
        "side, "
        "each half as wide as the upper third.",
        "Every ring is a single thin circle, closed all around.",
        "The two small rings stand exactly above each other."},
       {{"Rings are double", "the middle of the screen is not on the axis: the two circles are twice the error apart",
         "shift the screen, or the image on it, by half the distance of the two circles", screenBesideAxis,
         PatternView::kAbove},
        {"The line is a thin tube, or its middle and lower thirds leave a gap between them or overlap",
         "the two columns beside the axis do not meet there",
         "the same shift; then look at the column order of the panel"},
        {"The line fans out at its ends, and the small rings are double", "the screen is tilted against the axis",
         "level the screen on its shaft", screenTilted, PatternView::kFront},
        {"A ring has a gap or a dense arc", "slices are not evenly spaced over the turn",
         "go on to the pattern wedges, which shows where"},
        {"The line swims around", "the shaft wobbles or is bent", "balance the rotor; check the bearings"}},
       axisPattern,
       axisFigures},
      {"orientation",
       "Orientation",
       "Letters on a cylinder: F in front, R on the right, B behind, L on the left, and TOP for those who look down. F "
       "and R "
       "stand in the upper half, B and L in the lower, so that near and far letters do not cover each other.",
       {"From the front F is near and reads properly; B shows through from behind, mirrored.",
        "From the right, the back and the left the near letters are R, B and L, and read properly.",
        "From above, with the front towards you, TOP reads properly."},
       {{"All letters read properly, but B is in front and L on the right",
         "columns run the wrong way: that is half a turn",
         "turn the order of the columns around, or the index by half a turn", columnsReversed, PatternView::kFront},
        {"Near letters are mirrored; F and B have changed places, R and L have not",
         "slices come in the wrong order, or the screen turns the wrong way",
         "turn the order of the slices around, or the motor", slicesReversed, PatternView::kFront},
        {"Near letters are mirrored; R and L have changed places, F and B have not",
         "slices and columns both run the wrong way", "turn both orders around", slicesAndColumnsReversed,
         PatternView::kFront},
        {"Letters stand on their heads, F in the lower half", "rows run the wrong way",
         "turn the order of the rows around", rowsReversed, PatternView::kFront},
        {"Everything is there twice, half a turn apart",
         "the second half turn is not mirrored where the profile says that it is",
         "let the display mirror it, or take a profile whose second half turn is its own", notMirrored,
         PatternView::kFront},
        {"All letters stand too far around, by the same angle", "slice 0 is shown at a wrong angle",
         "go on to the pattern phase and set the index", shownLate, PatternView::kFront}},
       orientationPattern,
       noFigures},
      {"phase",
       "Phase",
       "One slice alone, number 0: its full height on the right (+x), its lower half on the left, and at the bottom a "
       "scale "
       "with a tick at every second slice.",
       {"From above the line points from the left to the right, exactly at the index mark of the housing.",
        "Both sides are one straight line, through the axis.", "The line stands still.", "It is sharp on both sides."},
       {{"The line points beside the index mark",
         "the index sensor is early or late by as many slices as the scale shows",
         "move the sensor, or set its angle in the controller", shownLate, PatternView::kAbove},
        {"Two lines that cross at the axis (on a display with slices of its own in the second half turn: red and cyan "
         "instead of white)",
         "the two half turns are shown at different angles",
         "set the delay of the second half turn; check both index marks", secondHalfLate, PatternView::kAbove},
        {"The line moves to and fro", "the rotation is not locked to the image",
         "look at the rate of the motor and at the phase error that the display tells"},
        {"The line creeps around", "slices are shown at another rate than the screen turns",
         "let the index start every turn"},
        {"A tail on the clockwise side of the line", "light goes on after its slice: afterglow",
         "shorten the time that a slice is lit, or take faster light sources", shiningOn, PatternView::kAbove},
        {"The line is missing when you look along it", "a flat screen seen from its edge is dark; this is right",
         "look from the front or from above"}},
       phasePattern,
       phaseFigures},
      {"wedges",
       "Number of slices and seam",
       "Rings of wedges on the equator, lit and dark in turns: single slices outside, wider ones further in. The mark "
       "of "
       "full height stands at slice 0, that of half the height a quarter of a half turn later.",
       {"Wedges of a ring are equally wide, all around.",
        "Lit and dark take turns at the seam as everywhere: beside the tall mark, and on the other side of the "
        "display.",
        "From above the short mark follows the tall one clockwise."},
       {{"One wedge is wider or narrower at the seam, or the seam gapes",
         "more or fewer slices are shown in a turn than are sent",
         "compare the rate of the slices with that of the turns; check the number of slices in the profile",
         shownTooFast, PatternView::kAbove},
        {"Wedges grow narrower and wider around the turn", "the screen does not turn evenly",
         "balance the rotor; take slice times from an encoder instead of from the turn", turningUnevenly,
         PatternView::kAbove},
        {"A ring is lit evenly or has a beat in it", "slices are swapped or repeated",
         "the pattern stairs shows which; look at the address lines that count slices", slicesSwapped,
         PatternView::kAbove},
        {"The outermost ring is smeared into an even one, the next is fine", "light lasts longer than a slice",
         "shorten the time that a slice is lit", shiningOn, PatternView::kAbove},
        {"The short mark follows counter-clockwise", "the screen turns the other way, or slices are sent backwards",
         "turn the motor or the order of the slices around", slicesReversed, PatternView::kAbove}},
       wedgesPattern,
       wedgesFigures},
      {"stairs",
       "Order of slices",
       "A spiral stair of one step a slice. It starts at the bottom at slice 0 and rises once around to the top, "
       "clockwise "
       "seen from above.",
       {"The stair rises evenly, without a step that is missing or out of its place.",
        "From above it is a closed ring.", "It ends above the place where it starts, one step short."},
       {{"Steps are missing, and dark gaps show from above", "slices are lost on the way",
         "look at lost frames and at the buffer; each gap tells the number of its slice", slicesLost,
         PatternView::kAbove},
        {"Some steps have changed places", "an address line is stuck or swapped",
         "the distance of the steps that changed places, in slices, is a power of two: it names the line",
         slicesSwapped, PatternView::kFront},
        {"The stair has a break at one place that moves from frame to frame", "frames change in the middle of a turn",
         "let the display change frames at slice 0 only"},
        {"The stair shows twice, the other at half a turn", "the half turns show each other's slices",
         "check second_half_turn in the profile against what the display does", notMirrored, PatternView::kRaised}},
       stairsPattern,
       stairsFigures},
      {"box",
       "Straight lines and right angles",
       "The edges of a box parallel to the housing, and the middle lines of its sides.",
       {"Edges are straight, also those across the sweep.",
        "Sides are rectangles; measured, the box has the sides below.", "Nothing gapes or steps."},
       {{"Horizontal edges are bent or double", "the middle of the screen is not on the axis",
         "go back to the pattern axis", screenBesideAxis, PatternView::kAbove},
        {"Upright edges lean, all the same way around",
         "rows are shown at different times: the screen is written from top to "
         "bottom",
         "show the rows of a slice at once", rowsLate, PatternView::kFront},
        {"The box is turned against the housing", "slice 0 is shown at a wrong angle", "go back to the pattern phase",
         shownLate, PatternView::kAbove},
        {"Its sides have other lengths", "width or height of the screen are not those of the profile",
         "measure the screen and write a profile of your own", screenNarrow, PatternView::kFront}},
       boxPattern,
       boxFigures},
      {"sphere",
       "Roundness",
       "A globe: parallels and meridians every 30 degrees.",
       {"From every side its outline is a circle.", "Parallels are flat circles, and meridians meet at the poles.",
        "All meridians are equally sharp."},
       {{"The outline is an ellipse", "width and height of the screen are not those of the profile",
         "measure the screen and write a profile of your own", screenNarrow, PatternView::kFront},
        {"Meridians do not meet at the poles", "the middle of the screen is not on the axis",
         "go back to the pattern axis", screenBesideAxis, PatternView::kFront},
        {"Meridians are double", "the half turns do not match", "go back to the pattern phase", secondHalfLate,
         PatternView::kFront},
        {"Meridians wind around like a screw", "rows are shown at different times", "show the rows of a slice at once",
         rowsLate, PatternView::kFront},
        {"Parallels are wavy", "the screen is warped, or shakes", "flatten or stiffen the screen; balance the rotor"}},
       spherePattern,
       sphereFigures},
      {"focus",
       "Focus and resolution",
       "Line pairs on the two upright planes that cross at the axis, at three radii and three heights: columns in the "
       "half "
       "of a target that is nearer to the axis and rows in the other, single lines above and double ones below. Near "
       "top "
       "and bottom, fans of slices that are lit in turns.",
       {"Double lines are separate in every target.",
        "Single lines are separate too; where not, note radius and height.",
        "Slices of the fans are separate at the rim. Further in they may blur: they lie closer there."},
       {{"Lines are sharp near the axis and blurred outside, or the other way round",
         "the projector is focused on another distance than the screen's",
         "focus half way out; a smaller aperture helps both"},
        {"Rows are sharp, columns are not, or the other way round",
         "the image is scaled in one direction, or its signal is too slow",
         "send the screen its own number of columns and rows"},
        {"Single lines are grey everywhere, double ones are fine", "light spreads in the screen",
         "a thinner diffuser spreads less", lightSpread, PatternView::kFront},
        {"Fans are blurred at the rim", "light lasts longer than a slice", "shorten the time that a slice is lit",
         shiningOn, PatternView::kAbove},
        {"Upper targets are sharp, lower ones are not", "the screen is tilted, or the projector is",
         "level them; go back to the pattern axis"}},
       focusPattern,
       focusFigures},
      {"colours",
       "Colours and levels",
       "A drum of bands, from the top: red, green, blue, cyan, magenta, yellow, white. Notches name the channels to "
       "those who "
       "cannot tell them apart: one in red, two in green, three in blue. Each band steps from full light down. Outside "
       "stand single slices in white.",
       {"The bands have these colours, from the top.", "The steps of a band are equally high and get darker downwards.",
        "White is white, not tinted.", "The single slices are white, without coloured edges."},
       {{"Bands have changed places", "channels are swapped", "swap them in the controller or in the wiring",
         channelsSwapped, PatternView::kFront},
        {"A band is dark", "a channel is missing", "look at its driver and its connector", greenMissing,
         PatternView::kFront},
        {"Two steps look alike, or one is darker than its neighbour below",
         "bit planes are swapped or shown for wrong times",
         "check the order of the planes, the least significant first, and that each lasts twice as long as the one "
         "before"},
        {"White is tinted", "channels are not equally strong", "set the currents of the channels"},
        {"Single slices have coloured edges",
         "red, green and blue come one after the other: right for channel_timing in_turn, wrong for together",
         "set channel_timing in the profile to what the display does, so that images are made for it"}},
       coloursPattern,
       coloursFigures},
      {"brightness",
       "Brightness against radius",
       "Two cones of rings. The upper ones are lit in every slice: light spreads over longer rings further out. The "
       "lower ones "
       "are lit in a share of the slices that grows with the radius.",
       {"All rings of the lower cone are equally bright.",
        "Rings of the upper cone get darker outwards, as the table says.", "A ring is equally bright all around."},
       {{"The lower cone gets darker outwards",
         "the screen is dimmer at its edge (vignetting of a projector, thin supply lines)",
         "even out the screen; measured values of the lower rings are its factors"},
        {"The lower cone gets darker near the axis", "the shaft or its mount covers the screen",
         "keep content away from there, or move the mount"},
        {"The upper cone has equally bright rings", "the display already evens light out over the radius",
         "then slice without --even-light"},
        {"A ring is brighter on one side", "the two halves of the screen, or its two faces, are not equally bright",
         "compare them with the screen at rest"}},
       brightnessPattern,
       brightnessFigures},
      {"white",
       "Everything lit",
       "Every voxel is lit. This is the most that light sources, supply and cooling ever have to give: watch the "
       "temperature, "
       "and end it when something gets hot.",
       {"With the screen at rest, every pixel is lit.", "The supply voltage and the rate of the rotation hold.",
        "After ten minutes no part is hotter than its maker allows."},
       {{"Pixels are dark with the screen at rest", "dead pixels: while the screen turns their dark rings hardly show",
         "note column and row"},
        {"It flickers, or gets dimmer after a while", "the supply sags, or drivers limit their current",
         "measure the voltage at the rotor, behind the slip rings; limit the full level"},
        {"The rotation slows down", "motor and light share a supply that is too weak", "separate them"},
        {"It is not white everywhere", "channels differ over the screen",
         "go back to the patterns colours and brightness"}},
       whitePattern,
       whiteFigures},
  };
  return patterns;
}

const TestPattern& testPattern(const std::string& name) {
  const auto& patterns = testPatterns();
  const auto found = std::ranges::find(patterns, name, &TestPattern::name);
  if (found == patterns.end()) {
    std::string names;
    for (const TestPattern& pattern : patterns) {
      names += (names.empty() ? "" : ", ") + pattern.name;
    }
    throw InputError(fmt::format("there is no test pattern \"{}\"", name), "--pattern", "one of: " + names);
  }
  return *found;
}

}  // namespace ocelli
