// How the cameras displace the image of the pinhole. MODEL is one of the four.
#define SPOC 1
#define REVERSE_PINHOLE 2
#define DDOC 3
#define GPC 4

layout(std140, binding = 1) uniform Displacement {
  vec2 pole;               // SPOC, pixels
  float displacedFrom;     // SPOC: z_n
  float inverseNear;       // SPOC: 1/z_n
  float perInverseZ;       // SPOC: 1 / (1/z_n - 1/z_f)
  float nearPixels;        // SPOC: d_n
  float farPixels;         // SPOC: d_f
  float sameImageDepth;    // reverse pinhole: z'
  float meetingDepth;      // reverse pinhole: z_m
  float clipMargin;        // pixels beyond the borders from where the longest displacement leads into the image
  uint bilinear;           // DDOC: the lookup
  float longestEdge;       // of subdivision, pixels
  float shortestEdge;
  float tornEdge;
};

#if MODEL == SPOC
vec2 distorted(vec2 q, float z) {
  if (z < displacedFrom) {
    return q;
  }
  float ramp = min((inverseNear - 1.0 / z) * perInverseZ, 1.0);
  float shift = nearPixels + (farPixels - nearPixels) * ramp;
  vec2 fromPole = q - pole;
  float far = length(fromPole);
  return q + (far > 0.0 ? fromPole / far : vec2(1, 0)) * shift;
}
bool displacesWithin(vec2 lower, vec2 upper) {
  return true;
}
#elif MODEL == REVERSE_PINHOLE
vec2 distorted(vec2 q, float z) {
  float magnification = z / sameImageDepth * (meetingDepth - sameImageDepth) / (meetingDepth - z);
  return center + (q - center) * magnification;
}
bool displacesWithin(vec2 lower, vec2 upper) {
  return true;
}
#elif MODEL == DDOC
// Displacement, 1/z_n and 1/z_f of each pixel.
layout(binding = 1) uniform sampler2D map;
// Samples of the map that displace, above and to the left of each corner of a pixel.
layout(binding = 2) uniform usampler2D displacedBefore;

vec2 distorted(vec2 q, float z) {
  ivec2 size = textureSize(map, 0);
  vec2 at = clamp(q - 0.5, vec2(0), vec2(size - 1));
  vec4 s;
  if (bilinear == 0u) {
    s = texelFetch(map, ivec2(floor(at + 0.5)), 0);
  } else {
    ivec2 lower = ivec2(at);
    ivec2 upper = min(lower + 1, size - 1);
    vec2 f = at - vec2(lower);
    s = texelFetch(map, lower, 0) * ((1.0 - f.x) * (1.0 - f.y)) +
        texelFetch(map, ivec2(upper.x, lower.y), 0) * (f.x * (1.0 - f.y)) +
        texelFetch(map, ivec2(lower.x, upper.y), 0) * ((1.0 - f.x) * f.y) + texelFetch(map, upper, 0) * (f.x * f.y);
  }
  float range = s.z - s.w;
  float ramp = range > 0.0 ? clamp((s.z - 1.0 / z) / range, 0.0, 1.0) : 0.0;
  return q + s.xy * ramp;
}
bool displacesWithin(vec2 lower, vec2 upper) {
  ivec2 size = textureSize(map, 0);
  ivec2 first = ivec2(clamp(lower - 0.5, vec2(0), vec2(size - 1)));
  ivec2 last = min(ivec2(clamp(upper - 0.5, vec2(0), vec2(size - 1))) + 2, size);
  return texelFetch(displacedBefore, last, 0).x + texelFetch(displacedBefore, first, 0).x !=
         texelFetch(displacedBefore, ivec2(first.x, last.y), 0).x +
             texelFetch(displacedBefore, ivec2(last.x, first.y), 0).x;
}
#elif MODEL == GPC
// A row for each zone, as oc_core/camera/gpc_map.h has it: centre and half extent; 1 / zoom, outer, and the least and the
// greatest sampling rate; the coefficients of f in the transition.
layout(binding = 1) uniform sampler2D zones;

// r of a value of f between the two edges (gpc_profile.h): f grows with r.
float inverseOf(float f, float outer, vec2 rates, vec4 c) {
  float lower = max((f - c.x) * rates.x, 0.0);
  float upper = min((f - c.x) * rates.y, outer - 1.0);
  float s = 0.5 * (lower + upper);
  for (int i = 0; i < 24; ++i) {
    float error = c.x + s * (c.y + s * (c.z + s * c.w)) - f;
    if (error > 0.0) {
      upper = s;
    } else {
      lower = s;
    }
    float next = s - error / (c.y + s * (2.0 * c.z + s * 3.0 * c.w));
    if (!(next >= lower && next <= upper)) {
      next = 0.5 * (lower + upper);
    }
    if (next == s) {
      break;
    }
    s = next;
  }
  return 1.0 + s;
}

vec2 distorted(vec2 q, float z) {
  int count = textureSize(zones, 0).y;
  for (int i = 0; i < count; ++i) {
    vec4 place = texelFetch(zones, ivec2(0, i), 0);
    vec4 rates = texelFetch(zones, ivec2(1, i), 0);
    vec2 d = q - place.xy;
    float f = max(abs(d.x) / place.z, abs(d.y) / place.w);
    if (f < rates.y) {
      float r = f <= rates.x ? f / rates.x : inverseOf(f, rates.y, rates.zw, texelFetch(zones, ivec2(2, i), 0));
      return f > 0.0 ? place.xy + d * (r / f) : q;
    }
  }
  return q;
}
bool displacesWithin(vec2 lower, vec2 upper) {
  int count = textureSize(zones, 0).y;
  for (int i = 0; i < count; ++i) {
    vec4 place = texelFetch(zones, ivec2(0, i), 0);
    vec2 reach = place.zw * texelFetch(zones, ivec2(1, i), 0).y;
    if (all(lessThanEqual(lower, place.xy + reach)) && all(greaterThanEqual(upper, place.xy - reach))) {
      return true;
    }
  }
  return false;
}
#endif
