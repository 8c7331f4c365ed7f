// Emission and absorption along rays, from near to far: oc_core/volume_render/volume_renderer.h. One invocation a pixel.
//
// Samples stand at equal distances along what of a ray is one piece, and at its end; what is between two is a slab. Two
// loops stand in each other so that neighbours that look for something to see do not wait for those that light it:
// software renderers compute the light of a slab for all of their neighbours, whether they need it or not.
//
// A pixel that is not done after `maxTurns` turns of the loops keeps where it is, and goes on in the next pass: software
// renderers end a shader after 65535 turns, and GPUs reset one that takes seconds.
layout(local_size_x = 8, local_size_y = 8) in;
layout(binding = 1) uniform usampler3D bricks;  // how many bricks away something is seen; 0 within

struct Stop {
  uint piece;
  uint step;         // 0xffffffff: done
  float pieceBegin;  // length from where its chain of pieces begins
  float value;       // of the field there
};
layout(std430, binding = 0) buffer Stops { Stop stops[]; };
layout(std430, binding = 2) buffer Unfinished { uint unfinished; };

layout(location = 2) uniform float stepLength;
layout(location = 3) uniform float endTransmittance;
layout(location = 4) uniform float depthTransmittance;
layout(location = 5) uniform vec2 entryFromTexel;  // a value in entries: x times a texel plus y
layout(location = 6) uniform uint maxTurns;
layout(location = 7) uniform bool isFirstPass;

const uint kDone = 0xffffffffu;
const float kNowhere = 3.0e38;

float entryAt(vec3 index) {
  return entryFromTexel.x * texelField(index) + entryFromTexel.y;
}

ivec3 brickOf(vec3 index) {
  return clamp(ivec3(floor(index / float(BRICK_EDGE))), ivec3(0), textureSize(bricks, 0) - 1);
}

// How many steps from `index` on stay where `distance` bricks around show nothing.
uint emptySteps(vec3 index, vec3 way, float left, int distance) {
  ivec3 brick = brickOf(index);
  ivec3 first = brick - (distance - 1);
  ivec3 last = brick + distance;
  ivec3 size = textureSize(bricks, 0);
  float reach = left;
  for (int axis = 0; axis < 3; ++axis) {
    // The outermost bricks hold all that lies beyond.
    float wall = way[axis] > 0.0 ? (last[axis] >= size[axis] ? 1e30 : float(BRICK_EDGE * last[axis]))
                                 : (first[axis] <= 0 ? -1e30 : float(BRICK_EDGE * first[axis]));
    if (way[axis] != 0.0) {
      reach = min(reach, (wall - index[axis]) / way[axis]);
    }
  }
  return uint(max(reach / stepLength - 1e-3, 0.0));
}

// Where a ray is: sample `step` of a chain of pieces.
struct Place {
  uint piece;
  uint step;
  float pieceBegin;
};

