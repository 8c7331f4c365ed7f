// Triangles from the depths of an image (3-D warping, section 5.2.1.4): flat parts as squares of many samples, the
// rest sample by sample, torn where oc_core/ocri/sample_join.h tears. Vertices are (place, 1/z) of the reference
// pinhole; what the image sees at infinity has 1/z = 0 and is as much a surface as any other.
import {smoothedLevels} from './depth_smoothing.js';
import {GpcMap} from './gpc_map.js';

/// Rules of ImageMeshOptions, oc_core/ocri/image_mesh.h.
const kDepthStepFootprints = 10;
const kSlopeToleranceFootprints = 1;
const kLongestStepPixels = 12;
const kLongestScaledStep = 1.5;

/// Side of the largest flat blocks, samples; where lenses bend the picture, which moves corners alone, they are smaller.
const kLargestBlock = 32;
const kLargestBentBlock = 8;
const kSamplesFromRim = 3;

/// Arrays that grow.
class Growing {
  constructor(Type) {
    this.data = new Type(1 << 16);
    this.size = 0;
  }
  reserve(more) {
    if (this.size + more > this.data.length) {
      const larger = new this.data.constructor(Math.max(2 * this.data.length, this.size + more));
      larger.set(this.data);
      this.data = larger;
    }
  }
  push(...values) {
    this.reserve(values.length);
    for (const value of values) {
      this.data[this.size++] = value;
    }
  }
  result() {
    return this.data.slice(0, this.size);
  }
}

/// 1/z between two values that follow each other: oc_core/remote/remote_depth.h.
const depthStep = ({inverseNear, inverseFar, levels}) => (inverseNear - inverseFar) / (levels - 1);

export class DepthMesh {
  /// `image`: {width, height, layout, focal, values (Uint16Array: 0 nothing, else 1 to levels), inverseNear, inverseFar,
  /// levels}.
  constructor(image) {
    this.width = image.width;
    this.height = image.height;
    this.focal = image.focal;
    this.map = new GpcMap(image.layout, image.width, image.height);
    this.step = depthStep(image);
    this.inverse = smoothedLevels(image.values, this.width, this.height).map(
      (level) => (level === 0 ? 0 : image.inverseFar + (level - 1) * this.step));
    this.places = this.map.places(this.width, this.height);
  }

  /// {vertices, triangles, gaps}: of vertices the place, 1/z and where in the image (u, v) they are; their indices; and
  /// of gaps three vertices a triangle, whose (u, v) is that of the colour it has. No block has fewer than `least`
  /// samples a side, nor more than `largest`; both are powers of 2.
  build(least, largest) {
    this.least = least;
    this.vertices = new Growing(Float32Array);
    this.triangles = new Growing(Uint32Array);
    this.gaps = new Growing(Float32Array);
    this.vertexOf = new Int32Array(this.width * this.height).fill(-1);
    for (let y = 0; y + 1 < this.height; y += largest) {
      for (let x = 0; x + 1 < this.width; x += largest) {
        this.addBlock(x, y, largest);
      }
    }
    return {vertices: this.vertices.result(), triangles: this.triangles.result(), gaps: this.gaps.result()};
  }

  addBlock(x, y, side) {
    if (x + 1 >= this.width || y + 1 >= this.height) {
      return;
    }
    const right = Math.min(x + side, this.width - 1);
    const bottom = Math.min(y + side, this.height - 1);
    if (side > this.least) {
      const isEven = side <= kLargestBentBlock || this.isEven(x, y, right, bottom);
      const plane = isEven ? this.planeOf(x, y, right, bottom) : null;
      if (plane !== null) {
        this.addFlatBlock(x, y, right, bottom, plane);
        return;
      }
      const half = side / 2;
      this.addBlock(x, y, half);
      this.addBlock(x + half, y, half);
      this.addBlock(x, y + half, half);
      this.addBlock(x + half, y + half, half);
      return;
    }
    this.addCell(x, y, right, bottom);
  }

