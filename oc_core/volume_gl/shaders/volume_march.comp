// Emission and absorption along rays, from near to far: oc_core/volume_render/volume_renderer.h. One invocation a pixel.
//
// Samples stand at equal distances along what of a ray is one chain of pieces, and at its end; what is between two is a
// slab. Two loops stand in each other, so that neighbours which look for something to see do not wait for those that
// light it: software renderers light a slab for all neighbours together, whether they need it or not.
//
// A pixel that is not done after `maxIterations` turns of the loops keeps where it is, and goes on in the next pass: software
// renderers end a shader after 65535 turns, and GPUs are reset where one takes seconds.
struct Stop {
  uint piece;
  uint step;         // kDone behind the last
  float chainBegin;  // length from where the chain begins to where the piece begins
  float entry;       // of the table, at the sample
};
layout(std430, binding = 0) buffer Stops { Stop stops[]; };
layout(std430, binding = 1) buffer Unfinished { uint unfinished; };
layout(binding = 0, rgba32f) uniform image2D colors;  // premultiplied
layout(binding = 1, rgba32f) uniform image2D depths;  // t, t of the surface, samples, optical depth before a surface

layout(location = 2) uniform float stepLength;
layout(location = 3) uniform float endTransmittance;
layout(location = 4) uniform float depthTransmittance;
layout(location = 5) uniform vec2 entryFromTexel;  // an entry is x times a texel plus y
layout(location = 6) uniform uint maxIterations;
layout(location = 7) uniform bool isFirstPass;

const uint kDone = 0xffffffffu;

// A piece, its number, and the length from where its chain begins to where it does.
struct ChainPiece {
  VolumeRayPiece ray;
  uint number;
  float begin;
};
const ChainPiece kNoChainPiece = ChainPiece(kNoPiece, 0u, 0.0);

// The piece of a chain of `count` pieces of a ray that holds a length from where the chain begins, looked for from
// `piece` on, which begins no farther than there. The last one holds all lengths beyond.
ChainPiece pieceAtLength(ChainPiece piece, float at, uint count) {
  while (at >= piece.begin + piece.ray.length && piece.number + 1u < count) {
    VolumeRayPiece behind = pieceAt(piece.number + 1u);
    if (!behind.continues) {
      break;
    }
    piece = ChainPiece(behind, piece.number + 1u, piece.begin + piece.ray.length);
  }
  return piece;
}

vec3 indexAtLength(ChainPiece piece, float at) {
  return piece.ray.from + piece.ray.way * (at - piece.begin);
}

float entryAt(vec3 index) {
  return entryFromTexel.x * texelField(index) + entryFromTexel.y;
}

