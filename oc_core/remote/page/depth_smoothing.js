// What was between the levels of rounded depths, as far as the image itself tells: oc_core/remote/depth_smoothing.h.

/// How far apart the neighbours of each round are.
const kSteps = [16, 8, 4, 4, 2, 2, 1, 1];
/// Three rounded values on a line are off it by at most this.
const kMaxBend = 2;

/// Fractions of levels; 0 where nothing is seen.
export function smoothedLevels(values, width, height) {
  let now = Float32Array.from(values);
  let next = now.slice();
  for (const step of kSteps) {
    const below = width * step;
    for (let y = 0, i = 0; y < height; ++y) {
      const hasRows = y >= step && y + step < height;
      for (let x = 0; x < width; ++x, ++i) {
        const value = values[i];
        if (value === 0) {
          continue;
        }
        const across = x >= step && x + step < width && isStraight(values[i - step], value, values[i + step]);
        const down = hasRows && isStraight(values[i - below], value, values[i + below]);
        if (across || down) {
          const sum = (across ? now[i - step] + now[i + step] : 0) + (down ? now[i - below] + now[i + below] : 0);
          const middle = sum / (across && down ? 4 : 2);
          next[i] = Math.min(Math.max(middle, value - 0.5), value + 0.5);
        }
      }
    }
    [now, next] = [next, now];
  }
  return now;
}

/// Whether the values beside one go on as it does.
function isStraight(before, value, after) {
  return before > 0 && after > 0 && Math.abs(before + after - 2 * value) <= kMaxBend;
}
