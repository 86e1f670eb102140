// Shows one mesh at a time in 3D with WebGL, after a click. reports/pictures/turnable.h describes the format of the meshes.

const viridis = [[0.267, 0.005, 0.329], [0.229, 0.322, 0.546], [0.128, 0.567, 0.551], [0.369, 0.789, 0.383], [0.993, 0.906, 0.144]];

function readMesh(text) {
  const bytes = Uint8Array.from(atob(text), (letter) => letter.charCodeAt(0));
  const numbers = new DataView(bytes.buffer);
  const vertices = numbers.getUint32(0, true);
  const triangles = numbers.getUint32(4, true);
  const low = [8, 12, 16].map((at) => numbers.getFloat32(at, true));
  const side = numbers.getFloat32(20, true);
  const place = new Float32Array(3 * vertices);
  for (let n = 0; n < place.length; ++n) place[n] = low[n % 3] + side * numbers.getUint16(24 + 2 * n, true) / 65535;
  let at = 24 + 2 * place.length;
  let unused = 0;
  const corner = () => {
    let back = 0;
    for (let shift = 0; ; shift += 7) {
      back |= (bytes[at] & 127) << shift;
      if (bytes[at++] < 128) return back === 0 ? unused++ : unused - back;
    }
  };
  const corners = Uint32Array.from({ length: 3 * triangles }, corner);
  return { place, corners, values: bytes.subarray(at), low, side };
}

// Eight numbers for each corner of each triangle: its place, the normal of the triangle, its value and the number of the corner.
function cornersOf(mesh) {
  const data = new Float32Array(8 * mesh.corners.length);
  for (let t = 0; t < mesh.corners.length; t += 3) {
    const [a, b, c] = [0, 1, 2].map((i) => mesh.place.subarray(3 * mesh.corners[t + i], 3 * mesh.corners[t + i] + 3));
    const u = [b[0] - a[0], b[1] - a[1], b[2] - a[2]];
    const v = [c[0] - a[0], c[1] - a[1], c[2] - a[2]];
    const normal = [u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]];
    [a, b, c].forEach((p, i) => data.set([...p, ...normal, mesh.values[t / 3] / 255, i], 8 * (t + i)));
  }
  return data;
}

const vertexShader = `#version 300 es
in vec3 place; in vec3 normal; in float value; in float corner;
uniform mat3 turn; uniform vec3 focus; uniform vec2 scale; uniform vec2 shift; uniform float depth;
out vec3 facing; out float shown; out vec3 within;
void main() {
  vec3 seen = turn * (place - focus);
  facing = turn * normal;
  shown = value;
  within = vec3(corner == 0.0, corner == 1.0, corner == 2.0);
  gl_Position = vec4(seen.xy * scale + shift, -seen.z * depth, 1.0);
}`;

const fragmentShader = `#version 300 es
precision highp float;
in vec3 facing; in float shown; in vec3 within;
uniform vec3 colours[5]; uniform float edges;
out vec4 colour;
void main() {
  float step = clamp(shown, 0.0, 1.0) * 4.0;
  int low = min(int(step), 3);
  vec3 own = mix(colours[low], colours[low + 1], step - float(low));
  float light = 0.35 + 0.65 * abs(normalize(facing).z);
  vec3 width = fwidth(within);
  vec3 inside = smoothstep(vec3(0.0), width * 1.2, within);
  float line = edges * (1.0 - min(inside.x, min(inside.y, inside.z)));
  colour = vec4(mix(own * light, vec3(0.1), 0.85 * line), 1.0);
}`;

function programOf(gl) {
  const program = gl.createProgram();
  for (const [kind, source] of [[gl.VERTEX_SHADER, vertexShader], [gl.FRAGMENT_SHADER, fragmentShader]]) {
    const shader = gl.createShader(kind);
    gl.shaderSource(shader, source);
    gl.compileShader(shader);
    gl.attachShader(program, shader);
  }
  gl.linkProgram(program);
  if (!gl.getProgramParameter(program, gl.LINK_STATUS)) throw new Error(gl.getProgramInfoLog(program));
  return program;
}