void main() {
  ivec2 pixel = ivec2(gl_GlobalInvocationID.xy) + ivec2(0, firstRow);
  if (pixel.x >= imageSize(colors).x || pixel.y >= int(endRow)) {
    return;
  }
  uint stopIndex = uint((pixel.y - int(firstRow)) * imageSize(colors).x + pixel.x);
  Place place = Place(0u, 0u, 0.0);
  float value = 0.0;
  bool valueIsKnown = false;
  vec3 light = vec3(0);
  float transmittance = 1.0;
  float depthT = kNowhere;
  float samples = 0.0;
  if (!isFirstPass) {
    Stop stop = stops[stopIndex];
    if (stop.step == kDone) {
      return;
    }
    place = Place(stop.piece, stop.step, stop.pieceBegin);
    value = stop.value;
    valueIsKnown = true;
    vec4 color = imageLoad(colors, pixel);
    vec4 depth = imageLoad(depths, pixel);
    light = color.rgb;
    transmittance = depth.w;
    depthT = depth.x;
    samples = depth.z;
  }
  uint count = pieceCount(pixel);
  bool isDone = place.piece >= count;
  RayPiece piece = isDone ? RayPiece(vec3(0), 0.0, vec3(0), 0.0, vec3(0), 0.0, false) : pieceAt(place.piece);

  uint turns = 0u;
  while (!isDone && turns < maxTurns) {
    ++turns;
    // The next slab in which something is seen.
    vec4 mean = vec4(0);
    float slabLength = 0.0;
    float slabBegin = 0.0;  // from where `piece` begins
    vec3 slabMiddle = vec3(0);
    vec3 slabDirection = vec3(0);
    float slabT = 0.0;
    float slabTByLength = 0.0;
    bool isFound = false;
    while (!isFound && !isDone && turns < maxTurns) {
      ++turns;
      float along = float(place.step) * stepLength - place.pieceBegin;
      vec3 index = piece.from + piece.way * along;
      int distance = int(texelFetch(bricks, brickOf(index), 0).r);
      uint skipped = distance > 0 ? emptySteps(index, piece.way, piece.length - along, distance) : 0u;
      if (skipped > 0u) {
        place.step += skipped;
        valueIsKnown = false;
        continue;
      }
      // The sample at the other end, in this piece or in one that continues it.
      float target = float(place.step + 1u) * stepLength;
      RayPiece next = piece;
      uint nextPiece = place.piece;
      float nextBegin = place.pieceBegin;
      for (; target >= nextBegin + next.length && nextPiece + 1u < count;) {
        RayPiece behind = pieceAt(nextPiece + 1u);
        if (!behind.continues) {
          break;
        }
        nextBegin += next.length;
        next = behind;
        ++nextPiece;
      }
      float end = nextBegin + next.length;
      bool isLast = target >= end;
      float nextAlong = min(target, end) - nextBegin;
      vec3 nextIndex = next.from + next.way * nextAlong;
      int nextDistance = int(texelFetch(bricks, brickOf(nextIndex), 0).r);
      if (distance == 0 || nextDistance == 0) {
        if (!valueIsKnown) {
          value = entryAt(index);
          samples += 1.0;
        }
        float nextValue = entryAt(nextIndex);
        samples += 1.0;
        slabLength = min(target, end) - float(place.step) * stepLength;
        mean = opticalBetween(value, nextValue);
        isFound = mean.x * slabLength > 0.0;
        slabMiddle = 0.5 * (index + nextIndex);
        slabDirection = piece.direction;
        slabT = piece.t + piece.tByLength * along;
        float nextT = next.t + next.tByLength * nextAlong;
        slabTByLength = slabLength > 0.0 ? (nextT - slabT) / slabLength : 0.0;
        value = nextValue;
        valueIsKnown = true;
      } else {
        valueIsKnown = false;
      }
      place = Place(nextPiece, place.step + 1u, nextBegin);
      piece = next;
      if (isLast) {
        place = Place(nextPiece + 1u, 0u, 0.0);
        valueIsKnown = false;
        isDone = place.piece >= count;
        if (!isDone) {
          piece = pieceAt(place.piece);
        }
      }
    }
    if (isFound) {
      float opticalDepth = mean.x * slabLength;
      vec3 color = mean.yzw / mean.x;
#if SHADING
      vec2 lit = lightAt(slabMiddle, slabDirection);
      color = color * lit.x + lit.y;
#endif
      float before = transmittance;
      transmittance *= exp(-opticalDepth);
      light += (before - transmittance) * color;
      if (depthT == kNowhere && transmittance <= depthTransmittance) {
        depthT = slabT + slabTByLength * slabLength * clamp(log(before / depthTransmittance) / opticalDepth, 0.0, 1.0);
      }
      isDone = isDone || transmittance <= endTransmittance;
    }
  }
  vec4 surface = surfaceOf();
  float passed = transmittance;
  if (isDone && surface.w < kNowhere) {
    light += transmittance * surface.rgb;
    transmittance = 0.0;
  }
  imageStore(colors, pixel, vec4(light, 1.0 - transmittance));
  imageStore(depths, pixel, vec4(depthT, surface.w, samples, passed));
  stops[stopIndex] = Stop(place.piece, isDone ? kDone : place.step, place.pieceBegin,
                          valueIsKnown || isDone ? value : entryAt(piece.from + piece.way * (float(place.step) * stepLength - place.pieceBegin)));
  if (!isDone) {
    atomicAdd(unfinished, 1u);
  }
}
