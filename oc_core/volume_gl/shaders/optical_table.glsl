// A transfer function integrated over values: oc_core/volume_render/optical_table.h. Values are counted in entries.
struct OpticalEntry {
  vec4 integral;  // extinction, and red, green and blue times extinction
  vec4 rest;
  vec4 at;
  vec4 change;
};
layout(std430, binding = 1) readonly buffer OpticalTable { OpticalEntry entries[]; };

const int kLastEntry = OPTICAL_ENTRIES - 1;
// Two values that are closer than this, in entries, are looked up once, between them.
const float kSameEntry = OPTICAL_SAME;

// The mean over the values between a and b.
vec4 opticalBetween(float a, float b) {
  float middle = 0.5 * (a + b);
  bool isSame = abs(b - a) < kSameEntry;
  int i = clamp(int(floor(isSame ? middle : a)), 0, kLastEntry);
  int k = clamp(int(floor(b)), 0, kLastEntry);
  vec4 atI = entries[i].at;
  vec4 changeI = entries[i].change;
  float shareI = (isSame ? middle : a) - float(i);
  float shareK = b - float(k);
  vec4 fromI = shareI * (atI + 0.5 * shareI * changeI);
  vec4 toK = shareK * (entries[k].at + 0.5 * shareK * entries[k].change);
  vec4 whole = (entries[k].integral - entries[i].integral) + (entries[k].rest - entries[i].rest);
  vec4 mean = isSame ? atI + shareI * changeI : (whole + (toK - fromI)) / (b - a);
  return max(mean, vec4(0));
}
