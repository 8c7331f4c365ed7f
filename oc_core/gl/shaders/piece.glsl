// A piece of a scene triangle: which one, and the barycentric weights (b1, b2) of its three corners on it. In lists it
// takes seven words.
struct Piece {
  uint triangle;
  vec2 a;
  vec2 b;
  vec2 c;
};
const uint kPieceWords = 7u;

vec3 pointOf(vec3 corners[3], vec2 b) {
  return corners[0] * (1.0 - b.x - b.y) + corners[1] * b.x + corners[2] * b.y;
}