void main() {
  ivec2 pixel = ivec2(gl_GlobalInvocationID.xy) + ivec2(0, firstRow);
  if (pixel.x >= imageSize(colors).x || pixel.y >= endRow) {
    return;
  }
  uint stopIndex = uint((pixel.y - firstRow) * imageSize(colors).x + pixel.x);
  // Where the ray is: at the sample `step` of a chain.
  uint step = 0u;
  ChainPiece piece = kNoChainPiece;
  vec3 light = vec3(0);
  // Of all slabs so far. What passes is computed from this sum: a product of many factors would gather the error that
  // OpenGL allows exp().
  float opticalDepth = 0.0;
  float transmittance = 1.0;
  float depthT = kNowhere;
  float samples = 0.0;
  bool isKnown = false;  // whether `known` is that of the place
  OpticalPlace known = kNoOpticalPlace;
  if (!isFirstPass) {
    Stop stop = stops[stopIndex];
    if (stop.step == kDone) {
      return;
    }
    step = stop.step;
    piece.number = stop.piece;
    piece.begin = stop.chainBegin;
    known = opticalPlace(stop.entry);
    isKnown = true;
    vec4 depth = imageLoad(depths, pixel);
    light = imageLoad(colors, pixel).rgb;
    opticalDepth = depth.w;
    transmittance = exp(-opticalDepth);
    depthT = depth.x;
    samples = depth.z;
  }
  uint count = pieceCount(pixel, stopIndex);
  bool isDone = piece.number >= count;
  if (!isDone) {
    piece.ray = pieceAt(piece.number);
  }
  // Empty bricks around the place.
  int empty = emptyBricksAround(indexAtLength(piece, float(step) * stepLength));

  uint turns = 0u;
  while (!isDone && turns < maxIterations) {
    ++turns;
    // The next slab in which something is seen, and the piece in which it begins. It may reach over several.
    Slab slab = Slab(kNoOpticalPlace, kNoOpticalPlace, vec4(0), 0.0, 0.0, 0.0);
    ChainPiece slabPiece = kNoChainPiece;
    float slabEnd = 0.0;  // length from where the chain begins
    bool isFound = false;
    while (!isFound && !isDone && turns < maxIterations) {
      ++turns;
      float begin = float(step) * stepLength;  // length from where the chain begins
      vec3 index = indexAtLength(piece, begin);
      float left = piece.ray.length - (begin - piece.begin);
      uint skipped = empty > 0 ? emptySteps(index, piece.ray.way, left, empty, stepLength) : 0u;
      if (skipped > 0u) {
        step += skipped;
        empty = emptyBricksAround(indexAtLength(piece, float(step) * stepLength));
        isKnown = false;
        continue;
      }
      // The sample at the other end, in this piece or in one that continues it.
      float target = begin + stepLength;
      ChainPiece next = pieceAtLength(piece, target, count);
      bool isLast = target >= next.begin + next.ray.length;
      float end = isLast ? next.begin + next.ray.length : target;
      vec3 nextIndex = indexAtLength(next, end);
      int nextEmpty = emptyBricksAround(nextIndex);
      bool isEmpty = empty > 0 && nextEmpty > 0;
      if (!isEmpty) {
        if (!isKnown) {
          known = opticalPlace(entryAt(index));
          samples += 1.0;
        }
        OpticalPlace behind = opticalPlace(entryAt(nextIndex));
        samples += 1.0;
        slab = Slab(known, behind, opticalBetween(known, behind), end - begin, 0.0, 0.0);
        isFound = slab.mean.x * slab.size > 0.0;
        slabPiece = piece;
        slabEnd = end;
        known = behind;
      }
      isKnown = !isEmpty && !isLast;
      empty = nextEmpty;
      ++step;
      piece = next;
      if (isLast) {
        step = 0u;
        piece = ChainPiece(kNoPiece, next.number + 1u, 0.0);
        isDone = piece.number >= count;
        if (!isDone) {
          piece.ray = pieceAt(piece.number);
          empty = emptyBricksAround(piece.ray.from);
        }
      }
    }
    if (isFound) {
      float slabDepth = slab.mean.x * slab.size;
      slab.before = transmittance;
      opticalDepth += slabDepth;
      transmittance = exp(-opticalDepth);
      slab.after = transmittance;
      float kept = max(slab.before - slab.after, 0.0);
      vec3 meanColor = slab.mean.yzw / slab.mean.x;
      vec3 added = kept * meanColor + lightOfOrder(slab, meanColor);
#if SHADING
      float center = slabEnd - 0.5 * slab.size;  // of the slab
      ChainPiece middle = pieceAtLength(slabPiece, center, count);
      vec2 lit = lightAt(indexAtLength(middle, center), middle.ray.direction);
      added = added * lit.x + kept * lit.y;
#endif
      light += added;
      if (depthT == kNowhere && transmittance <= depthTransmittance) {
        float share = clamp(log(slab.before / depthTransmittance) / slabDepth, 0.0, 1.0);
        float at = slabEnd - (1.0 - share) * slab.size;
        ChainPiece there = pieceAtLength(slabPiece, at, count);
        depthT = there.ray.t + there.ray.tByLength * (at - there.begin);
      }
      isDone = isDone || transmittance <= endTransmittance;
    }
  }
  if (!isDone) {
    float entry = isKnown ? known.entry : entryAt(indexAtLength(piece, float(step) * stepLength));
    stops[stopIndex] = Stop(piece.number, step, piece.begin, entry);
    atomicAdd(unfinished, 1u);
  } else {
    stops[stopIndex] = Stop(0u, kDone, 0.0, 0.0);
  }
  vec4 surface = isDone ? surfaceOf(stopIndex) : vec4(0, 0, 0, kNowhere);
  bool endsAtSurface = surface.w < kNowhere;
  light += endsAtSurface ? transmittance * surface.rgb : vec3(0);
  imageStore(colors, pixel, vec4(light, endsAtSurface ? 1.0 : 1.0 - transmittance));
  imageStore(depths, pixel, vec4(depthT, surface.w, samples, opticalDepth));
}
