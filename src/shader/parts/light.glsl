R"glsl(
// Whitted's algorithm: the local model at each meeting, and rays for mirrors and glass. Of two rays the one that counts for
// less is followed first, and the other waits: so few wait at once, however many follow. No index of their list depends on
// the pixel, which would be slow.

// What a surface sends of a light from the unit direction l towards a ray in the direction v, where facing is −n·v.
vec3 sent(Look look, vec3 n, vec3 v, float facing, vec3 l) {
  float cosine = max(0.0, dot(n, l));
  vec3 sum = look.color * (look.k_a + look.k_d * cosine);
#if HIGHLIGHTS
  float towards = dot(l, v) + 2.0 * cosine * facing;  // the mirror image of l, times v
  if (look.k_s > 0.0 && cosine > 0.0 && (towards > 0.0 || look.e == 0.0))
    sum += look.k_s * (look.e == 0.0 ? 1.0 : pow(max(towards, 0.0), look.e));
#endif
  return sum;
}

vec3 light_at(Look look, vec3 at, vec3 n, vec3 v, float facing, int start) {
  vec3 sum = vec3(0.0);
#if LAMPS > 0
  for (int i = 0; i < LAMPS; ++i) {
    vec3 to = LAMP_AT[i] - at;
    float far = length(to);
    if (far > 0.0 && !(first_meeting(at, to / far, start).t < far)) sum += LAMP_COLOR[i] * sent(look, n, v, facing, to / far);
  }
#endif
#if SUNS > 0
  for (int i = 0; i < SUNS; ++i)
    if (first_meeting(at, SUN_AT[i], start).element == NOTHING) sum += SUN_COLOR[i] * sent(look, n, v, facing, SUN_AT[i]);
#endif
  return sum;
}

#if GLASSES == 1
// The media that a ray is in are one glass: their number says how often the ray entered it. A ray that leaves the glass and
// never entered it was in it.
float crossed(inout uint media, bool enters, uint glass) {
  bool was_in = media > 0u;
  media += enters ? 1u : was_in ? uint(-1) : 0u;
  if (enters) return was_in ? 1.0 : 1.0 / INDEX[1];
  return media > 0u ? 1.0 : INDEX[1];
}
#elif GLASSES > 1
// The media that a ray is in, the innermost last: the number of a glass in each four bits, eight of them at most. A ray that
// leaves a glass and never entered it was in it.
float crossed(inout uint media, bool enters, uint glass) {
  float here = INDEX[media & 15u];
  if (enters) {
    media = (media << 4) | glass;
    return here / INDEX[glass];
  }
  bool was_in = false;
  for (int i = 0; i < 32; i += 4) {
    if (was_in || ((media >> i) & 15u) != glass) continue;
    was_in = true;
    media = (((media >> i) >> 4) << i) | (media & ((1u << i) - 1u));
  }
  return (was_in ? here : INDEX[glass]) / INDEX[media & 15u];
}
#endif

float most_of(vec3 x) { return max(x.x, max(x.y, x.z)); }

struct Path {
  vec3 p, v, weight;
  int start, depth;
  uint media;
};

// All pixels that a processor takes together go through all of this, so that there are few branches.
vec3 brought(vec3 p, vec3 v) {
  vec3 sum = vec3(0.0);
  Path path = Path(p, v, vec3(1.0), NOTHING, 1, 0u);
#if WAITING > 0
  Path waiting[WAITING];
  for (int i = 0; i < WAITING; ++i) waiting[i].weight = vec3(0.0);
#endif
  bool goes_on = true;
  while (goes_on) {
    Meeting meeting = first_meeting(path.p, path.v, path.start);
    bool meets = meeting.element != NOTHING;
    int element = max(meeting.element, 0);
    vec3 at = path.p + (meets ? meeting.t : 0.0) * path.v;
    vec3 outer = normal_of(element, at);
    float along = dot(outer, path.v), facing = abs(along);
    bool enters = !(along > 0.0);
    vec3 n = enters ? outer : -outer;
    int material = MATERIAL[element];
    Look look = look_of(material, element, at);
    vec3 here = look.emission + look.ambient + light_at(look, at, n, path.v, facing, element);
    sum += path.weight * (meets ? here : from_nowhere(path.v));
    goes_on = false;
#if DEPTH > 1
    vec3 weight = meets && path.depth < DEPTH ? path.weight : vec3(0.0);
    Path next = Path(at, path.v + 2.0 * facing * n, weight * look.k_ps * look.M_PS, element, path.depth + 1, path.media);
#if GLASSES > 0
    uint media = path.media;
    float ratio = crossed(media, enters, GLASS[material]);
    float squared = 1.0 - ratio * ratio * (1.0 - facing * facing);
    vec3 way = ratio == 1.0 ? path.v : (ratio * facing - sqrt(max(squared, 0.0))) * n + ratio * path.v;
    vec3 share = weight * look.k_t * look.M_T;
    if (squared < 0.0) next.weight += share, share = vec3(0.0);
    Path other = next;
    bool is_lighter = most_of(share) < most_of(next.weight);
    if (is_lighter) other.v = way, other.weight = share, other.media = media;
    else next.v = way, next.weight = share, next.media = media;
#if WAITING > 0
    bool waits = most_of(other.weight) > LEAST;
    for (int i = WAITING - 1; i > 0; --i)
      if (waits) waiting[i] = waiting[i - 1];
    if (waits) waiting[0] = next, next = other;
#endif
#endif
    path = next;
    goes_on = most_of(path.weight) > LEAST;
#if WAITING > 0
    if (!goes_on) path = waiting[0];
    for (int i = 1; i < WAITING; ++i)
      if (!goes_on) waiting[i - 1] = waiting[i];
    if (!goes_on) waiting[WAITING - 1].weight = vec3(0.0);
    goes_on = most_of(path.weight) > LEAST;
#endif
#endif
  }
  return sum;
}

// The curve of sRGB.
vec3 shown(vec3 color) {
  vec3 c = clamp(color, 0.0, 1.0);
  return mix(1.055 * pow(c, vec3(1.0 / 2.4)) - 0.055, 12.92 * c, lessThanEqual(c, vec3(0.0031308)));
}
)glsl"
