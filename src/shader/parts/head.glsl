R"glsl(precision highp float;
precision highp int;

// The camera, as the size of the picture makes it.
uniform vec3 eye, forward, step_x, step_y;
uniform vec2 size;

#if WRITES == ANSWER
layout(location = 0) out highp uvec4 answer;
#else
layout(location = 0) out vec4 color;
#endif

const float FAR = 1e30;
const int NOTHING = -1;
)glsl"
