// Which images are blended where: the nearest three places around a point of the map, by barycentric coordinates.
'use strict';

window.ocelliSea = {};

(() => {
  const kCandidates = 10;
  const kTiny = 1e-9;

  /// Places in square cells of a plan, to find the nearest.
  class PlacePlan {
    constructor(places) {
      this.points = places.map(({eye}) => [eye[0], eye[2]]);
      const xs = this.points.map(([x]) => x);
      const zs = this.points.map(([, z]) => z);
      const least = (values) => values.reduce((a, b) => Math.min(a, b));
      const most = (values) => values.reduce((a, b) => Math.max(a, b));
      this.lower = [least(xs), least(zs)];
      this.upper = [most(xs), most(zs)];
      const size = [this.upper[0] - this.lower[0], this.upper[1] - this.lower[1]];
      // About two places a cell; at most 1000 cells along a side.
      this.cell = Math.max(Math.sqrt(2 * size[0] * size[1] / this.points.length), Math.max(...size) / 1000, 1e-6);
      this.cells = new Map();
      this.points.forEach((point, index) => {
        const key = this.keyOf(...this.cellOf(point));
        if (!this.cells.has(key)) {
          this.cells.set(key, []);
        }
        this.cells.get(key).push(index);
      });
    }

    cellOf([x, z]) {
      return [Math.floor((x - this.lower[0]) / this.cell), Math.floor((z - this.lower[1]) / this.cell)];
    }

    keyOf(i, j) {
      return i * 4096 + j;
    }

    clamped([x, z]) {
      return [Math.min(Math.max(x, this.lower[0]), this.upper[0]), Math.min(Math.max(z, this.lower[1]), this.upper[1])];
    }

    /// Indices of the `count` nearest places, the nearest first.
    nearest(point, count) {
      const inside = this.clamped(point);
      const [ci, cj] = this.cellOf(inside);
      const far = Math.ceil(Math.max(this.upper[0] - this.lower[0], this.upper[1] - this.lower[1]) / this.cell) + 1;
      const found = [];
      for (let ring = 0; ring <= far; ++ring) {
        for (let j = cj - ring; j <= cj + ring; ++j) {
          const step = Math.abs(j - cj) === ring ? 1 : Math.max(1, 2 * ring);
          for (let i = ci - ring; i <= ci + ring; i += step) {
            for (const index of this.cells.get(this.keyOf(i, j)) ?? []) {
              found.push([Math.hypot(this.points[index][0] - inside[0], this.points[index][1] - inside[1]), index]);
            }
          }
        }
        // What is farther away than this ring reaches may be behind others in the next one.
        if (found.filter(([distance]) => distance <= ring * this.cell).length >= Math.min(count, this.points.length)) {
          break;
        }
      }
      found.sort((a, b) => a[0] - b[0] || a[1] - b[1]);
      return found.slice(0, count).map(([, index]) => index);
    }
  }

  function barycentric(p, a, b, c) {
    const area = (b[0] - a[0]) * (c[1] - a[1]) - (c[0] - a[0]) * (b[1] - a[1]);
    const reach = Math.max(Math.hypot(b[0] - a[0], b[1] - a[1]), Math.hypot(c[0] - a[0], c[1] - a[1]));
    if (Math.abs(area) <= 1e-6 * reach * reach) {
      return null; // places in a line
    }
    const u = ((p[0] - a[0]) * (c[1] - a[1]) - (c[0] - a[0]) * (p[1] - a[1])) / area;
    const v = ((b[0] - a[0]) * (p[1] - a[1]) - (p[0] - a[0]) * (b[1] - a[1])) / area;
    return [1 - u - v, u, v];
  }

  /// [{index, weight}], the greatest weight first; weights add up to 1. One where the point is a place, two where no
  /// triangle of near places holds it.
  function blendAt(plan, point) {
    const p = plan.clamped(point);
    const near = plan.nearest(p, kCandidates);
    const at = (index) => plan.points[index];
    const distance = (index) => Math.hypot(at(index)[0] - p[0], at(index)[1] - p[1]);
    let best = null;
    let least = Infinity;
    for (let i = 0; i < near.length; ++i) {
      for (let j = i + 1; j < near.length; ++j) {
        for (let k = j + 1; k < near.length; ++k) {
          const three = [near[i], near[j], near[k]];
          const sum = three.reduce((total, index) => total + distance(index), 0);
          if (sum >= least) {
            continue;
          }
          const weights = barycentric(p, ...three.map(at));
          if (weights !== null && Math.min(...weights) >= -kTiny) {
            least = sum;
            best = three.map((index, n) => ({index, weight: Math.max(0, weights[n])}));
          }
        }
      }
    }
    if (best === null && near.length > 1) {
      const [a, b] = near.map(at);
      const along = [b[0] - a[0], b[1] - a[1]];
      const length2 = along[0] ** 2 + along[1] ** 2;
      const t = length2 > 0 ? ((p[0] - a[0]) * along[0] + (p[1] - a[1]) * along[1]) / length2 : 0;
      const weight = Math.min(Math.max(t, 0), 1);
      best = [{index: near[0], weight: 1 - weight}, {index: near[1], weight}];
    }
    best ??= [{index: near[0], weight: 1}];
    best = best.filter(({weight}) => weight > 1e-4).sort((a, b) => b.weight - a.weight);
    const total = best.reduce((sum, {weight}) => sum + weight, 0);
    return best.map(({index, weight}) => ({index, weight: weight / total}));
  }

  /// The next place to walk to from a point in a direction (x, z of length 1), or null: near, and straight ahead rather
  /// than aside.
  function nextPlace(plan, point, direction) {
    let best = null;
    let least = Infinity;
    for (const index of plan.nearest(point, 24)) {
      const way = [plan.points[index][0] - point[0], plan.points[index][1] - point[1]];
      const length = Math.hypot(...way);
      const cosine = length > 0 ? (way[0] * direction[0] + way[1] * direction[1]) / length : 0;
      // Within 50 degrees of the way.
      if (cosine < 0.64) {
        continue;
      }
      const cost = length / cosine ** 3;
      if (cost < least) {
        least = cost;
        best = index;
      }
    }
    return best;
  }

  Object.assign(window.ocelliSea, {PlacePlan, blendAt, nextPlace});
})();
