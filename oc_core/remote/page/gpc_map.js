// The mapping of a general pinhole camera between the pixels of its image and those of the pinhole whose rays it takes:
// oc_core/camera/gpc_profile.h and gpc_map.h, in double precision. The shaders have the same in single precision
// (gpc_shader.js). Points are [x, y] in pixels; a layout is {sampling, regions} as in files of cameras.

/// Coefficients of (r - 1)^0 to (r - 1)^3 of f within the transition.
const kSamplings = {
  linear: (zoom, outer) => [1 / zoom, (outer - 1 / zoom) / (outer - 1), 0, 0],
  quadratic: (zoom, outer) => {
    const width = outer - 1;
    return [1 / zoom, 1 / zoom, outer * (1 - 1 / zoom) / (width * width), 0];
  },
  cubic: (zoom, outer) => {
    const width = outer - 1;
    const inner = 1 / zoom;
    const mean = (outer - inner) / width;
    return [inner, inner, (3 * mean - 2 * inner - 1) / width, (inner + 1 - 2 * mean) / (width * width)];
  },
};

export const samplingNames = Object.keys(kSamplings);

const kMaxNewtonSteps = 100;

export class GpcProfile {
  constructor(sampling, zoom, outer) {
    if (!(sampling in kSamplings)) {
      throw new RangeError(`no sampling is called "${sampling}": ${samplingNames.join(', ')}`);
    }
    this.zoom = zoom;
    this.outer = outer;
    this.c = kSamplings[sampling](zoom, outer);
  }

  polynomial(s) {
    const c = this.c;
    return c[0] + s * (c[1] + s * (c[2] + s * c[3]));
  }

  /// f: distances from the centre in half extents, of the image into the pinhole's.
  sampled(r) {
    return r <= 1 ? r / this.zoom : r >= this.outer ? r : this.polynomial(r - 1);
  }

  /// f'; at an edge that of the transition.
  slope(r) {
    if (r < 1 || r > this.outer) {
      return r < 1 ? 1 / this.zoom : 1;
    }
    const s = r - 1;
    return this.c[1] + s * (2 * this.c[2] + s * 3 * this.c[3]);
  }

  inverse(f) {
    if (f <= 1 / this.zoom) {
      return f * this.zoom;
    }
    if (f >= this.outer) {
      return f;
    }
    const c = this.c;
    if (c[3] === 0) {
      const over = f - c[0];
      const s = 2 * over / (c[1] + Math.sqrt(Math.max(c[1] * c[1] + 4 * c[2] * over, 0)));
      return Math.min(1 + s, this.outer);
    }
    let lower = 0;
    let upper = this.outer - 1;
    let s = upper * (f - c[0]) / (this.outer - c[0]);
    for (let i = 0; i < kMaxNewtonSteps; ++i) {
      const error = this.polynomial(s) - f;
      if (error > 0) {
        upper = s;
      } else {
        lower = s;
      }
      let next = s - error / this.slope(1 + s);
      if (!(next >= lower && next <= upper)) {
        next = (lower + upper) / 2;
      }
      if (Math.abs(next - s) <= 1e-14 * this.outer) {
        return 1 + next;
      }
      s = next;
    }
    return 1 + s;
  }
}

/// A region in pixels.
export class GpcZone {
  constructor(region, sampling, width, height) {
    this.center = [region.center[0] * width, region.center[1] * height];
    this.half = [region.extent[0] * width / 2, region.extent[1] * height / 2];
    this.profile = new GpcProfile(sampling, region.zoom, 1 + region.transition_width);
  }

  /// From the centre in half extents.
  distance(p) {
    return Math.max(Math.abs(p[0] - this.center[0]) / this.half[0], Math.abs(p[1] - this.center[1]) / this.half[1]);
  }

  scaled(p, factor) {
    return [this.center[0] + (p[0] - this.center[0]) * factor, this.center[1] + (p[1] - this.center[1]) * factor];
  }

  pinholeFromImage(p) {
    const r = this.distance(p);
    const {zoom, outer} = this.profile;
    return r <= 1 ? this.scaled(p, 1 / zoom) : r >= outer ? p : this.scaled(p, this.profile.sampled(r) / r);
  }

  imageFromPinhole(p) {
    const f = this.distance(p);
    const {zoom, outer} = this.profile;
    return f * zoom <= 1 ? this.scaled(p, zoom) : f >= outer ? p : this.scaled(p, this.profile.inverse(f) / f);
  }

