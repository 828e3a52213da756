R"glsl(
// The first hit, in binary32. A ray has a unit direction. It starts on an element, or on none: the constant term of that
// element is 0, since the start lies on it, so that no surface meets itself by rounding.

struct Meeting {
  float t;
  int element;
};

void meet(float t, int element, inout Meeting first) {
  if (t > 0.0 && t < first.t) first = Meeting(t, element);
}

#if SPHERES > 0
void meet_spheres(vec3 p, vec3 v, int start, inout Meeting first) {
  for (int i = 0; i < SPHERES; ++i) {
    vec3 q = p - SPHERE[i].xyz;
    float b = dot(q, v);
    vec3 aside = q - b * v;  // from the centre to the line, which no far centre cancels
    float square = SPHERE[i].w * SPHERE[i].w - dot(aside, aside);
    float h = i == start ? abs(b) : sqrt(max(square, 0.0));
    float t = -b - h > 0.0 ? -b - h : -b + h;
    if (i == start || square >= 0.0) meet(t, i, first);
  }
}
#endif

#if ROUNDS > 0
// Cylinders, cones and truncated cones are one form: with w from the apex, or from the base of a cylinder,
// |w|² − (1 + k²)(w·d)² − r² = 0, where k is 0 or r is.
void meet_rounds(vec3 p, vec3 v, int start, inout Meeting first) {
  for (int i = 0; i < ROUNDS; ++i) {
    vec3 d = ROUND_AXIS[i].xyz, q = p - ROUND_BASE[i].xyz;
    float height = ROUND_BASE[i].w, apex = ROUND_AXIS[i].w, slope = ROUND_FORM[i].x, square = ROUND_FORM[i].y;
    float s = dot(q, d), climb = dot(v, d), m = s - apex;
    vec3 w = q - s * d, u = v - climb * d;
    float a = dot(u, u) - slope * climb * climb;
    float b = dot(w, u) - slope * m * climb;
    float c = dot(w, w) - slope * m * m - square;
    vec3 x = cross(w + m * d, v);
    float k = dot(x, d);
    vec3 across = x - k * d;
    float under = square * a + slope * dot(across, across) - k * k;
    bool starts = SPHERES + i == start;
    if (starts) c = 0.0;
    float h = starts ? abs(b) : sqrt(max(under, 0.0));
    float z = b > 0.0 ? -b - h : -b + h;
    if (starts || under >= 0.0) {
      float one = z / a, other = c / z;
      float at_one = s + one * climb, at_other = s + other * climb;
      if (at_one >= 0.0 && at_one <= height) meet(one, SPHERES + i, first);
      if (at_other >= 0.0 && at_other <= height) meet(other, SPHERES + i, first);
    }
  }
}
#endif

#if PLANES > 0
void meet_planes(vec3 p, vec3 v, int start, inout Meeting first) {
  for (int i = 0; i < PLANES; ++i) {
    float t = -dot(PLANE_NORMAL[i], p - PLANE_AT[i]) / dot(PLANE_NORMAL[i], v);
    if (FIRST_PLANE + i != start) meet(t, FIRST_PLANE + i, first);
  }
}
#endif

#if DISCS > 0
void meet_discs(vec3 p, vec3 v, int start, inout Meeting first) {
  for (int i = 0; i < DISCS; ++i) {
    vec3 q = p - DISC[i].xyz;
    float t = -dot(DISC_NORMAL[i], q) / dot(DISC_NORMAL[i], v);
    vec3 w = q + t * v;
    if (FIRST_DISC + i != start && dot(w, w) <= DISC[i].w * DISC[i].w) meet(t, FIRST_DISC + i, first);
  }
}
#endif

#if TRIANGLES > 0
void meet_triangles(vec3 p, vec3 v, int start, inout Meeting first) {
  for (int i = 0; i < TRIANGLES; ++i) {
    vec3 a = CORNER_A[i] - p, b = CORNER_B[i] - p, c = CORNER_C[i] - p;
    vec3 sides = vec3(dot(v, cross(a, EDGE_A[i])), dot(v, cross(b, EDGE_B[i])), dot(v, cross(c, EDGE_C[i])));
    bool inside = all(greaterThanEqual(sides, vec3(0.0))) || all(lessThanEqual(sides, vec3(0.0)));
    float t = dot(TRIANGLE_NORMAL[i], a) / dot(TRIANGLE_NORMAL[i], v);
    if (FIRST_TRIANGLE + i != start && inside) meet(t, FIRST_TRIANGLE + i, first);
  }
}
#endif

Meeting first_meeting(vec3 p, vec3 v, int start) {
  Meeting first = Meeting(FAR, NOTHING);
#if SPHERES > 0
  meet_spheres(p, v, start, first);
#endif
#if ROUNDS > 0
  meet_rounds(p, v, start, first);
#endif
#if PLANES > 0
  meet_planes(p, v, start, first);
#endif
#if DISCS > 0
  meet_discs(p, v, start, first);
#endif
#if TRIANGLES > 0
  meet_triangles(p, v, start, first);
#endif
  return first;
}
)glsl"
