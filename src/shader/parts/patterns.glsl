R"glsl(
// Patterns, as functions of the coordinates (u, v) of a surface. Two colours meet where binary32 says: it is a look, and no
// certificate speaks of it.

#if COORDINATES
const float TURN = 6.28318530717958648;

float turn(float first, float second) { return first == 0.0 && second == 0.0 ? 0.0 : fract(atan(second, first) / TURN); }
vec2 on_sphere(vec3 q) {
  return vec2(turn(q.x, -q.z), 0.5 + atan(q.y, length(q.xz)) / (0.5 * TURN));
}
vec2 on_round(vec3 q, vec3 axis, float height, vec3 first, vec3 second) {
  return vec2(turn(dot(q, first), dot(q, second)), dot(q, axis) / height);
}
vec2 on_flat(vec3 q, vec3 first, vec3 second) { return vec2(dot(q, first), dot(q, second)); }
vec2 on_triangle(vec3 q, vec3 e, vec3 f) {
  vec3 n = cross(e, f);
  return vec2(dot(cross(q, f), n), dot(cross(e, q), n)) / dot(n, n);
}
#endif

#if CHECKER || STRIPES
bool is_even(float whole) { return mod(whole, 2.0) == 0.0; }
#endif
#if CHECKER
bool checker(vec2 at) { return is_even(floor(at.x) + floor(at.y)); }
#endif
#if STRIPES
bool stripes(vec2 at) { return is_even(floor(at.x)); }
#endif
#if WAVES
float waves(vec2 at) { return 0.5 + 0.5 * sin(TURN * at.x) * sin(TURN * at.y); }
#endif
#if P6M
// The plane group p6m has turns by 60°, mirrors at each 30°, and the translations (1, 0) and (½, ½√3). Its mirrors divide
// the plane into triangles of which each holds one point of every orbit: 0 ≤ y ≤ x/√3 and x ≤ ½.
vec2 p6m_representative(vec2 at) {
  const float half_root = 0.866025403784438647;
  const vec2 rectangle = vec2(1.0, 2.0 * half_root);     // translations, of which the middle of the rectangle is one more
  vec2 p = abs(at - rectangle * floor(at / rectangle + 0.5));              // the mirrors x = 0 and y = 0
  if (p.x + 2.0 * half_root * p.y > 1.0) p = 0.5 * rectangle - p;          // nearer to the middle of the rectangle
  if (p.y > p.x * 0.577350269189625765)                                    // the mirror at 30°
    p = vec2(0.5 * p.x + half_root * p.y, abs(half_root * p.x - 0.5 * p.y));  // and, once more, y = 0
  return p;
}
// Stars with twelve points about the sixfold turns, within hexagons.
bool p6m(vec2 at) {
  vec2 p = p6m_representative(at);
  return (p.x + 1.5 * p.y < 0.38) != (p.x > 0.46);
}
#endif
)glsl"
