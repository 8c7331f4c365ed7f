// How a view moves, and where it will be: oc_core/remote/client/view_motion.h.
import {Pinhole, add, cross, degrees, dot, length, radians, resolvedFov, subtract, times} from './view_math.js';

const kResting = 1e-6;  // units, radians or e-foldings a second
const kMaxZoomAhead = 2;
const kFovLimits = [0.1, 170];

const zoomOf = (view) => -Math.log(Math.tan(radians(resolvedFov(view)) / 2));

/// The rotation vector from the axes of one view to those of another.
function turnBetween(before, after) {
  const [p, q] = [new Pinhole(before, 2, 2), new Pinhole(after, 2, 2)];
  const from = [p.right, p.down, p.forward];
  const to = [q.right, q.down, q.forward];
  // Twice sine times axis, and 1 + 2 cosine, of the rotation sum(to_i from_i^T).
  const sine = from.reduce((sum, axis, i) => add(sum, cross(axis, to[i])), [0, 0, 0]);
  const trace = from.reduce((sum, axis, i) => sum + dot(axis, to[i]), 0);
  const size = length(sine);
  return size > 0 ? times(sine, Math.atan2(size, trace - 1) / size) : [0, 0, 0];
}

/// From one view to another that is `seconds` later; at rest where `seconds` is not positive.
export function motionBetween(before, after, seconds) {
  if (!(seconds > 0)) {
    return {eye: [0, 0, 0], turn: [0, 0, 0], zoom: 0};
  }
  return {
    eye: times(subtract(after.eye, before.eye), 1 / seconds),
    turn: times(turnBetween(before, after), 1 / seconds),
    zoom: (zoomOf(after) - zoomOf(before)) / seconds,
  };
}

export function isResting(motion) {
  return length(motion.eye) < kResting && length(motion.turn) < kResting && Math.abs(motion.zoom) < kResting;
}

function rotated(v, axis, angle) {
  const [c, s] = [Math.cos(angle), Math.sin(angle)];
  return add(add(times(v, c), times(cross(axis, v), s)), times(axis, dot(axis, v) * (1 - c)));
}

/// Where the view will be; turned by at most half of its field of view, zoomed by at most 2.
export function viewAhead(view, motion, seconds) {
  const eye = add(view.eye, times(motion.eye, seconds));
  let forward = subtract(view.target, view.eye);
  let up = view.up;
  const fov = resolvedFov(view);
  const rate = length(motion.turn);
  if (rate > 0) {
    const angle = Math.min(rate * seconds, radians(fov) / 2);
    const axis = times(motion.turn, 1 / rate);
    forward = rotated(forward, axis, angle);
    up = rotated(up, axis, angle);
  }
  const bound = Math.log(kMaxZoomAhead);
  const zoom = zoomOf(view) + Math.min(bound, Math.max(-bound, motion.zoom * seconds));
  const ahead = Math.min(kFovLimits[1], Math.max(kFovLimits[0], degrees(2 * Math.atan(Math.exp(-zoom)))));
  return {...view, eye, target: add(eye, forward), up, fov_vertical_degrees: ahead};
}
