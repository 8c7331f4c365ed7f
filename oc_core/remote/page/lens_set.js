// The lenses of the screen: rectangles that show more of what lies behind them (section 5.2.2), as the regions of a
// general pinhole: {center, extent, zoom, transition_width} in shares of the screen. They lie in the screen with their
// transitions, and none shares anything with another.
import {isFree, outerHalf} from './gpc_map.js';

export const maxLenses = 8;  // as many as a server takes
export const lensZoom = {min: 1, max: 16};
const kLensTransition = {min: 0.1, max: 4};
const kMinLensExtent = 0.04;
const kNewLens = {center: [0.5, 0.5], extent: [0.18, 0.26], zoom: 3, transition_width: 0.6};

const clamp = (x, least, most) => Math.min(most, Math.max(least, x));

export class LensSet {
  constructor() {
    this.lenses = [];
  }

  others(index) {
    return this.lenses.filter((_, i) => i !== index);
  }

  /// Takes over a changed lens where it is free. Returns whether it was.
  accept(index, lens) {
    if (!isFree(lens, this.others(index))) {
      return false;
    }
    this.lenses[index] = lens;
    return true;
  }

  /// A new one where there is room nearest to a point of the screen; smaller ones fit where larger ones do not. Its
  /// index, or -1 where there is no room.
  add(at = [0.5, 0.5]) {
    if (this.lenses.length >= maxLenses) {
      return -1;
    }
    for (let scale = 1; scale > 0.3; scale *= 0.75) {
      const lens = {...kNewLens, extent: kNewLens.extent.map((extent) => extent * scale)};
      const half = outerHalf(lens);
      let best = null;
      for (let y = 0; y <= 40; ++y) {
        for (let x = 0; x <= 40; ++x) {
          const center = [half[0] + (1 - 2 * half[0]) * x / 40, half[1] + (1 - 2 * half[1]) * y / 40];
          const distance = Math.hypot(center[0] - at[0], center[1] - at[1]);
          if ((best === null || distance < best.distance) && isFree({...lens, center}, this.lenses)) {
            best = {center, distance};
          }
        }
      }
      if (best !== null) {
        return this.lenses.push({...lens, center: best.center}) - 1;
      }
    }
    return -1;
  }

  remove(index) {
    this.lenses.splice(index, 1);
  }

  /// Towards a point; along others and the borders where these are in the way.
  move(index, center) {
    const lens = this.lenses[index];
    const half = outerHalf(lens);
    const [x, y] = [0, 1].map((axis) => clamp(center[axis], half[axis], 1 - half[axis]));
    return [[x, y], [x, lens.center[1]], [lens.center[0], y]].some((to) => this.accept(index, {...lens, center: to}));
  }

  /// A corner, -1 or 1 along each axis, goes to a point, and the one across stays.
  resize(index, corner, point) {
    const lens = this.lenses[index];
    const [x, y] = [0, 1].map((axis) => {
      const across = lens.center[axis] - corner[axis] * lens.extent[axis] / 2;
      const extent = Math.max(kMinLensExtent, corner[axis] * (point[axis] - across));
      return {center: across + corner[axis] * extent / 2, extent};
    });
    return this.accept(index, {...lens, center: [x.center, y.center], extent: [x.extent, y.extent]});
  }

  /// Both sides by a factor, around the middle.
  scale(index, factor) {
    const lens = this.lenses[index];
    const extent = lens.extent.map((each) => clamp(each * factor, kMinLensExtent, 1));
    return this.accept(index, {...lens, extent});
  }

  zoom(index, factor) {
    const lens = this.lenses[index];
    return this.accept(index, {...lens, zoom: clamp(lens.zoom * factor, lensZoom.min, lensZoom.max)});
  }

  widen(index, factor) {
    const lens = this.lenses[index];
    const width = clamp(lens.transition_width * factor, kLensTransition.min, kLensTransition.max);
    return this.accept(index, {...lens, transition_width: width});
  }

  /// As the layout of a general pinhole.
  layout(sampling) {
    return {sampling, regions: this.lenses};
  }
}
