R"glsl(
// The look of a surface at a point: the coefficients of its material, and its normal on the outer side.

struct Look {
  vec3 color;
  float k_a, k_d, k_s, e, k_ps;
  vec3 M_PS;
  float k_t;
  vec3 M_T, emission, ambient;
};

float grey(vec3 color) { return (color.x + color.y + color.z) / 3.0; }

// Axes are unit vectors but for their last digits. Both sides of a comparison are computed where pixels go together, so that
// each index keeps within its array.
vec3 normal_of(int element, vec3 at) {
  vec3 n = vec3(0.0);
#if SPHERES > 0
  if (element < SPHERES) n = normalize(at - SPHERE[min(element, SPHERES - 1)].xyz);
#endif
#if ROUNDS > 0
  if (element >= SPHERES && element < FIRST_PLANE) {
    int i = clamp(element - SPHERES, 0, ROUNDS - 1);
    vec3 d = ROUND_AXIS[i].xyz, q = at - ROUND_BASE[i].xyz;
    float s = dot(q, d);
    n = q - s * d - ROUND_FORM[i].x * (s - ROUND_AXIS[i].w) * d;
    n = n == vec3(0.0) ? d : normalize(n);
  }
#endif
#if PLANES > 0
  if (element >= FIRST_PLANE && element < FIRST_DISC) n = PLANE_NORMAL[clamp(element - FIRST_PLANE, 0, PLANES - 1)];
#endif
#if DISCS > 0
  if (element >= FIRST_DISC && element < FIRST_TRIANGLE) n = DISC_NORMAL[clamp(element - FIRST_DISC, 0, DISCS - 1)];
#endif
#if TRIANGLES > 0
  if (element >= FIRST_TRIANGLE) n = normalize(TRIANGLE_NORMAL[clamp(element - FIRST_TRIANGLE, 0, TRIANGLES - 1)]);
#endif
  return n;
}
)glsl"
