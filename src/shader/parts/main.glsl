R"glsl(
// The output. `off` is the way of the pixel's centre from that of the picture, in pixels, to the right and up.
void main() {
  vec2 off = gl_FragCoord.xy - 0.5 * size;
#if WRITES != COLOR_ONLY
  Verdict verdict = verdict_of(given(eye), ball_of_pixel(off));
#endif
#if WRITES == ANSWER
  answer = uvec4(verdict.element + 1, is_doubtful(verdict) ? 1u : 0u, 0u, 1u);
#else
  vec3 seen = shown(brought(eye, normalize(forward + off.x * step_x + off.y * step_y)));
#if WRITES == DOUBTS
  if (is_doubtful(verdict)) seen = vec3(1.0, 0.0, 0.8);
#endif
  color = vec4(seen, 1.0);
#endif
}
)glsl"