// The rows of a rotation matrix. The third points to the eye, which is at a corner in front, as in the pictures.
function fromACorner() {
  const back = [0.6, -0.7, 0.4].map((x) => x / Math.hypot(0.6, 0.7, 0.4));
  const length = Math.hypot(back[0], back[1]);
  const right = [-back[1] / length, back[0] / length, 0];
  const up = [back[1] * right[2] - back[2] * right[1], back[2] * right[0] - back[0] * right[2], back[0] * right[1] - back[1] * right[0]];
  return [right, up, back];
}

// The rotation turned further, about the vertical and the horizontal axis of the screen.
function turned(rows, aside, upwards) {
  const mixed = (p, q, angle) => [
    p.map((x, i) => Math.cos(angle) * x + Math.sin(angle) * q[i]),
    q.map((x, i) => Math.cos(angle) * x - Math.sin(angle) * p[i]),
  ];
  let [right, up, back] = rows;
  [right, back] = mixed(right, back, aside);
  [up, back] = mixed(up, back, -upwards);
  return [right, up, back];
}

class Turntable {
  constructor(canvas) {
    this.canvas = canvas;
    this.gl = canvas.getContext("webgl2", { antialias: true });
    if (this.gl === null) throw new Error("this browser has no WebGL 2");
    this.program = programOf(this.gl);
    this.buffer = this.gl.createBuffer();
    this.reset();
    this.listen();
  }

  reset() {
    this.rows = fromACorner();
    this.zoom = 1;
    this.shift = [0, 0];
  }

  show(mesh, edges) {
    const { gl } = this;
    this.count = mesh.corners.length;
    this.low = mesh.low;
    this.side = mesh.side;
    this.edges = edges;
    this.focus = [0, 1, 2].map((axis) => {
      let most = -Infinity;
      for (let n = axis; n < mesh.place.length; n += 3) most = Math.max(most, mesh.place[n]);
      return 0.5 * (mesh.low[axis] + most);
    });
    gl.bindBuffer(gl.ARRAY_BUFFER, this.buffer);
    gl.bufferData(gl.ARRAY_BUFFER, cornersOf(mesh), gl.STATIC_DRAW);
    let offset = 0;
    for (const [name, size] of [["place", 3], ["normal", 3], ["value", 1], ["corner", 1]]) {
      const at = gl.getAttribLocation(this.program, name);
      gl.enableVertexAttribArray(at);
      gl.vertexAttribPointer(at, size, gl.FLOAT, false, 32, offset);
      offset += 4 * size;
    }
    this.draw();
  }

  draw() {
    const { gl, canvas } = this;
    const ratio = window.devicePixelRatio || 1;
    canvas.width = Math.round(canvas.clientWidth * ratio);
    canvas.height = Math.round(canvas.clientHeight * ratio);
    gl.viewport(0, 0, canvas.width, canvas.height);
    gl.clearColor(1, 1, 1, 1);
    gl.clear(gl.COLOR_BUFFER_BIT | gl.DEPTH_BUFFER_BIT);
    gl.enable(gl.DEPTH_TEST);
    gl.useProgram(this.program);
    const place = (name) => gl.getUniformLocation(this.program, name);
    const scale = 1.5 * this.zoom / this.side;
    const columns = [0, 1, 2].flatMap((column) => this.rows.map((row) => row[column]));
    gl.uniformMatrix3fv(place("turn"), false, columns);
    gl.uniform3fv(place("focus"), this.focus);
    gl.uniform2f(place("scale"), scale * canvas.height / canvas.width, scale);
    gl.uniform2fv(place("shift"), this.shift);
    gl.uniform1f(place("depth"), 0.5 / this.side);
    gl.uniform3fv(place("colours"), viridis.flat());
    gl.uniform1f(place("edges"), this.edges ? 1 : 0);
    gl.drawArrays(gl.TRIANGLES, 0, this.count);
  }

  move(event) {
    const x = event.movementX / this.canvas.clientHeight;
    const y = event.movementY / this.canvas.clientHeight;
    if (event.shiftKey || event.buttons === 2) {
      this.shift = [this.shift[0] + 2 * x * this.canvas.clientHeight / this.canvas.clientWidth, this.shift[1] - 2 * y];
    } else {
      this.rows = turned(this.rows, -4 * x, -4 * y);
    }
    this.draw();
  }

