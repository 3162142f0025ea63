// Draw the cloud with WebGL 2: the graphics card back-projects every pixel itself, so a slider
// moves a few numbers and no points.

import { MAX_SPLAT, SPLAT_GROWTH } from "./_splat.js";

const VERTEX = `#version 300 es
in float step;
in vec4 color;
uniform int columns;
uniform vec4 K; // fx, fy, cx, cy
uniform vec3 depth; // meters per step, least, most
uniform vec4 rows[3]; // from the camera frame to the eye
uniform vec3 view; // focal length in half widths, in half heights, in pixels
uniform vec2 size; // growth, most pixels
out vec3 shade;
void main() {
  float z = step * depth.x;
  shade = color.rgb;
  gl_Position = vec4(0.0, 0.0, 2.0, 1.0); // outside: not drawn
  gl_PointSize = 1.0;
  if (z <= depth.y || z >= depth.z) return;
  vec2 pixel = vec2(gl_VertexID % columns, gl_VertexID / columns);
  vec4 point = vec4((pixel - K.zw) / K.xy * z, z, 1.0);
  vec3 eye = vec3(dot(rows[0], point), dot(rows[1], point), dot(rows[2], point));
  const float near = 0.02, far = 100.0;
  float clip = ((far + near) * eye.z - 2.0 * far * near) / (far - near);
  gl_Position = vec4(view.x * eye.x, -view.y * eye.y, clip, eye.z);
  gl_PointSize = clamp(size.x * view.z * z / (K.y * eye.z), 1.0, size.y);
}`;

const FRAGMENT = `#version 300 es
precision mediump float;
in vec3 shade;
out vec4 color;
void main() { color = vec4(shade, 1.0); }`;

/**
 * Make what draws the cloud with WebGL 2; null where the browser has none.
 * @param {HTMLCanvasElement} canvas
 * @param {Cloud} cloud
 * @returns {CloudPainter | null}
 */
export function makeGlPainter(canvas, cloud) {
  const gl = canvas.getContext("webgl2", { antialias: false, premultipliedAlpha: false });
  if (!gl || gl.isContextLost()) return null;
  const program = linkProgram(gl);
  const places = Object.fromEntries(
    ["columns", "K", "depth", "rows", "view", "size"].map((name) => [
      name,
      gl.getUniformLocation(program, name),
    ]),
  );
  const count = cloud.steps.length;
  const array = gl.createVertexArray();
  gl.bindVertexArray(array);
  const stepBuffer = addAttribute(gl, program, "step", 1, gl.UNSIGNED_SHORT, false);
  gl.bufferData(gl.ARRAY_BUFFER, cloud.steps, gl.STATIC_DRAW);
  const colorBuffer = addAttribute(gl, program, "color", 4, gl.UNSIGNED_BYTE, true);
  gl.bufferData(gl.ARRAY_BUFFER, count * 4, gl.DYNAMIC_DRAW);
  gl.useProgram(program);
  gl.enable(gl.DEPTH_TEST);
  gl.clearColor(0, 0, 0, 0); // the page shows through
  gl.uniform1i(places.columns, cloud.width);
  const rows = new Float32Array(12);
  let drawn = -1;
  return {
    kind: "webgl2",
    resolution: Math.min(2, globalThis.devicePixelRatio || 1),
    draw(look, colors, version) {
      const { width, height, focal, K } = look;
      if (canvas.width !== width || canvas.height !== height) {
        [canvas.width, canvas.height] = [width, height];
        gl.viewport(0, 0, width, height);
      }
      if (version !== drawn) {
        gl.bindBuffer(gl.ARRAY_BUFFER, colorBuffer);
        gl.bufferSubData(gl.ARRAY_BUFFER, 0, colors);
        drawn = version;
      }
      rows.set(look.eyeFromCamera);
      gl.uniform4f(places.K, K[0][0], K[1][1], K[0][2], K[1][2]);
      gl.uniform3f(places.depth, cloud.depthStep, cloud.minDepth, look.far);
      gl.uniform4fv(places.rows, rows);
      gl.uniform3f(places.view, (2 * focal) / width, (2 * focal) / height, focal);
      gl.uniform2f(places.size, SPLAT_GROWTH, MAX_SPLAT * this.resolution);
      gl.clear(gl.COLOR_BUFFER_BIT | gl.DEPTH_BUFFER_BIT);
      gl.drawArrays(gl.POINTS, 0, count);
    },
    /** A browser holds only a few contexts: give this one back at once. */
    destroy() {
      gl.deleteVertexArray(array);
      gl.deleteBuffer(stepBuffer);
      gl.deleteBuffer(colorBuffer);
      gl.deleteProgram(program);
      gl.getExtension("WEBGL_lose_context")?.loseContext();
    },
  };
}

/** @param {WebGL2RenderingContext} gl */
function linkProgram(gl) {
  const program = gl.createProgram();
  const sources = new Map([
    [gl.VERTEX_SHADER, VERTEX],
    [gl.FRAGMENT_SHADER, FRAGMENT],
  ]);
  for (const [kind, text] of sources) {
    const shader = gl.createShader(kind);
    if (!shader) throw new Error("WebGL: the context is lost");
    gl.shaderSource(shader, text);
    gl.compileShader(shader);
    gl.attachShader(program, shader);
    gl.deleteShader(shader); // lives on in the program
  }
  gl.linkProgram(program);
  if (!gl.getProgramParameter(program, gl.LINK_STATUS)) {
    throw new Error(`WebGL: ${gl.getProgramInfoLog(program)}`);
  }
  return program;
}

/**
 * @param {WebGL2RenderingContext} gl
 * @param {WebGLProgram} program
 * @param {string} name
 * @param {number} size
 * @param {number} type
 * @param {boolean} normalized
 */
function addAttribute(gl, program, name, size, type, normalized) {
  const buffer = gl.createBuffer();
  const place = gl.getAttribLocation(program, name);
  gl.bindBuffer(gl.ARRAY_BUFFER, buffer);
  gl.enableVertexAttribArray(place);
  gl.vertexAttribPointer(place, size, type, normalized, 0, 0);
  return buffer;
}
