// Views and their pinholes: oc_core/camera/view.h and pinhole_camera.h in double precision, and the moves that a user
// makes. A view is {eye, target, up, fov_vertical_degrees, z_near, z_far, center_shift}, as in files of views; lengths
// are the scene's, angles radians but where a name says degrees.

export const add = (a, b) => [a[0] + b[0], a[1] + b[1], a[2] + b[2]];
export const subtract = (a, b) => [a[0] - b[0], a[1] - b[1], a[2] - b[2]];
export const times = (a, s) => [a[0] * s, a[1] * s, a[2] * s];
export const dot = (a, b) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
export const cross = (a, b) => [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
export const length = (a) => Math.hypot(a[0], a[1], a[2]);
export const normalized = (a) => times(a, 1 / length(a));

export const radians = (degrees) => degrees * Math.PI / 180;
export const degrees = (angle) => angle * 180 / Math.PI;

export const fovLimits = [0.05, 120];  // degrees
/// How near to its "up" a view may look: there it has no right and left.
const kSteepest = radians(85);

/// What the server says of a field of view may be 0: one that just holds the unit sphere around the target.
export function resolvedFov(view) {
  if (view.fov_vertical_degrees > 0) {
    return view.fov_vertical_degrees;
  }
  return degrees(2 * Math.asin(1 / Math.max(1, length(subtract(view.eye, view.target)))));
}

/// With every field, and numbers of its own.
export function completeView(view) {
  const complete = {
    eye: [...view.eye],
    target: [...view.target],
    up: [...(view.up ?? [0, 1, 0])],
    fov_vertical_degrees: view.fov_vertical_degrees ?? 0,
    z_near: view.z_near ?? 0.01,
    z_far: view.z_far ?? 1000,
    center_shift: [...(view.center_shift ?? [0, 0])],
  };
  complete.fov_vertical_degrees = resolvedFov(complete);
  return complete;
}

export class Pinhole {
  constructor(view, width, height) {
    this.view = view;
    this.width = width;
    this.height = height;
    this.eye = view.eye;
    this.forward = normalized(subtract(view.target, view.eye));
    this.right = normalized(cross(this.forward, view.up));
    this.down = cross(this.forward, this.right);
    this.focal = height / 2 / Math.tan(radians(resolvedFov(view)) / 2);
    const shift = view.center_shift ?? [0, 0];
    this.center = [width / 2 + shift[0] * height, height / 2 + shift[1] * height];
  }

  /// The direction of the ray through a pixel; 1 along the view direction.
  ray(p) {
    const x = (p[0] - this.center[0]) / this.focal;
    const y = (p[1] - this.center[1]) / this.focal;
    return add(this.forward, add(times(this.right, x), times(this.down, y)));
  }

  /// (right, down, forward) of a direction, or of a point relative to the eye.
  axes(d) {
    return [dot(d, this.right), dot(d, this.down), dot(d, this.forward)];
  }

  /// Where a direction has its image; null behind the eye.
  place(direction) {
    const d = this.axes(direction);
    return d[2] > 0 ? [this.center[0] + this.focal * d[0] / d[2], this.center[1] + this.focal * d[1] / d[2]] : null;
  }
}

/// A vector turned around a unit axis.
function turnedAround(v, axis, angle) {
  const c = Math.cos(angle);
  const s = Math.sin(angle);
  return add(add(times(v, c), times(cross(axis, v), s)), times(axis, dot(axis, v) * (1 - c)));
}

/// Angle of a direction above the plane that is perpendicular to "up".
const elevation = (direction, up) => Math.asin(Math.min(1, Math.max(-1, dot(direction, up))));

/// A direction turned to the right around "up", and upwards by at most what keeps it apart from "up".
function turnedDirection(direction, up, toRight, upwards) {
  const axis = normalized(up);
  const around = turnedAround(normalized(direction), axis, -toRight);
  const now = elevation(around, axis);
  const limit = Math.max(kSteepest, Math.abs(now));
  const then = Math.min(limit, Math.max(-limit, now + upwards));
  return turnedAround(around, normalized(cross(around, axis)), then - now);
}

/// The eye stays, and looks farther to the right and upwards.
export function turned(view, toRight, upwards) {
  const line = subtract(view.target, view.eye);
  const direction = turnedDirection(line, view.up, toRight, upwards);
  return {...view, target: add(view.eye, times(direction, length(line)))};
}

/// Turned until a direction of the world is seen at a pixel, as long as that is not too near to "up".
function turnedUntil(view, width, height, direction, at) {
  const kSteps = 8;  // each leaves a small part of what was amiss: "up" is not that of the screen
  let result = view;
  for (let i = 0; i < kSteps; ++i) {
    const pinhole = new Pinhole(result, width, height);
    const place = pinhole.place(direction);
    if (place === null) {
      break;
    }
    const angle = (p, axis) => Math.atan((p[axis] - pinhole.center[axis]) / pinhole.focal);
    result = turned(result, angle(place, 0) - angle(at, 0), angle(at, 1) - angle(place, 1));
  }
  return result;
}

/// Turned so that what was seen at pixel `from` is seen at pixel `to`.
export function dragged(view, width, height, from, to) {
  return turnedUntil(view, width, height, new Pinhole(view, width, height).ray(from), to);
}

/// Closer by a factor; what is seen at a pixel stays there.
export function zoomed(view, width, height, factor, at) {
  const tangent = Math.tan(radians(view.fov_vertical_degrees) / 2) / factor;
  const [least, most] = fovLimits;
  const fov = Math.min(most, Math.max(least, degrees(2 * Math.atan(tangent))));
  const direction = new Pinhole(view, width, height).ray(at);
  return turnedUntil({...view, fov_vertical_degrees: fov}, width, height, direction, at);
}

/// The eye moves by (right, up, forward) of its own view, and what it looks at moves along.
export function moved(view, step) {
  const pinhole = new Pinhole(view, 2, 2);
  const by = add(add(times(pinhole.right, step[0]), times(pinhole.down, -step[1])), times(pinhole.forward, step[2]));
  return {...view, eye: add(view.eye, by), target: add(view.target, by)};
}

/// The eye moves around a point: to the right and upwards as seen from it; the picture's view of that point stays.
export function orbited(view, pivot, toRight, upwards) {
  const up = normalized(view.up);
  const now = elevation(normalized(subtract(pivot, view.eye)), up);
  const then = Math.min(kSteepest, Math.max(-kSteepest, now - upwards));
  const axis = new Pinhole(view, 2, 2).right;
  const around = (v) => turnedAround(turnedAround(v, axis, then - now), up, toRight);
  const eye = add(pivot, around(subtract(view.eye, pivot)));
  const line = around(subtract(view.target, view.eye));
  const pole = Math.abs(dot(normalized(line), up));
  return pole > Math.sin(radians(88)) ? view : {...view, eye, target: add(eye, line)};
}

/// Rows of the matrix that takes (x, y, 1) of a pixel of `from` to camera coordinates of `to`.
export function cameraFromPixel(from, to) {
  const columns = [times(from.right, 1 / from.focal), times(from.down, 1 / from.focal), from.ray([0, 0])];
  return columns.flatMap((column) => to.axes(column));  // column-major, as WebGL takes it
}
