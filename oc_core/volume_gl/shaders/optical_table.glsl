// A transfer function integrated over values: oc_core/volume_render/optical_table.h. Values are counted in its entries.
layout(binding = 2) uniform sampler2D optics;  // a column an entry: its integral, rest, at and halfChange

// The integrals up to a value: extinction, and red, green and blue times extinction.
struct OpticalPlace {
  float entry;
  vec4 integral;
  vec4 rest;
  vec4 at;
};

OpticalPlace opticalPlace(float entry) {
  // Beyond the table it is constant: the first and the last two entries are the same.
  int i = int(clamp(entry, 0.0, float(textureSize(optics, 0).x - 2)));
  float share = entry - float(i);
  vec4 first = texelFetch(optics, ivec2(i, 2), 0);
  vec4 halfGrowth = share * texelFetch(optics, ivec2(i, 3), 0);
  return OpticalPlace(entry, texelFetch(optics, ivec2(i, 0), 0),
                      texelFetch(optics, ivec2(i, 1), 0) + share * (first + halfGrowth), first + 2.0 * halfGrowth);
}

// The mean over the values between two places.
vec4 opticalBetween(OpticalPlace a, OpticalPlace b) {
  float change = b.entry - a.entry;
  // Where the field hardly changes, by the mean of both ends.
  vec4 mean = abs(change) < 1.0 ? 0.5 * (a.at + b.at)
                                : ((b.integral - a.integral) + (b.rest - a.rest)) / change;
  return max(mean, vec4(0));
}

// What the order of colours within a step adds to its light (ColorOrder of oc_core/volume_render/march_steps-inl.h).
// `before` and `after` are OpticalPlace::at of its ends, `through` is how much light passes all before and half of it.
vec3 lightOfOrder(vec4 before, vec4 after, vec4 mean, float depth, float through) {
  if (before.x <= 0.0 && after.x <= 0.0) {
    return vec3(0);
  }
  vec3 color = mean.yzw / mean.x;
  vec3 first = before.yzw / max(before.x, 1e-30);
  vec3 last = after.yzw / max(after.x, 1e-30);
  if (before.x <= 0.0) {
    first = 2.0 * color - last;
  }
  if (after.x <= 0.0) {
    last = 2.0 * color - first;
  }
  float likeEnds = min(0.5 * (before.x + after.x) / mean.x, 1.0);
  float square = depth * depth;
  float series = 1.0 + square * (1.0 / 40.0 + square / 4480.0);
  return (last - first) * (-square / 12.0 * series * through * likeEnds);
}
