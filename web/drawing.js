import { product } from "./vectors.js";

// The picture: surfaces as triangles, lines some pixels wide, and dots, by WebGL 2.
const surface_vertex = `#version 300 es
uniform mat4 view, lens;
in vec3 position, normal;
out vec3 at, up, place;
void main() { vec4 p = view * vec4(position, 1); at = p.xyz; place = position; up = mat3(view) * normal; gl_Position = lens * p; }`;
const surface_fragment = `#version 300 es
precision highp float;
uniform vec3 colour, light, middle;
uniform float glow, alpha, fades;
in vec3 at, up, place;
out vec4 seen;
void main() {
  vec3 n = normalize(up), l = normalize(light), e = normalize(-at);
  if (dot(n, e) < 0.0) n = -n;
  float d = max(dot(n, l), 0.0), s = pow(max(dot(n, normalize(l + e)), 0.0), 40.0), edge = pow(1.0 - max(dot(n, e), 0.0), 3.0);
  vec3 c = colour * (0.38 + 0.2 * n.y * 0.5 + 0.55 * d) + vec3(0.16 * s) + glow * (vec3(0.16, 0.1, 0.02) + vec3(0.9, 0.55, 0.1) * edge);
  float far = fades > 0.0 ? 1.0 - smoothstep(0.3, 1.0, distance(place, middle) / fades) : 1.0;
  seen = vec4(c, alpha * far);
}`;
const line_vertex = `#version 300 es
uniform mat4 both;
uniform vec2 size;
uniform float wide;
in vec3 from, to;
in vec2 side;
in vec4 tint;
out vec4 ink;
out float along;
void main() {
  vec4 a = both * vec4(from, 1), b = both * vec4(to, 1);
  float near = 0.02;
  if (a.w < near && b.w < near) { gl_Position = vec4(2, 2, 2, 1); return; }
  if (a.w < near) a = mix(a, b, (near - a.w) / (b.w - a.w));
  if (b.w < near) b = mix(b, a, (near - b.w) / (a.w - b.w));
  vec2 p = a.xy / a.w * size, q = b.xy / b.w * size, d = q - p;
  float length_ = length(d);
  d = length_ > 0.0 ? d / length_ : vec2(1, 0);
  vec4 c = side.x < 0.5 ? a : b;
  vec2 off = vec2(-d.y, d.x) * side.y * wide;
  gl_Position = vec4(c.xy + off / size * c.w, c.zw);
  along = (side.x < 0.5 ? 0.0 : length_) * 0.5;
  ink = tint;
}`;
const line_fragment = `#version 300 es
precision highp float;
uniform float faint, dashes;
in vec4 ink;
in float along;
out vec4 seen;
void main() {
  if (dashes > 0.0 && fract(along / dashes) > 0.55) discard;
  seen = vec4(ink.rgb, ink.a * faint);
}`;
const dot_vertex = `#version 300 es
uniform mat4 both;
in vec3 place;
in vec4 tint;
in float big;
out vec4 ink;
out float hollow;
void main() { gl_Position = both * vec4(place, 1); gl_PointSize = abs(big); ink = tint; hollow = big < 0.0 ? 1.0 : 0.0; }`;
const dot_fragment = `#version 300 es
precision highp float;
uniform float faint;
in vec4 ink;
in float hollow;
out vec4 seen;
void main() {
  float r = 2.0 * length(gl_PointCoord - 0.5);
  if (r > 1.0 || (hollow > 0.5 && r < 0.55)) discard;
  seen = vec4(ink.rgb, ink.a * faint * (1.0 - smoothstep(0.85, 1.0, r)));
}`;

function compiled(gl, type, text) {
  const shader = gl.createShader(type);
  gl.shaderSource(shader, text);
  gl.compileShader(shader);
  if (!gl.getShaderParameter(shader, gl.COMPILE_STATUS)) throw new Error(gl.getShaderInfoLog(shader));
  return shader;
}

