// The volumes of the test patterns, one function a pattern. What they are for and how to read them: test_patterns.h.
//
// Each takes any valid profile. Where a display has too few slices, columns or rows for a detail, the detail is coarser
// or missing, and the rest stands.
#pragma once

#include "display_sim/frames/volume.h"

namespace ocelli {

/// Nothing is lit.
Volume darkPattern(const DisplayProfile& profile);

/// The axis as the ring of voxels around it: in the upper third all of it, in the middle third the half towards the
/// front (+z), in the lower third the other half. On the equator rings of one voxel at a quarter, half and three
/// quarters of the radius and at the rim; small rings around the axis far up and down.
Volume axisPattern(const DisplayProfile& profile);

/// Letters that read from outside: F to the front (+z) and R to the right (+x) in the upper half, B to the back and L
/// to the left in the lower half, and TOP to those who look down from the front.
Volume orientationPattern(const DisplayProfile& profile);

/// Slice 0: its full height at +x, its lower half at -x. At the bottom, ticks at every second slice of the ten on
/// either side, the tenth longer. Where the second half turn has its own slices, the first one is red and the second
/// cyan.
Volume phasePattern(const DisplayProfile& profile);

/// On the equator, rings of wedges that are lit and dark in turns: the outermost of one slice each, further in of more.
/// At the rim a mark of full height at slice 0, and one of half the height a quarter of a half turn later.
Volume wedgesPattern(const DisplayProfile& profile);
/// How many slices the wedges are wide, from the outermost ring to the innermost: they all divide the half turn.
std::vector<int> wedgeWidths(const DisplayProfile& profile);

/// A spiral stair: each slice has one step, from the bottom at slice 0 once around to the top.
Volume stairsPattern(const DisplayProfile& profile);

/// The edges and middle lines of a cube with sides along x, y and z, or of a flat box where the display is low.
Volume boxPattern(const DisplayProfile& profile);
/// Half the sides of that box along x and z, and along y.
struct BoxSides {
  double across = 0;
  double up = 0;
};
BoxSides boxSides(const DisplayProfile& profile);

/// Parallels and meridians every 30 degrees.
Volume spherePattern(const DisplayProfile& profile);
double sphereRadius(const DisplayProfile& profile);

/// Line pairs on slice 0 and on the slice a quarter turn on: at three radii and three heights on both sides, columns
/// (left) and rows (right), of one voxel (above) and of two (below). High up and low down rings of slices in turns.
Volume focusPattern(const DisplayProfile& profile);

/// A drum of rings of one colour each, from the top: red, green, blue, cyan, magenta, yellow, white, each in steps of
/// light from full to little. Seen from each of the four sides red has one notch, green two, blue three. Outside of the
/// white one single slices in white, every eighth of a turn.
Volume coloursPattern(const DisplayProfile& profile);
/// The levels of its steps, from full light on.
std::vector<int> colourSteps(const DisplayProfile& profile);

/// Two cones of rings of one voxel. The upper one is lit in every slice; the lower one in a share of the slices that
/// grows with the radius, so that all of its rings have the same light for their length.
Volume brightnessPattern(const DisplayProfile& profile);
/// The radii of the rings, from the axis outwards, and their rows.
struct BrightnessRing {
  int ring = 0;
  int upperRow = 0;
  int lowerRow = 0;
};
std::vector<BrightnessRing> brightnessRings(const DisplayProfile& profile);

/// Everything is lit.
Volume whitePattern(const DisplayProfile& profile);

}  // namespace ocelli
