// Where rays first meet a reference image, by steps along their projections: oc_core/depth_rays/stepped_image.h, whose
// recursion is a list of the ends of pieces here. Halves come from near to far, so that the first crossing is the first
// hit. project() is that of the camera.
layout(local_size_x = 8, local_size_y = 8) in;
layout(binding = 0) uniform sampler2D rayOrigins;  // and how far it reaches, 1 being the end of the step
layout(binding = 3) uniform sampler2D raySteps;
layout(binding = 4) uniform sampler2D samples;  // t, 0 where there is none, and the opacity of a hit
layout(binding = 5) uniform sampler2D sampleColors;
layout(binding = 0, rgba32f) writeonly uniform image2D hits;
layout(binding = 1, rgba32f) writeonly uniform image2D hitColors;
layout(binding = 2, rgba32ui) writeonly uniform uimage2D costs;

layout(location = 0) uniform vec3 lower;  // bounds of the samples
layout(location = 1) uniform vec3 upper;
layout(location = 2) uniform float coarsePixels;
layout(location = 3) uniform float finePixels;
layout(location = 4) uniform float joinFootprints;
layout(location = 5) uniform float focalOfReference;
layout(location = 6) uniform uint maxIterations;

const float kUnanswered = -1.0;  // kUnansweredDistance of gl_ray_walk.h

// A point of the ray, and what the image shows there.
struct Probe {
  uint place;       // in pieces of 1 / 2^MAX_HALVINGS of the part of the ray within the bounds
  vec2 pixel;
  float t;          // of the ray; 0 where it has no image
  float shown;      // t of the sample; 0 where there is none
};

struct Part {
  double first;
  double last;
};

double shareOf(Part part, uint place) {
  return part.first + (part.last - part.first) * (double(place) / double(1u << MAX_HALVINGS));
}

Probe probeAt(StraightRay ray, Part part, uint place) {
  Probe probe = Probe(place, vec2(0), 0.0, 0.0);
  Projected q = project(ray.origin + ray.step * float(shareOf(part, place)));
  if (!(q.t > 0.0)) {
    return probe;
  }
  probe.pixel = q.place;
  probe.t = q.t;
  vec2 corner = floor(q.place);
  ivec2 size = textureSize(samples, 0);
  if (all(greaterThanEqual(corner, vec2(0))) && all(lessThan(corner, vec2(size)))) {
    probe.shown = max(texelFetch(samples, ivec2(corner), 0).x, 0.0);
  }
  return probe;
}

double distanceBetween(Probe a, Probe b) {
  return length(dvec2(a.pixel) - dvec2(b.pixel));
}
double gapAt(Probe probe) {
  return 1.0LF / double(probe.shown) - 1.0LF / double(probe.t);
}

// The share of the ray, and the place in the image; a negative share for none.
struct Crossing {
  double share;
  dvec2 pixel;
};
Crossing crossingOf(StraightRay ray, Part part, Probe a, Probe b) {
  Crossing none = Crossing(-1.0LF, dvec2(0));
  if (a.shown == 0.0 || b.shown == 0.0) {
    return none;
  }
  double gapA = gapAt(a);
  double gapB = gapAt(b);
  if (!(gapA * gapB <= 0.0LF) || gapA == gapB) {
    return none;
  }
  double footprint = double(min(a.shown, b.shown)) / double(focalOfReference);
  double step = max(distanceBetween(a, b), 1.0LF);
  if (abs(double(a.shown) - double(b.shown)) > double(joinFootprints) * footprint * min(step, 1.5LF)) {
    return none;  // the gap between two surfaces
  }
  double between = gapA / (gapA - gapB);
  double shareA = shareOf(part, a.place);
  double share = shareA + (shareOf(part, b.place) - shareA) * between;
  if (share > double(ray.reach)) {
    return none;
  }
  return Crossing(share, dvec2(a.pixel) + (dvec2(b.pixel) - dvec2(a.pixel)) * between);
}