// program links two shaders; its attributes and uniforms are found by name.
export function program(gl, vertex, fragment) {
  const made = gl.createProgram();
  gl.attachShader(made, compiled(gl, gl.VERTEX_SHADER, vertex));
  gl.attachShader(made, compiled(gl, gl.FRAGMENT_SHADER, fragment));
  gl.linkProgram(made);
  if (!gl.getProgramParameter(made, gl.LINK_STATUS)) throw new Error(gl.getProgramInfoLog(made));
  const places = new Map();
  return {
    made,
    uniform: name => {
      if (!places.has(name)) places.set(name, gl.getUniformLocation(made, name));
      return places.get(name);
    },
    attribute: name => gl.getAttribLocation(made, name),
  };
}

function attribute(gl, place, width, stride, offset) {
  if (place < 0) return;
  gl.enableVertexAttribArray(place);
  gl.vertexAttribPointer(place, width, gl.FLOAT, false, stride * 4, offset * 4);
}

export function make_drawing(canvas) {
  const gl = canvas.getContext("webgl2", {
    antialias: true,
    alpha: true,
    premultipliedAlpha: false,
    preserveDrawingBuffer: true,
  });
  if (!gl) return null;
  const surfaces = program(gl, surface_vertex, surface_fragment),
    lines = program(gl, line_vertex, line_fragment);
  const dots = program(gl, dot_vertex, dot_fragment);
  let models = [];

  // set_meshes hands the triangles over; they stay until the scene changes.
  function set_meshes(meshes) {
    for (const { array, buffers } of models) {
      gl.deleteVertexArray(array);
      buffers.forEach(buffer => gl.deleteBuffer(buffer));
    }
    models = meshes.map(mesh => {
      const array = gl.createVertexArray(),
        buffers = [gl.createBuffer(), gl.createBuffer(), gl.createBuffer()];
      gl.bindVertexArray(array);
      [
        ["position", mesh.positions],
        ["normal", mesh.normals],
      ].forEach(([name, values], i) => {
        gl.bindBuffer(gl.ARRAY_BUFFER, buffers[i]);
        gl.bufferData(gl.ARRAY_BUFFER, new Float32Array(values), gl.STATIC_DRAW);
        attribute(gl, surfaces.attribute(name), 3, 0, 0);
      });
      gl.bindBuffer(gl.ELEMENT_ARRAY_BUFFER, buffers[2]);
      gl.bufferData(gl.ELEMENT_ARRAY_BUFFER, new Uint32Array(mesh.indices), gl.STATIC_DRAW);
      gl.bindVertexArray(null);
      return { ...mesh, array, buffers, count: mesh.indices.length };
    });
  }

  const looks = { colour: [0.8, 0.8, 0.8], alpha: 1, glow: 0 };
  function draw_surfaces(view, lens, ball, look_of) {
    gl.useProgram(surfaces.made);
    gl.uniformMatrix4fv(surfaces.uniform("view"), false, view);
    gl.uniformMatrix4fv(surfaces.uniform("lens"), false, lens);
    gl.uniform3f(surfaces.uniform("light"), 0.4, 0.8, 0.7);
    gl.uniform3fv(surfaces.uniform("middle"), ball.middle);
    for (const clear of [false, true]) {
      gl.depthMask(!clear);
      for (const model of models) {
        const look = { ...looks, colour: model.colour, ...look_of(model) };
        if (look.alpha < 1 !== clear || look.alpha === 0) continue;
        gl.uniform3fv(surfaces.uniform("colour"), look.colour);
        gl.uniform1f(surfaces.uniform("alpha"), look.alpha);
        gl.uniform1f(surfaces.uniform("glow"), look.glow);
        gl.uniform1f(surfaces.uniform("fades"), model.tipo === "plano" ? 4.5 * ball.radius : 0);
        gl.bindVertexArray(model.array);
        gl.drawElements(gl.TRIANGLES, model.count, gl.UNSIGNED_INT, 0);
      }
    }
    gl.depthMask(true);
  }

  const line_buffer = gl.createBuffer(),
    line_array = gl.createVertexArray();
  gl.bindVertexArray(line_array);
  gl.bindBuffer(gl.ARRAY_BUFFER, line_buffer);
  attribute(gl, lines.attribute("from"), 3, 12, 0);
  attribute(gl, lines.attribute("to"), 3, 12, 3);
  attribute(gl, lines.attribute("side"), 2, 12, 6);
  attribute(gl, lines.attribute("tint"), 4, 12, 8);
  const dot_buffer = gl.createBuffer(),
    dot_array = gl.createVertexArray();
  gl.bindVertexArray(dot_array);
  gl.bindBuffer(gl.ARRAY_BUFFER, dot_buffer);
  attribute(gl, dots.attribute("place"), 3, 8, 0);
  attribute(gl, dots.attribute("tint"), 4, 8, 3);
  attribute(gl, dots.attribute("big"), 1, 8, 7);
  gl.bindVertexArray(null);

  const corners = [
    [0, -1],
    [0, 1],
    [1, -1],
    [1, -1],
    [0, 1],
    [1, 1],
  ];
  function draw_lines(list, both, size, faint) {
    gl.useProgram(lines.made);
    gl.bindVertexArray(line_array);
    gl.bindBuffer(gl.ARRAY_BUFFER, line_buffer);
    gl.uniformMatrix4fv(lines.uniform("both"), false, both);
    gl.uniform2f(lines.uniform("size"), size[0], size[1]);
    gl.uniform1f(lines.uniform("faint"), faint);
    const groups = new Map();
    for (const line of list) {
      const key = `${line.wide ?? 2}/${line.dashes ?? 0}`;
      if (!groups.has(key)) groups.set(key, []);
      groups.get(key).push(line);
    }
    for (const [key, members] of groups) {
      const [wide, dashes] = key.split("/").map(Number);
      const values = members.flatMap(({ from, to, tint }) =>
        corners.flatMap(corner => [...from, ...to, ...corner, ...tint]),
      );
      gl.bufferData(gl.ARRAY_BUFFER, new Float32Array(values), gl.STREAM_DRAW);
      gl.uniform1f(lines.uniform("wide"), wide);
      gl.uniform1f(lines.uniform("dashes"), dashes);
      gl.drawArrays(gl.TRIANGLES, 0, members.length * 6);
    }
  }
  function draw_dots(list, both, faint, scale) {
    if (!list.length) return;
    gl.useProgram(dots.made);
    gl.bindVertexArray(dot_array);
    gl.bindBuffer(gl.ARRAY_BUFFER, dot_buffer);
    gl.uniformMatrix4fv(dots.uniform("both"), false, both);
    gl.uniform1f(dots.uniform("faint"), faint);
    gl.bufferData(
      gl.ARRAY_BUFFER,
      new Float32Array(list.flatMap(d => [...d.place, ...d.tint, d.big * scale])),
      gl.STREAM_DRAW,
    );
    gl.drawArrays(gl.POINTS, 0, list.length);
  }

  // draw shows all: what a surface hides of the lines and dots is faint.
  function draw({ view, lens, ball, look_of, line_list, dot_list }) {
    const scale = Math.min(2, globalThis.devicePixelRatio || 1);
    const width = Math.max(1, Math.round(canvas.clientWidth * scale)),
      height = Math.max(1, Math.round(canvas.clientHeight * scale));
    if (canvas.width !== width || canvas.height !== height) {
      canvas.width = width;
      canvas.height = height;
    }
    const both = product(lens, view),
      size = [width, height];
    gl.viewport(0, 0, width, height);
    gl.clearColor(0, 0, 0, 0);
    gl.clear(gl.COLOR_BUFFER_BIT | gl.DEPTH_BUFFER_BIT);
    gl.enable(gl.DEPTH_TEST);
    gl.enable(gl.BLEND);
    gl.blendFuncSeparate(gl.SRC_ALPHA, gl.ONE_MINUS_SRC_ALPHA, gl.ONE, gl.ONE_MINUS_SRC_ALPHA);
    draw_surfaces(view, lens, ball, look_of);
    const thick = line_list.map(line => ({
      ...line,
      wide: (line.wide ?? 2) * scale,
      dashes: (line.dashes ?? 0) * scale,
    }));
    gl.disable(gl.DEPTH_TEST);
    draw_lines(thick, both, size, 0.28);
    draw_dots(dot_list, both, 0.4, scale);
    gl.enable(gl.DEPTH_TEST);
    gl.depthFunc(gl.LEQUAL);
    gl.depthMask(false);
    draw_lines(thick, both, size, 1);
    draw_dots(dot_list, both, 1, scale);
    gl.depthMask(true);
    gl.bindVertexArray(null);
  }
  return { gl, draw, set_meshes };
}
