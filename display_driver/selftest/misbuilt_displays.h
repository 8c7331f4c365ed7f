// What displays show of a volume that are built or set wrongly: for the images of the checklist, and to try patterns.
// Each returns the volume that a right display would have to be sent to look the same.
#pragma once

#include "display_sim/frames/volume.h"

namespace ocelli {

Volume slicesReversed(const Volume& sent);
Volume columnsReversed(const Volume& sent);
Volume slicesAndColumnsReversed(const Volume& sent);
Volume rowsReversed(const Volume& sent);
/// The second half turn shows the slices of the first as they are where it should mirror them.
Volume notMirrored(const Volume& sent);

/// Slice 0 is shown too late, by a twentieth of a turn.
Volume shownLate(const Volume& sent);
/// The second half turn is shown too late, by two slices at least.
Volume secondHalfLate(const Volume& sent);
/// The slices of a half turn are shown in less than its time.
Volume shownTooFast(const Volume& sent);
/// Faster in one half of the turn, slower in the other.
Volume turningUnevenly(const Volume& sent);
/// Some slices of each half turn are dark.
Volume slicesLost(const Volume& sent);
/// Slices four apart have changed places.
Volume slicesSwapped(const Volume& sent);
/// A slice goes on to shine through the two that follow.
Volume shiningOn(const Volume& sent);
/// The lower rows are shown later than the upper ones.
Volume rowsLate(const Volume& sent);

/// The middle of the screen stands beside the axis, by a fortieth of its width and one column at least.
Volume screenBesideAxis(const Volume& sent);
/// The same at the top, and as much to the other side at the bottom.
Volume screenTilted(const Volume& sent);
/// The screen is narrower than the profile says.
Volume screenNarrow(const Volume& sent);
/// Light spreads to the columns and rows beside.
Volume lightSpread(const Volume& sent);

/// Some pixels are always on.
Volume pixelsStuck(const Volume& sent);
/// Red and blue have changed places.
Volume channelsSwapped(const Volume& sent);
Volume greenMissing(const Volume& sent);

}  // namespace ocelli
