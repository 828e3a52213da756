R"glsl(
// The certificate of a pixel's element. A ball is a number of binary32 and a bound on its distance from the exact value, of
// which it is the rounded one: the value by the numbers of the scene and of the camera as they are, before any rounding.
//
// One operation of binary32 is off by 2⁻²³ of its result at most, whichever way the processor rounds. U is twice that. The
// second half pays for sums in another order and for products that are fused, which a compiler of shaders may choose (the
// error of a sum is then still a share of the sum of its terms' magnitudes), and for the rounding of the bounds themselves,
// some hundred times 2⁻²³ of each. Numbers below TINY may be flushed to 0. Quotients and roots, which the language lets be
// off by some units more, count eightfold.

const float U = 2.384185791015625e-7;
const float TINY = 1e-36;

struct Ball {
  float m, r;
};
struct Balls {
  vec3 m, r;
};

Ball given(float x) { return Ball(x, U * abs(x)); }
Balls given(vec3 x) { return Balls(x, U * abs(x)); }

Ball minus(Ball a) { return Ball(-a.m, a.r); }

Ball add(Ball a, Ball b) {
  float m = a.m + b.m;
  return Ball(m, a.r + b.r + U * abs(m));
}
Ball sub(Ball a, Ball b) { return add(a, minus(b)); }
Ball mul(Ball a, Ball b) {
  float m = a.m * b.m;
  return Ball(m, abs(a.m) * b.r + a.r * abs(b.m) + a.r * b.r + U * abs(m) + TINY);
}
Balls sub(Balls a, Balls b) {
  vec3 m = a.m - b.m;
  return Balls(m, a.r + b.r + U * abs(m));
}
Balls mul(Ball a, Balls b) {
  vec3 m = a.m * b.m;
  return Balls(m, abs(a.m) * b.r + a.r * abs(b.m) + a.r * b.r + U * abs(m) + TINY);
}
// The three roundings of a sum of three products are a share of the sum of their magnitudes each.
Ball inner(Balls a, Balls b) {
  vec3 x = abs(a.m), y = abs(b.m);
  return Ball(dot(a.m, b.m), dot(x, b.r) + dot(a.r, y) + dot(a.r, b.r) + 3.0 * U * dot(x, y) + TINY);
}
vec3 magnitudes(vec3 a, vec3 b) { return a.yzx * b.zxy + a.zxy * b.yzx; }
Balls outer(Balls a, Balls b) {
  vec3 x = abs(a.m), y = abs(b.m);
  return Balls(cross(a.m, b.m), magnitudes(x, b.r) + magnitudes(a.r, y) + magnitudes(a.r, b.r) +
                                    2.0 * U * magnitudes(x, y) + TINY);
}
// The whole line where the divisor may be 0, or is next to it. Else |â/b̂ − a/b| ≤ (r_a + |â/b̂|·r_b)/|b|.
Ball quotient(Ball a, Ball b) {
  float least = abs(b.m) - b.r;
  float m = a.m / b.m;
  if (!(least > 0.0) || !(abs(m) < 1e20)) return Ball(0.0, FAR);
  return Ball(m, (a.r + abs(m) * b.r) / least * (1.0 + 16.0 * U) + 8.0 * U * abs(m));
}
// The root of what is not negative of the ball.
Ball root(Ball a) {
  float low = sqrt(max(0.0, a.m - a.r)), high = sqrt(max(0.0, a.m + a.r));
  return Ball(0.5 * (low + high), 0.5 * (high - low) + 8.0 * U * high);
}
float low(Ball a) { return a.m - a.r; }
float high(Ball a) { return a.m + a.r; }

// Where an element's first point may be. It has none where low is FAR; it is sure to have one where high is less.
struct Span {
  float low, high;
};

void reach(Ball t, bool is_sure, inout Span span) {
  if (high(t) <= 0.0) return;
  span.low = min(span.low, max(low(t), 0.0));
  if (is_sure && low(t) > 0.0) span.high = min(span.high, high(t));
}

// The elements whose first points are sure to be before all others, and the two least beginnings of their spans.
struct Verdict {
  float high;
  int element;
  float least;
  int least_element;
  float second;
};

void judge(Span span, int element, inout Verdict verdict) {
  if (span.low < verdict.least) {
    verdict.second = verdict.least;
    verdict.least = span.low;
    verdict.least_element = element;
  } else {
    verdict.second = min(verdict.second, span.low);
  }
  if (span.high < verdict.high) {
    verdict.high = span.high;
    verdict.element = element;
  }
}

// No element is certain where another one's span begins before the end of the nearest, or where none is sure and some may be.
bool is_doubtful(Verdict verdict) {
  if (verdict.high == FAR) return verdict.least < FAR;
  return (verdict.least_element == verdict.element ? verdict.second : verdict.least) <= verdict.high;
}

#if SPHERES > 0 || ROUNDS > 0
// The roots of a t² + 2 b t + c = 0, where `under` is b² − a c by terms that cancel less: the one whose terms add up, and
// the other by the product of both.
struct Roots {
  Ball one, other;
  bool are_sure;
};
Roots roots(Ball a, Ball b, Ball c, Ball under) {
  Ball h = root(under), z = sub(h, b);
  if (b.m > 0.0) z = minus(add(b, h));
  return Roots(quotient(z, a), quotient(c, z), low(under) > 0.0);
}
#endif

