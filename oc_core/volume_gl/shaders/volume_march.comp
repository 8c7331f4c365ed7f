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

// Where a ray is: the sample `step` of a chain of pieces.
struct Place {
  uint piece;
  uint step;
  float chainBegin;
};

float entryAt(vec3 index) {
  return entryFromTexel.x * texelField(index) + entryFromTexel.y;
}

void main() {
  ivec2 pixel = ivec2(gl_GlobalInvocationID.xy) + ivec2(0, firstRow);
  if (pixel.x >= imageSize(colors).x || pixel.y >= endRow) {
    return;
  }
  uint stopIndex = uint((pixel.y - firstRow) * imageSize(colors).x + pixel.x);
  Place place = Place(0u, 0u, 0.0);
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
    place = Place(stop.piece, stop.step, stop.chainBegin);
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
  bool isDone = place.piece >= count;
  VolumeRayPiece piece = isDone ? kNoPiece : pieceAt(place.piece);
  // Empty bricks around the place.
  int empty = emptyBricksAround(piece.from + piece.way * (float(place.step) * stepLength - place.chainBegin));

  uint turns = 0u;
  while (!isDone && turns < maxIterations) {
    ++turns;
    // The next slab in which something is seen, and the pieces in which it begins and ends.
    Slab slab = Slab(kNoOpticalPlace, kNoOpticalPlace, vec4(0), 0.0, 0.0, 0.0);
    VolumeRayPiece slabPiece = kNoPiece;
    VolumeRayPiece slabEndPiece = kNoPiece;
    float slabEnd = 0.0;  // lengths from where the chain begins
    float slabChainBegin = 0.0;
    float slabEndChainBegin = 0.0;
    bool isFound = false;
    while (!isFound && !isDone && turns < maxIterations) {
      ++turns;
      float begin = float(place.step) * stepLength;  // length from where the chain begins
      float along = begin - place.chainBegin;
      vec3 index = piece.from + piece.way * along;
      uint skipped = empty > 0 ? emptySteps(index, piece.way, piece.length - along, empty, stepLength) : 0u;
      if (skipped > 0u) {
        place.step += skipped;
        empty = emptyBricksAround(piece.from + piece.way * (float(place.step) * stepLength - place.chainBegin));
        isKnown = false;
        continue;
      }
      // The sample at the other end, in this piece or in one that continues it.
      float target = begin + stepLength;
      VolumeRayPiece next = piece;
      uint nextPiece = place.piece;
      float nextBegin = place.chainBegin;
      while (target >= nextBegin + next.length && nextPiece + 1u < count) {
        VolumeRayPiece behind = pieceAt(nextPiece + 1u);
        if (!behind.continues) {
          break;
        }
        nextBegin += next.length;
        next = behind;
        ++nextPiece;
      }
      bool isLast = target >= nextBegin + next.length;
      float end = isLast ? nextBegin + next.length : target;
      vec3 nextIndex = next.from + next.way * (end - nextBegin);
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
        slabEndPiece = next;
        slabEnd = end;
        slabChainBegin = place.chainBegin;
        slabEndChainBegin = nextBegin;
        known = behind;
      }
      isKnown = !isEmpty && !isLast;
      empty = nextEmpty;
      place = Place(nextPiece, place.step + 1u, nextBegin);
      piece = next;
      if (isLast) {
        place = Place(nextPiece + 1u, 0u, 0.0);
        isDone = place.piece >= count;
        if (!isDone) {
          piece = pieceAt(place.piece);
          empty = emptyBricksAround(piece.from);
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
      bool isInNext = center >= slabEndChainBegin;
      vec3 index = isInNext ? slabEndPiece.from + slabEndPiece.way * (center - slabEndChainBegin)
                            : slabPiece.from + slabPiece.way * (center - slabChainBegin);
      vec2 lit = lightAt(index, isInNext ? slabEndPiece.direction : slabPiece.direction);
      added = added * lit.x + kept * lit.y;
#endif
      light += added;
      if (depthT == kNowhere && transmittance <= depthTransmittance) {
        float share = clamp(log(slab.before / depthTransmittance) / slabDepth, 0.0, 1.0);
        float from = slabPiece.t + slabPiece.tByLength * (slabEnd - slab.size - slabChainBegin);
        float to = slabEndPiece.t + slabEndPiece.tByLength * (slabEnd - slabEndChainBegin);
        depthT = mix(from, to, share);
      }
      isDone = isDone || transmittance <= endTransmittance;
    }
  }
  if (!isDone) {
    float along = float(place.step) * stepLength - place.chainBegin;
    float entry = isKnown ? known.entry : entryAt(piece.from + piece.way * along);
    stops[stopIndex] = Stop(place.piece, place.step, place.chainBegin, entry);
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
