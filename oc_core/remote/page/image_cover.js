// Which views an image covers: oc_core/remote/client/image_cover.h, and how dense it is under lenses. Each number is 1 at
// the end of what is covered, and grows on from there.
import {GpcMap, singularValues} from './gpc_map.js';
import {Pinhole, length, subtract, radians, degrees} from './view_math.js';

export const coverLimits = {
  leastDetail: 0.7,  // samples for a pixel in the middle of a view
  largestParallax: 0.06,  // between near and far things, heights of the view
  largestAngle: 0.1,  // by which near things are seen from another side, radians
};
const kOutermost = 20;
const kMaxSideDegrees = 80;

/// {nearZ, farZ}: one sample of kOutermost is nearer than the first, and one farther than the second; 0 where there are
/// none. `values` as the server sends them.
export function depthSpanOf({values, inverseNear, inverseFar, levels}) {
  const counts = new Uint32Array(65536);
  for (const value of values) {
    ++counts[value];
  }
  const rank = Math.floor((values.length - counts[0]) / kOutermost);
  const zOfRank = (first, step) => {
    let left = rank;
    for (let value = first; value > 0 && value < 65536; value += step) {
      if (counts[value] > left) {
        return 1 / (inverseFar + (value - 1) * (inverseNear - inverseFar) / (levels - 1));
      }
      left -= counts[value];
    }
    return 0;
  };
  return {nearZ: zOfRank(65535, -1), farZ: zOfRank(1, 1)};
}

const kUnknownDepths = {nearZ: 0, farZ: 0};

export class ImageCover {
  /// `layout` {sampling, regions}.
  constructor(view, width, height, layout, depths = kUnknownDepths) {
    this.reference = new Pinhole(view, width, height);
    this.map = new GpcMap(layout, width, height);
    this.depths = depths;
  }

  withDepths(depths) {
    return Object.assign(Object.create(ImageCover.prototype), this, {depths});
  }
}

/// Samples for a pixel of a view with this focal length, in a direction of the world.
function samplesAt(cover, direction, focal) {
  const {reference, map} = cover;
  const place = reference.place(direction);
  if (place === null) {
    return 0;
  }
  const within = [Math.min(Math.max(place[0], 0), reference.width), Math.min(Math.max(place[1], 0), reference.height)];
  return map.rateAt(map.imageFromPinhole(within)) * reference.focal / focal;
}

/// `lenses` are the regions of the screen. Detail then counts for pixels of the screen as it is with them, in the middle
/// of each and in that of the screen.
export function coverLoad(cover, view, screen, lenses = [], limits = coverLimits) {
  const pinhole = new Pinhole(view, screen[0], screen[1]);
  const {reference} = cover;
  const half = [reference.width / 2, reference.height / 2];
  let reach = 0;
  for (const corner of [[0, 0], [screen[0], 0], [0, screen[1]], screen]) {
    const place = reference.place(pinhole.ray(corner));
    const out = place === null ? Infinity :
      Math.max(Math.abs(place[0] - half[0]) / half[0], Math.abs(place[1] - half[1]) / half[1]);
    reach = Math.max(reach, out);
  }
  const lensMap = new GpcMap({sampling: 'cubic', regions: lenses}, ...screen);
  let detail = 0;
  for (const share of [[0.5, 0.5], ...lenses.map((lens) => lens.center)]) {
    const pixel = [share[0] * screen[0], share[1] * screen[1]];
    const [across, along] = singularValues(lensMap.jacobian(pixel));
    const samples = samplesAt(cover, pinhole.ray(lensMap.pinholeFromImage(pixel)), pinhole.focal);
    detail = Math.max(detail, limits.leastDetail / (samples * Math.sqrt(across * along)));
  }
  const offset = length(subtract(view.eye, reference.eye));
  const {nearZ, farZ} = cover.depths;
  let shift = 0;
  if (offset > 0) {
    const parallax = offset * (1 / nearZ - 1 / farZ) * pinhole.focal / screen[1] / limits.largestParallax;
    shift = nearZ > 0 ? Math.max(parallax, offset / nearZ / limits.largestAngle) : Infinity;
  }
  return {reach, detail, shift, whole: Math.max(reach, detail, shift)};
}

/// By how much wider than the screen an image is along each axis, in angles: reachOf() of oc_core/remote/remote_plan.cpp.
function reachOf(screen, focal, reach) {
  const most = radians(kMaxSideDegrees);
  return screen.map((pixels) => {
    const tangent = pixels / 2 / focal;
    return Math.max(tangent, Math.tan(Math.min(Math.atan(tangent) * reach, most))) / tangent;
  });
}

/// What an image that is asked for at a view will cover, by the server's settings: planRemoteImage() of
/// oc_core/remote/remote_plan.h, without its largest images and without the regions of lenses.
export function plannedCover(view, screen, settings) {
  const {reach = 1, size = 1, middle = 0.5, zoom = 1, sampling = 'cubic'} = settings;
  const wider = reachOf(screen, new Pinhole(view, ...screen).focal, reach);
  const [width, height] = screen.map((pixels, axis) => Math.max(1, Math.round(pixels * wider[axis] * size / reach)));
  const half = Math.tan(radians(view.fov_vertical_degrees) / 2) * wider[1];
  const shift = (view.center_shift ?? [0, 0]).map((each) => each / wider[1]);
  const regions = zoom > 1 ?
    [{center: [0.5, 0.5], extent: [middle, middle], zoom, transition_width: 1 / middle - 1}] : [];
  return new ImageCover({...view, fov_vertical_degrees: degrees(2 * Math.atan(half)), center_shift: shift}, width, height,
    {sampling, regions});
}