// The part of the ray within the bounds; false where there is none.
bool partWithin(StraightRay ray, out Part part) {
  part = Part(0.0LF, 1.0LF);
  for (int axis = 0; axis < 3; ++axis) {
    double way = double(ray.step[axis]) * double(ray.reach);
    double first = double(lower[axis]) - double(ray.origin[axis]);
    double last = double(upper[axis]) - double(ray.origin[axis]);
    if (way == 0.0LF) {
      if (first > 0.0LF || last < 0.0LF) {
        return false;
      }
      continue;
    }
    part.first = max(part.first, min(first / way, last / way));
    part.last = min(part.last, max(first / way, last / way));
  }
  bool isMet = part.first <= part.last;
  part.first *= double(ray.reach);
  part.last *= double(ray.reach);
  return isMet;
}

// Ends of pieces that follow each other, the next one last; each is as long as its halvings say.
Probe ends[MAX_HALVINGS + 1];
int halvings[MAX_HALVINGS + 1];

// Whether the walk came to its end: it is given up after `maxIterations` iterations of its loop.
bool walkSteps(StraightRay ray, Part part, inout Crossing found, inout uvec4 cost) {
  Probe a = probeAt(ray, part, 0u);
  ends[0] = probeAt(ray, part, 1u << MAX_HALVINGS);
  halvings[0] = 0;
  int count = 1;
  for (uint iteration = 0u; count > 0; ++iteration) {
    if (iteration == maxIterations) {
      return false;
    }
    Probe b = ends[count - 1];
    int halved = halvings[count - 1];
    bool both = a.t > 0.0 && b.t > 0.0;
    double pixels = both ? distanceBetween(a, b) : double(coarsePixels) * 2.0LF;
    bool isLast = halved >= MAX_HALVINGS;
    bool isHalved = false;
    if (!isLast && (halved < ALWAYS_HALVED || pixels > double(coarsePixels))) {
      isHalved = a.t > 0.0 || b.t > 0.0 || halved < UNSEEN_HALVINGS;
    } else if (both && pixels > double(finePixels) && !isLast) {
      ++cost.x;
      isHalved = a.shown > 0.0 || b.shown > 0.0;
      if (a.shown > 0.0 && b.shown > 0.0) {
        double gapA = gapAt(a);
        double gapB = gapAt(b);
        double moves = CLEARLY * (abs(1.0LF / double(a.t) - 1.0LF / double(b.t)) +
                                  abs(1.0LF / double(a.shown) - 1.0LF / double(b.shown)));
        isHalved = !(gapA * gapB > 0.0LF && min(abs(gapA), abs(gapB)) > moves);
      }
    } else if (both) {
      ++cost.y;
      found = crossingOf(ray, part, a, b);
      if (found.share >= 0.0LF) {
        return true;
      }
    }
    if (isHalved) {
      halvings[count - 1] = halved + 1;
      halvings[count] = halved + 1;
      ends[count++] = probeAt(ray, part, (a.place + b.place) / 2u);
    } else {
      a = b;
      --count;
    }
  }
  return true;
}

void main() {
  ivec2 texel = ivec2(gl_GlobalInvocationID.xy);
  if (any(greaterThanEqual(texel, imageSize(hits)))) {
    return;
  }
  vec4 origin = texelFetch(rayOrigins, texel, 0);
  StraightRay ray = StraightRay(origin.xyz, texelFetch(raySteps, texel, 0).xyz, origin.w);
  uvec4 cost = uvec4(0);
  vec4 hit = vec4(0);
  vec4 color = vec4(0);
  Crossing found = Crossing(-1.0LF, dvec2(0));
  Part part;
  if (isCastable(ray) && partWithin(ray, part)) {
    if (!walkSteps(ray, part, found, cost)) {
      hit = vec4(kUnanswered, 0, 0, 0);
    } else if (found.share >= 0.0LF) {
      ivec2 pixel = ivec2(floor(found.pixel));
      float opacity = texelFetch(samples, pixel, 0).y;
      hit = vec4(float(found.share) * length(ray.step), vec2(found.pixel), opacity);
      color = vec4(texelFetch(sampleColors, pixel, 0).rgb, opacity);
    }
  }
  imageStore(hits, texel, hit);
  imageStore(hitColors, texel, color);
  imageStore(costs, texel, cost);
}
