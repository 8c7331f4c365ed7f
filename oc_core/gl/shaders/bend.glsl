// A bend of a curved ray camera (oc_core/camera/ray_transition.h), and where it shows points. All places are taken from
// the viewpoint before the bend, C0. ARCS is one of the two models.
#define CONIC 1
#define BEZIER 2
const int kMaxSides = 16;
layout(std140, binding = 1) uniform Bend {
  vec4 before;         // C0, in the world
  vec4 beyond;         // C1
  vec4 from;           // t0: normal, and the height of C0
  vec4 to;             // t2
  vec4 axis;           // from C0 to C1
  vec4 linePoint;      // of the line that the planes have in common
  vec4 lineDirection;
  vec4 border;
  vec4 rowsBefore[3];  // u, v and their weight, of a place before the bend
  vec4 rowsAfter[3];   // after it, from C1
  vec4 sides[kMaxSides];
  int sideCount;
  int straight;        // C0 is C1
  float shortestEdge;
  uint piece;
  float bendFactor;  // oc_core/render/bend_projection.h
  float bendWidth;
};

const float kMinWeight = 0.05;
const float kMaxPixels = 1e6;

struct BendPoint {
  vec3 p;
  vec2 image;
  float weight;
  float first;  // distance from the first plane, positive in the bend
  float last;   // from the last plane, positive in the bend
  float share;  // of the bend that is passed
  bool imaged;
};

vec3 projected(vec4 rows[3], vec3 p) {
  return vec3(dotInOrder(rows[0].xyz, p), dotInOrder(rows[1].xyz, p), dotInOrder(rows[2].xyz, p));
}

// The root in [0, 1] of a quadratic in Bernstein form, of which the first and the last coefficient differ in sign.
float bernsteinRoot(vec3 b) {
  float side = abs(b.x) > abs(b.z) ? (b.x > 0.0 ? 1.0 : -1.0) : (b.z < 0.0 ? 1.0 : -1.0);
  b *= side;
  float root = sqrt(max(b.y * b.y - b.x * b.z, 0.0));
  float numerator = b.y >= 0.0 ? b.y + root : b.x;
  float denominator = b.y >= 0.0 ? -b.z : root - b.y;
  return !(b.x > 0.0) || !(b.z < 0.0) ? (b.x > 0.0 ? 1.0 : 0.0) : numerator / (numerator + denominator);
}

// Where an arc over S, with weights of 1, meets a line through A in its epipolar plane, whose side this is.
vec3 onArc(vec3 s, vec3 a, vec3 side, out float u) {
  vec3 t = s * (from.w / (from.w - (dot(from.xyz, s) + from.w)));
  float heightBeyond = dot(to.xyz, beyond.xyz) + to.w;
  float heightS = dot(to.xyz, s) + to.w;
  vec3 q = (s * heightBeyond - beyond.xyz * heightS) / (heightBeyond - heightS);
  u = bernsteinRoot(vec3(dot(side, t - a), dot(side, s - a), dot(side, q - a)));
  return t * ((1.0 - u) * (1.0 - u)) + s * (2.0 * u * (1.0 - u)) + q * (u * u);
}

// Where the ray of a point within the bend meets the middle plane; w is 0 where it is on none.
vec4 middleOf(vec3 p) {
  vec3 normal = normalize(cross(axis.xyz, p));
  float along = dot(normal, lineDirection.xyz);
  vec3 a = linePoint.xyz - lineDirection.xyz * (dot(normal, linePoint.xyz) / along);
  vec3 s = border.xyz - lineDirection.xyz * (dot(normal, border.xyz) / along);
  vec3 side = cross(normal, p - a);
  float u;
#if ARCS == CONIC
  vec3 up = cross(normal, axis.xyz);
  vec3 onB = onArc(s, a, side, u);
  vec3 towards = a - onB;
  float share = dot(p - onB, towards) / dot(towards, towards);
  float mu = share / (1.0 - share) * dot(up, s) / dot(up, onB);
  return vec4((s + a * mu) / (1.0 + mu), share < 1.0 && 1.0 + mu > 0.0 ? 1.0 : 0.0);
#else
  // As RayTransition::findBezier(): the rays of the plane lie one beside the other.
  float wanted = distance(p, a);
  float inner = 0.0;
  float outer = 1.0;
  for (int i = 0; i < 5; ++i) {
    if (distance(onArc(mix(a, s, outer), a, side, u), a) <= wanted) {
      inner = outer;
      outer *= 2.0;
    }
  }
  float most = outer;
  for (int i = 0; i < 24; ++i) {
    float middle = 0.5 * (inner + outer);
    bool isTooFar = distance(onArc(mix(a, s, middle), a, side, u), a) > wanted;
    inner = isTooFar ? inner : middle;
    outer = isTooFar ? middle : outer;
  }
  return vec4(mix(a, s, inner), most <= 16.0 ? 1.0 : 0.0);
#endif
}

// Beyond its planes a bend goes on as the straight rays do that are tangent to it.
BendPoint bendPoint(vec3 p) {
  BendPoint point;
  point.p = p;
  point.first = dot(from.xyz, p) + from.w;
  point.last = -(dot(to.xyz, p) + to.w);
  vec3 beforeBend = projected(rowsBefore, p);
  vec3 afterBend = projected(rowsAfter, p - beyond.xyz);
  vec4 middle = middleOf(p);
  vec3 image = projected(rowsBefore, middle.xyz);
  bool held = middle.w > 0.0;
  float share = clamp(point.first / (point.first + point.last), 0.0, 1.0);
  if (straight != 0 || point.first < 0.0) {
    image = beforeBend;
    held = true;
    share = 0.0;
  } else if (point.last < 0.0) {
    image = afterBend;
    held = true;
    share = 1.0;
  }
  point.share = share;
  point.image = image.xy / image.z;
  float least = kMinWeight * image.z;
  point.weight = mix(max(beforeBend.z, least), max(afterBend.z, least), share);
  point.imaged = held && image.z > 0.0 && point.weight > 0.0 && abs(point.image.x) < kMaxPixels &&
                 abs(point.image.y) < kMaxPixels;
  return point;
}