  /// Whether samples of a block lie where its corners say, as its colours are interpolated between these.
  isEven(left, top, right, bottom) {
    const kTolerance = 0.4;  // pixels of the pinhole, of which a screen has fewer
    const at = (u, v) => this.map.pinholeFromImage([u, v]);
    const [u, v] = [(left + right) / 2, (top + bottom) / 2];
    const middles = [
      [u, v, [left, top], [right, bottom]], [u, top, [left, top], [right, top]],
      [u, bottom, [left, bottom], [right, bottom]], [left, v, [left, top], [left, bottom]],
      [right, v, [right, top], [right, bottom]],
    ];
    return middles.every(([x, y, from, to]) => {
      const [p, a, b] = [at(x, y), at(...from), at(...to)];
      return Math.hypot(p[0] - (a[0] + b[0]) / 2, p[1] - (a[1] + b[1]) / 2) <= kTolerance;
    });
  }

  /// 1/z = a + b (place.x - x0) + c (place.y - y0), where all samples of a block are on it; else null. A plane of the
  /// scene is one of 1/z, too.
  planeOf(left, top, right, bottom) {
    const {width, inverse, places} = this;
    const first = top * width + left;
    const a = inverse[first];
    if (a === 0) {
      for (let y = top; y <= bottom; ++y) {
        for (let x = left; x <= right; ++x) {
          if (inverse[y * width + x] !== 0) {
            return null;
          }
        }
      }
      return [0, 0, 0];
    }
    const across = top * width + right;
    const below = bottom * width + left;
    if (inverse[across] === 0 || inverse[below] === 0) {
      return null;
    }
    const x0 = places[2 * first];
    const y0 = places[2 * first + 1];
    const [x1, y1] = [places[2 * across] - x0, places[2 * across + 1] - y0];
    const [x2, y2] = [places[2 * below] - x0, places[2 * below + 1] - y0];
    const determinant = x1 * y2 - x2 * y1;
    const b = ((inverse[across] - a) * y2 - (inverse[below] - a) * y1) / determinant;
    const c = ((inverse[below] - a) * x1 - (inverse[across] - a) * x2) / determinant;
    // A footprint, of which an eye that moves by a third of the distance sees a third of a pixel; and what rounding left.
    const tolerance = Math.max(a / this.focal, 0.75 * this.step);
    for (let y = top; y <= bottom; ++y) {
      for (let x = left; x <= right; ++x) {
        const i = y * width + x;
        const value = inverse[i];
        const onPlane = a + b * (places[2 * i] - x0) + c * (places[2 * i + 1] - y0);
        if (value === 0 || !(Math.abs(value - onPlane) <= tolerance)) {
          return null;
        }
      }
    }
    return [a, b, c];
  }

  /// Wider by half a sample on each side, which closes seams between blocks of different sides, and gives samples at
  /// rims their pixel.
  addFlatBlock(left, top, right, bottom, [a, b, c]) {
    const first = top * this.width + left;
    const x0 = this.places[2 * first];
    const y0 = this.places[2 * first + 1];
    const index = this.vertices.size / 5;
    for (const [u, v] of [[left, top], [right + 1, top], [right + 1, bottom + 1], [left, bottom + 1]]) {
      const [x, y] = this.map.pinholeFromImage([u, v]);
      this.vertices.push(x, y, Math.max(0, a + b * (x - x0) + c * (y - y0)), u, v);
    }
    this.triangles.push(index, index + 1, index + 2, index, index + 2, index + 3);
  }

  addCell(x, y, right, bottom) {
    const {width} = this;
    const corners = [y * width + x, y * width + right, bottom * width + right, bottom * width + x];
    // Halves along the diagonal whose ends are closer to each other in depth.
    const step = (i, k) => Math.abs(this.inverse[corners[i]] - this.inverse[corners[k]]);
    const halves = step(0, 2) <= step(1, 3) ? [[0, 1, 2], [0, 2, 3]] : [[0, 1, 3], [1, 2, 3]];
    for (const half of halves) {
      const [i, j, k] = half.map((corner) => corners[corner]);
      if (this.joins(i, j) && this.joins(j, k) && this.joins(i, k)) {
        this.triangles.push(this.vertex(i), this.vertex(j), this.vertex(k));
      } else {
        this.addGap(i, j, k);
      }
    }
    for (const i of corners) {
      this.addSquare(i);
    }
  }