  /// d(pinhole) / d(image) at a point of the image: [dx/du, dy/du, dx/dv, dy/dv].
  jacobian(p) {
    const d = [p[0] - this.center[0], p[1] - this.center[1]];
    const r = this.distance(p);
    const {zoom, outer} = this.profile;
    if (r <= 1 || r >= outer) {
      const scale = r <= 1 ? 1 / zoom : 1;
      return [scale, 0, 0, scale];
    }
    const g = this.profile.sampled(r) / r;
    const along = (this.profile.slope(r) - g) / r;
    const axis = Math.abs(d[0]) / this.half[0] >= Math.abs(d[1]) / this.half[1] ? 0 : 1;
    const factor = along * Math.sign(d[axis]) / this.half[axis];
    const result = [g, 0, 0, g];
    result[2 * axis] += d[0] * factor;
    result[2 * axis + 1] += d[1] * factor;
    return result;
  }
}

export class GpcMap {
  constructor(layout, width, height) {
    this.zones = layout.regions.map((region) => new GpcZone(region, layout.sampling, width, height));
  }

  /// The zone whose outer rectangle, the same in both images, holds a point.
  zoneAt(p) {
    return this.zones.find((zone) => zone.distance(p) < zone.profile.outer) ?? null;
  }

  pinholeFromImage(p) {
    return this.zoneAt(p)?.pinholeFromImage(p) ?? p;
  }

  imageFromPinhole(p) {
    return this.zoneAt(p)?.imageFromPinhole(p) ?? p;
  }

  /// pinholeFromImage() of the middle of each pixel: x and y of each, in rows from the top.
  places(width, height) {
    const places = new Float32Array(2 * width * height);
    for (let y = 0, i = 0; y < height; ++y) {
      for (let x = 0; x < width; ++x) {
        places[i++] = x + 0.5;
        places[i++] = y + 0.5;
      }
    }
    for (const {center, half, profile} of this.zones) {
      const {zoom, outer} = profile;
      const first = [0, 1].map((axis) => Math.max(0, Math.floor(center[axis] - outer * half[axis])));
      const last = [width, height].map((size, axis) => Math.min(size, Math.ceil(center[axis] + outer * half[axis])));
      for (let y = first[1]; y < last[1]; ++y) {
        const dy = y + 0.5 - center[1];
        for (let x = first[0]; x < last[0]; ++x) {
          const dx = x + 0.5 - center[0];
          const r = Math.max(Math.abs(dx) / half[0], Math.abs(dy) / half[1]);
          if (r < outer) {
            const scale = r <= 1 ? 1 / zoom : profile.polynomial(r - 1) / r;
            places[2 * (y * width + x)] = center[0] + dx * scale;
            places[2 * (y * width + x) + 1] = center[1] + dy * scale;
          }
        }
      }
    }
    return places;
  }

  jacobian(p) {
    return this.zoneAt(p)?.jacobian(p) ?? [1, 0, 0, 1];
  }

  /// Samples for each one of the pinhole, in the direction that has fewest.
  rateAt(p) {
    return 1 / singularValues(this.jacobian(p))[0];
  }
}

/// Of a matrix in columns [a, b, c, d] = [a c; b d], the greater first.
export function singularValues([a, b, c, d]) {
  const sum = Math.hypot(a + d, b - c);
  const difference = Math.hypot(a - d, b + c);
  return [(sum + difference) / 2, Math.abs(sum - difference) / 2];
}

/// What a region of a layout may be: GpcRegion of oc_core/camera/gpc_layout.h.
export const regionLimits = {zoom: [0.1, 64], extent: [1e-3, 1], transition: [0.01, 100]};

/// Half of a region's extent with its transition, shares of the image.
export function outerHalf(region) {
  return region.extent.map((extent) => extent / 2 * (1 + region.transition_width));
}

/// Whether a region lies in the image with its transition, and shares nothing with the others.
export function isFree(region, others) {
  const kTouch = 1e-6;
  const half = outerHalf(region);
  const isInside = [0, 1].every((axis) =>
    region.center[axis] - half[axis] >= -kTouch && region.center[axis] + half[axis] <= 1 + kTouch);
  return isInside && others.every((other) => {
    const otherHalf = outerHalf(other);
    return [0, 1].some((axis) =>
      Math.abs(region.center[axis] - other.center[axis]) >= half[axis] + otherHalf[axis] - kTouch);
  });
}