#if SPHERES > 0
void judge_spheres(Balls p, Balls v, inout Verdict verdict) {
  Ball a = inner(v, v);
  for (int i = 0; i < SPHERES; ++i) {
    Balls q = sub(p, given(SPHERE[i].xyz));
    Ball r = given(SPHERE[i].w);
    Ball square = mul(r, r);
    Balls x = outer(q, v);
    Ball under = sub(mul(square, a), inner(x, x));  // b² − a c: r²|v|² − |q × v|²
    if (high(under) < 0.0) continue;
    Roots at = roots(a, inner(q, v), sub(inner(q, q), square), under);
    Span span = Span(FAR, FAR);
    reach(at.one, at.are_sure, span);
    reach(at.other, at.are_sure, span);
    judge(span, i, verdict);
  }
}
#endif

#if ROUNDS > 0
// A root counts where its advance s lies between 0 and the height.
void reach_within(Ball t, bool is_sure, Ball s, Ball climb, Ball height, inout Span span) {
  Ball at = add(s, mul(t, climb));
  if (high(at) < 0.0 || low(at) > high(height)) return;
  reach(t, is_sure && low(at) > 0.0 && high(at) < low(height), span);
}

void judge_rounds(Balls p, Balls v, inout Verdict verdict) {
  for (int i = 0; i < ROUNDS; ++i) {
    Balls d = given(ROUND_AXIS[i].xyz), q = sub(p, given(ROUND_BASE[i].xyz));
    Ball height = given(ROUND_BASE[i].w), slope = given(ROUND_FORM[i].x), square = given(ROUND_FORM[i].y);
    Ball s = inner(q, d), climb = inner(v, d), m = sub(s, given(ROUND_AXIS[i].w));
    Balls w = sub(q, mul(s, d)), u = sub(v, mul(climb, d));
    // b² − a c: r²a + k²|x − (x·d)d|² − (x·d)², with x = w × v and w from the apex. A cylinder may start anywhere on its axis.
    Balls x = outer(sub(q, mul(given(ROUND_AXIS[i].w), d)), v);
    Ball a = sub(inner(u, u), mul(slope, mul(climb, climb)));
    Ball b = sub(inner(w, u), mul(slope, mul(m, climb)));
    Ball c = sub(sub(inner(w, w), mul(slope, mul(m, m))), square);
    Ball k = inner(x, d);
    Balls across = sub(x, mul(k, d));
    Ball under = sub(add(mul(square, a), mul(slope, inner(across, across))), mul(k, k));
    if (high(under) < 0.0) continue;
    Roots at = roots(a, b, c, under);
    Span span = Span(FAR, FAR);
    reach_within(at.one, at.are_sure, s, climb, height, span);
    reach_within(at.other, at.are_sure, s, climb, height, span);
    judge(span, SPHERES + i, verdict);
  }
}
#endif

#if PLANES > 0
void judge_planes(Balls p, Balls v, inout Verdict verdict) {
  for (int i = 0; i < PLANES; ++i) {
    Balls n = given(PLANE_NORMAL[i]);
    Span span = Span(FAR, FAR);
    reach(quotient(inner(n, sub(given(PLANE_AT[i]), p)), inner(n, v)), true, span);
    judge(span, FIRST_PLANE + i, verdict);
  }
}
#endif

#if DISCS > 0
// The point of the plane is within the disc where |q (n·v) − v (n·q)| ≤ r |n·v|.
void judge_discs(Balls p, Balls v, inout Verdict verdict) {
  for (int i = 0; i < DISCS; ++i) {
    Balls n = given(DISC_NORMAL[i]), q = sub(p, given(DISC[i].xyz));
    Ball up = inner(n, q), along = inner(n, v), r = mul(given(DISC[i].w), along);
    Balls w = sub(mul(along, q), mul(up, v));
    Ball beyond = sub(inner(w, w), mul(r, r));
    if (low(beyond) > 0.0) continue;
    Span span = Span(FAR, FAR);
    reach(minus(quotient(up, along)), high(beyond) < 0.0, span);
    judge(span, FIRST_DISC + i, verdict);
  }
}
#endif

#if TRIANGLES > 0
// The line passes within the triangle where it passes the three edges on one side.
void judge_triangles(Balls p, Balls v, inout Verdict verdict) {
  for (int i = 0; i < TRIANGLES; ++i) {
    Balls n = given(TRIANGLE_NORMAL[i]);
    Balls from = sub(given(CORNER_A[i]), p);
    Ball a = inner(v, outer(from, given(EDGE_A[i])));
    Ball b = inner(v, outer(sub(given(CORNER_B[i]), p), given(EDGE_B[i])));
    Ball c = inner(v, outer(sub(given(CORNER_C[i]), p), given(EDGE_C[i])));
    float least = min(high(a), min(high(b), high(c))), most = max(low(a), max(low(b), low(c)));
    if (least < 0.0 && most > 0.0) continue;
    bool is_sure = min(low(a), min(low(b), low(c))) > 0.0 || max(high(a), max(high(b), high(c))) < 0.0;
    Span span = Span(FAR, FAR);
    reach(quotient(inner(n, from), inner(n, v)), is_sure, span);
    judge(span, FIRST_TRIANGLE + i, verdict);
  }
}
#endif

Verdict verdict_of(Balls p, Balls v) {
  Verdict verdict = Verdict(FAR, NOTHING, FAR, NOTHING, FAR);
#if SPHERES > 0
  judge_spheres(p, v, verdict);
#endif
#if ROUNDS > 0
  judge_rounds(p, v, verdict);
#endif
#if PLANES > 0
  judge_planes(p, v, verdict);
#endif
#if DISCS > 0
  judge_discs(p, v, verdict);
#endif
#if TRIANGLES > 0
  judge_triangles(p, v, verdict);
#endif
  return verdict;
}

// The direction of a pixel is the sum of three terms, each rounded twice, and of two sums.
Balls ball_of_pixel(vec2 off) {
  vec3 x = off.x * step_x, y = off.y * step_y;
  return Balls(forward + x + y, 3.0 * U * (abs(forward) + abs(x) + abs(y)));
}
)glsl"
