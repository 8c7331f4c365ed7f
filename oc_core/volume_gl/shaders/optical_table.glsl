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