  vertex(i) {
    if (this.vertexOf[i] < 0) {
      const [u, v] = this.sampleAt(i);
      this.vertexOf[i] = this.vertices.size / 5;
      this.vertices.push(this.places[2 * i], this.places[2 * i + 1], this.inverse[i], u + 0.5, v + 0.5);
    }
    return this.vertexOf[i];
  }

  /// A sample that has joined none of its neighbours stands for its pixel, facing the reference pinhole.
  addSquare(i) {
    const {width, height} = this;
    const [x, y] = this.sampleAt(i);
    if (this.inverse[i] === 0 || this.vertexOf[i] >= 0 || (x > 0 && this.joins(i - 1, i)) ||
        (x + 1 < width && this.joins(i, i + 1)) || (y > 0 && this.joins(i - width, i)) ||
        (y + 1 < height && this.joins(i, i + width))) {
      return;
    }
    this.vertexOf[i] = this.vertices.size / 5;
    this.addFlatBlock(x, y, x, y, [this.inverse[i], 0, 0]);
  }

  sampleAt(i) {
    const u = i % this.width;
    return [u, (i - u) / this.width];
  }

  /// It has the colour of the farther side, some samples away from the rim: there colours are those of both sides, by
  /// averages and by lossy formats.
  addGap(...samples) {
    const byDepth = [...samples].sort((i, k) => this.inverse[i] - this.inverse[k]);
    let far = byDepth[0];
    const step = far - byDepth[2];
    for (let i = 0; i < kSamplesFromRim && this.isBeside(far, far + step) && this.joins(far, far + step); ++i) {
      far += step;
    }
    const [u, v] = this.sampleAt(far);
    for (const i of samples) {
      this.gaps.push(this.places[2 * i], this.places[2 * i + 1], this.inverse[i], u + 0.5, v + 0.5);
    }
  }

  /// Whether two samples lie on one surface, as samplesJoin() of sample_join.h.
  joins(i, k) {
    const p = this.inverse[i];
    const q = this.inverse[k];
    if (p === 0 || q === 0) {
      return p === q;
    }
    const distance = this.between(i, k);
    if (!(distance <= kLongestStepPixels * this.least)) {
      return false;
    }
    const spacing = Math.max(Math.min(distance, 1), 1e-3);
    const footprint = Math.min(1 / p, 1 / q) / this.focal * spacing;
    const steps = Math.min(Math.max(distance / spacing, 1), Math.max(kLongestScaledStep, this.least));
    // Rounding alone may part samples by one step.
    const rounding = 1.01 * this.step;
    if (Math.abs(1 / p - 1 / q) <= kDepthStepFootprints * footprint * steps || Math.abs(p - q) <= rounding) {
      return true;
    }
    // A grazing surface goes on as on one of the two sides.
    const tolerance = kSlopeToleranceFootprints * footprint * p * q + rounding;
    const [before, after] = [2 * i - k, 2 * k - i];
    const goesOn = (a, b) => {
      if (!this.isBeside(a, b) || this.inverse[a] === 0 || this.inverse[b] === 0) {
        return false;
      }
      const slope = (this.inverse[b] - this.inverse[a]) / Math.max(this.between(a, b), 0.1);
      return Math.abs(q - p - slope * distance) <= tolerance;
    };
    return goesOn(before, i) || goesOn(k, after);
  }

  between(i, k) {
    return Math.hypot(this.places[2 * i] - this.places[2 * k], this.places[2 * i + 1] - this.places[2 * k + 1]);
  }

  /// Whether there are two such samples, in rows and columns not wrapped around the border.
  isBeside(i, k) {
    const isSample = (j) => j >= 0 && j < this.inverse.length;
    return isSample(i) && isSample(k) && Math.abs(i % this.width - k % this.width) <= 2 * kLargestBlock;
  }
}

/// With as few triangles as asked for, of coarser blocks where it takes that. `isBent`: seen through lenses. `least` is the
/// side of the smallest blocks to begin with.
export function depthMesh(image, {maxTriangles, isBent, least}) {
  const mesh = new DepthMesh(image);
  const largest = isBent ? kLargestBentBlock : kLargestBlock;
  let built = mesh.build(least, largest);
  while (least < kLargestBentBlock && built.triangles.length / 3 + built.gaps.length / 15 > maxTriangles) {
    least *= 2;
    built = mesh.build(least, largest);
  }
  return {...built, least};
}
