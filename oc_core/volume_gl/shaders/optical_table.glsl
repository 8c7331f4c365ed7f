// A transfer function integrated over values: oc_core/volume_render/optical_table.h. Values are counted in its entries.
layout(binding = 2) uniform sampler2D optics;  // a column an entry: its integral, rest, at and halfChange

// The integrals up to a value: extinction, and red, green and blue times extinction.
struct OpticalPlace {
  float entry;
  vec4 integral;
  vec4 rest;
  vec4 at;
};
const OpticalPlace kNoOpticalPlace = OpticalPlace(0.0, vec4(0), vec4(0), vec4(0));

OpticalPlace opticalPlace(float entry) {
  // Beyond the table it is constant: the first and the last two entries are the same.
  int i = int(clamp(entry, 0.0, float(textureSize(optics, 0).x - 2)));
  float share = entry - float(i);
  vec4 halfGrowth = share * texelFetch(optics, ivec2(i, 3), 0);
  vec4 halfway = texelFetch(optics, ivec2(i, 2), 0) + halfGrowth;
  OpticalPlace place = OpticalPlace(entry, texelFetch(optics, ivec2(i, 0), 0),
                                    texelFetch(optics, ivec2(i, 1), 0) + share * halfway, halfway + halfGrowth);
  return place;
}

// The mean over the values between two places.
vec4 opticalBetween(OpticalPlace a, OpticalPlace b) {
  float change = b.entry - a.entry;
  // Where the field hardly changes, by the mean of both ends.
  vec4 mean = abs(change) < 1.0 ? 0.5 * (a.at + b.at)
                                : ((b.integral - a.integral) + (b.rest - a.rest)) / change;
  return max(mean, vec4(0));
}

// A slab between two places, with the mean of extinction and colours times extinction between them, and how much of the
// light passes all before it, and all before its end.
struct Slab {
  OpticalPlace begin;
  OpticalPlace end;
  vec4 mean;
  float size;  // its length
  float before;
  float after;
};

// What the order of colours within a slab adds to its light, which is that of its mean colour: ColorOrder of
// oc_core/volume_render/march_steps-inl.h.
vec3 lightOfOrder(Slab slab, vec3 meanColor) {
  bool isBegin = slab.begin.at.x > 0.0;
  bool isEnd = slab.end.at.x > 0.0;
  // An end that shows nothing has no colour: it lies as far from the mean as the other.
  vec3 first = slab.begin.at.yzw / (isBegin ? slab.begin.at.x : 1.0);
  vec3 last = slab.end.at.yzw / (isEnd ? slab.end.at.x : 1.0);
  first = isBegin ? first : 2.0 * meanColor - last;
  last = isEnd ? last : 2.0 * meanColor - first;
  float depth = slab.mean.x * slab.size;
  float bounded = min(depth, 1.0);
  float square = bounded * bounded;
  float series = 1.0 + square * (1.0 / 40.0 + square * (1.0 / 4480.0));
  float bySeries = -square / 12.0 * series * sqrt(slab.before * slab.after);
  float closed = (slab.before - slab.after) / max(depth, 1.0) - 0.5 * (slab.before + slab.after);
  // Of a slab that is seen by a peak within it, rather than by what its ends have, these say little. An end that shows
  // nothing takes nothing from what the other says.
  float ends = (isBegin && isEnd ? 0.5 : 1.0) * (slab.begin.at.x + slab.end.at.x);
  float weight = (depth > 1.0 ? closed : bySeries) * min(ends / slab.mean.x, 1.0);
  float steep = 1.0 - 1.0 / max(depth, 1.0);
  vec3 order = mix(last - first, 2.0 * (meanColor - first), steep);
  return isBegin || isEnd ? weight * order : vec3(0);
}