  key(event) {
    const steps = { ArrowLeft: [0.1, 0], ArrowRight: [-0.1, 0], ArrowUp: [0, 0.1], ArrowDown: [0, -0.1] };
    if (steps[event.key]) this.rows = turned(this.rows, ...steps[event.key]);
    else if (event.key === "+" || event.key === "=") this.zoom *= 1.25;
    else if (event.key === "-") this.zoom /= 1.25;
    else if (event.key === "e") this.edges = !this.edges;
    else if (event.key === "0" || event.key === "Home") this.reset();
    else return;
    event.preventDefault();
    this.draw();
  }

  listen() {
    const { canvas } = this;
    canvas.addEventListener("pointerdown", (event) => canvas.setPointerCapture(event.pointerId));
    canvas.addEventListener("pointermove", (event) => { if (event.buttons !== 0) this.move(event); });
    canvas.addEventListener("contextmenu", (event) => event.preventDefault());
    canvas.addEventListener("dblclick", () => { this.reset(); this.draw(); });
    canvas.addEventListener("keydown", (event) => this.key(event));
    canvas.addEventListener("wheel", (event) => {
      event.preventDefault();
      this.zoom *= Math.exp(-0.001 * event.deltaY);
      this.draw();
    }, { passive: false });
    window.addEventListener("resize", () => this.draw());
  }
}

// The place under the table where a mesh is shown. It is made at the first click.
let stage = null;

function makeStage(table) {
  const box = document.createElement("figure");
  box.className = "stage";
  const canvas = document.createElement("canvas");
  canvas.tabIndex = 0;
  const caption = document.createElement("figcaption");
  box.append(canvas, caption);
  table.closest(".wide").after(box);
  return { canvas, caption, turntable: new Turntable(canvas) };
}

function showMesh(cell, kind, button) {
  const table = cell.closest("table");
  try {
    stage ??= makeStage(table);
  } catch (problem) {
    table.closest(".wide").after(`No mesh can be shown in 3D: ${problem.message}.`);
    for (const other of table.querySelectorAll("button")) other.remove();
    return;
  }
  for (const other of table.querySelectorAll("button")) other.setAttribute("aria-pressed", String(other === button));
  const mesh = readMesh(document.getElementById(cell.dataset[kind]).textContent);
  const all = Number(cell.dataset.triangles);
  const whole = mesh.corners.length === 3 * all;
  const name = `${cell.parentElement.cells[0].textContent}, ${table.tHead.rows[0].cells[cell.cellIndex].textContent}`;
  const number = (mesh.corners.length / 3).toLocaleString("en");
  const what = kind === "worst" ? `the ${number} triangles around the worst one.`
    : whole ? `${number} triangles.`
    : `a simplified copy with ${number} triangles of a mesh with ${all.toLocaleString("en")}. Each triangle has the colour of the worst triangle that it replaces.`;
  if (kind === "worst") stage.turntable.reset();
  stage.turntable.show(mesh, whole || kind === "worst");
  stage.canvas.setAttribute("aria-label", name);
  stage.caption.innerHTML = '<span class="scale">radius ratio 0 <i></i> 1</span> <b></b> <span></span> Turn: drag, ' +
    "or arrow keys. Zoom: wheel, or + and −. Move: shift and drag. Show or hide edges: e. First view: double click, or 0.";
  stage.caption.querySelector("b").textContent = `${name}:`;
  stage.caption.querySelector("b + span").textContent = what;
  stage.canvas.focus({ preventScroll: true });
}

for (const cell of document.querySelectorAll("table.turn td[data-whole]")) {
  for (const [kind, label] of [["whole", "Show in 3D"], ["worst", "Worst triangle"]]) {
    if (cell.dataset[kind] === undefined) continue;
    const button = document.createElement("button");
    button.type = "button";
    button.textContent = label;
    button.addEventListener("click", () => showMesh(cell, kind, button));
    cell.append(" ", button);
  }
}
for (const remark of document.querySelectorAll(".unscripted")) remark.remove();
