// Bodies in space that the reader turns: a parallel projection, with a depth for each pixel, so that what is nearer
// hides what lies behind it. Light and colours are those of the report's figures.

const LIGHT = [0.35, 0.75, 0.55].map((part) => part / Math.hypot(0.35, 0.75, 0.55)); // to the right, up, to the eye
const DARKEST = 0.62; // of its colour: a face turned away from the light
const TURN = 0.008; // rad for a CSS pixel
const FINER = 2; // pixels of the drawing for one of CSS, at least
const NUDGE = 0.004; // of the bodies' size: how much nearer an edge is taken than the face it belongs to
const BEHIND = 0.5; // opacity of a wire that begins behind a body
const LETTERS = 14; // height of names [CSS px]
const FILLED = 0.82; // of the window, which leaves room for names

const dot = (a, b) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
const minus = (a, b) => [a[0] - b[0], a[1] - b[1], a[2] - b[2]];
const cross = (a, b) => [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
const bytes = (colour) => [1, 3, 5].map((start) => parseInt(colour.slice(start, start + 2), 16));

function turnable(canvas, model) {
  const faces = facesOf(model);
  const edges = edgesOf(faces, Math.cos(model.sharp));
  const ends = [...model.vertices, ...model.wires.flatMap((wire) => wire.points)];
  const { centre, size } = extent(ends);
  let eye, zoomed, shift, waiting = false;

  // The unit vectors to the right, up and to the eye, from where the reader has turned it.
  function frame() {
    const [s, c, se, ce] = [Math.sin(eye[0]), Math.cos(eye[0]), Math.sin(eye[1]), Math.cos(eye[1])];
    return [[-s, c, 0], [-se * c, -se * s, ce], [ce * c, ce * s, se]];
  }
  function draw() {
    waiting = false;
    const fine = Math.max(FINER, devicePixelRatio);
    const [wide, high] = [canvas.clientWidth, canvas.clientHeight].map((side) => Math.max(1, Math.round(fine * side)));
    Object.assign(canvas, { width: wide, height: high });
    const axes = frame();
    const scale = (zoomed * FILLED * Math.min(wide, high)) / size;
    const seen = (point) => {
      const [right, up, near] = axes.map((axis) => dot(axis, minus(point, centre)));
      return [wide / 2 + fine * shift[0] + scale * right, high / 2 + fine * shift[1] - scale * up, near];
    };
    const pixels = new Pixels(wide, high);
    const corners = model.vertices.map(seen);
    const front = faces.map((face) => dot(face.normal, axes[2]) > 1e-3);
    faces.forEach((face, place) => {
      if (front[place]) pixels.fill(face.corners.map((corner) => corners[corner]), shade(face, axes));
    });
    for (const edge of edges) {
      const shown = edge.faces.filter((face) => front[face]).length;
      if (shown && (edge.sharp || shown < edge.faces.length)) {
        pixels.line(...edge.ends.map((end) => corners[end]), bytes(model.edge), NUDGE * size, Math.round(0.6 * fine));
      }
    }
    const pen = canvas.getContext("2d");
    pen.putImageData(pixels.image, 0, 0);
    const taken = []; // boxes of names
    for (const wire of model.wires) {
      const points = wire.points.map(seen);
      pen.globalAlpha = pixels.hides(points[0], NUDGE * size) ? BEHIND : 1;
      drawWire(pen, wire, points, fine, taken);
    }
    pen.globalAlpha = 1;
    drawTriad(pen, axes, high, fine);
  }
  function soon() {
    if (!waiting) requestAnimationFrame(draw);
    waiting = true;
  }
  // How much the bodies are enlarged where they fill the window, seen along these axes.
  function filling(axes) {
    const reach = (axis) => 2 * Math.max(...ends.map((point) => Math.abs(dot(axis, minus(point, centre)))));
    const [wide, high] = [canvas.clientWidth, canvas.clientHeight];
    return (Math.min(wide / reach(axes[0]), high / reach(axes[1])) * size) / Math.min(wide, high) || 1;
  }
  function drag(right, down, sideways) {
    if (sideways) shift = [shift[0] + right, shift[1] + down];
    else eye = [eye[0] - TURN * right, Math.max(-Math.PI / 2, Math.min(Math.PI / 2, eye[1] + TURN * down))];
    soon();
  }
  function zoom(factor, x, y) {
    const box = canvas.getBoundingClientRect();
    const next = Math.max(0.3, Math.min(40, zoomed * factor));
    const at = [x - box.left - box.width / 2, y - box.top - box.height / 2];
    shift = shift.map((part, place) => at[place] - (next / zoomed) * (at[place] - part));
    zoomed = next;
    soon();
  }
  function reset() {
    [eye, zoomed, shift] = [[...model.eye], 1, [0, 0]];
    zoomed = filling(frame());
    soon();
  }
  return { drag, zoom, reset };
}

function facesOf(model) {
  return model.parts.flatMap((part) => part.triangles.map((corners) => {
    const [a, b, c] = corners.map((corner) => model.vertices[corner]);
    const normal = cross(minus(b, a), minus(c, a));
    const length = Math.hypot(...normal) || 1;
    return { corners, normal: normal.map((along) => along / length), colour: bytes(part.colour) };
  }));
}

// Every edge once, with the faces that meet there; sharp where it is drawn from wherever it is seen.
function edgesOf(faces, cosine) {
  const found = new Map();
  faces.forEach((face, place) => face.corners.forEach((corner, side) => {
    const ends = [corner, face.corners[(side + 1) % 3]].sort((a, b) => a - b);
    const edge = found.get(ends.join()) ?? { ends, faces: [] };
    edge.faces.push(place);
    found.set(ends.join(), edge);
  }));
  for (const edge of found.values()) {
    const [one, other] = edge.faces.map((face) => faces[face].normal);
    edge.sharp = edge.faces.length !== 2 || dot(one, other) < cosine;
  }
  return [...found.values()];
}

function extent(points) {
  const low = [0, 1, 2].map((axis) => points.reduce((least, point) => Math.min(least, point[axis]), Infinity));
  const high = [0, 1, 2].map((axis) => points.reduce((most, point) => Math.max(most, point[axis]), -Infinity));
  return { centre: low.map((side, axis) => (side + high[axis]) / 2), size: Math.hypot(...minus(high, low)) || 1 };
}

function shade(face, axes) {
  const lit = axes.reduce((sum, axis, place) => sum + LIGHT[place] * dot(axis, face.normal), 0);
  const bright = DARKEST + (1 - DARKEST) * Math.max(0, lit);
  return face.colour.map((part) => Math.round(bright * part));
}

class Pixels {
  constructor(wide, high) {
    Object.assign(this, { wide, high, image: new ImageData(wide, high) });
    this.colours = new Uint32Array(this.image.data.buffer);
    this.depths = new Float32Array(wide * high).fill(-Infinity);
  }

  set(place, depth, colour) {
    if (depth < this.depths[place]) return;
    this.depths[place] = depth;
    this.colours[place] = colour;
  }

  // Whether a point lies behind what has been drawn.
  hides([right, down, near], nudge) {
    const [at, row] = [Math.round(right), Math.round(down)];
    const inside = at >= 0 && at < this.wide && row >= 0 && row < this.high;
    return inside && this.depths[row * this.wide + at] > near + nudge;
  }

  // A triangle, row by row; each corner is [right, down, towards the eye].
  fill(corners, colour) {
    const ink = word(colour);
    const [a, b, c] = [...corners].sort((one, other) => one[1] - other[1]);
    for (let row = Math.max(0, Math.ceil(a[1])); row <= Math.min(this.high - 1, c[1]); row++) {
      const [from, to] = [cut(a, c, row), row < b[1] ? cut(a, b, row) : cut(b, c, row)].sort((p, q) => p[0] - q[0]);
      const slope = (to[1] - from[1]) / (to[0] - from[0] || 1);
      const last = Math.min(this.wide - 1, to[0]);
      for (let at = Math.max(0, Math.ceil(from[0])); at <= last; at++) {
        this.set(row * this.wide + at, from[1] + slope * (at - from[0]), ink);
      }
    }
  }

  // A line, a little nearer than it is.
  line(start, end, colour, nudge, width) {
    const ink = word(colour);
    const steps = Math.ceil(Math.max(Math.abs(end[0] - start[0]), Math.abs(end[1] - start[1]))) || 1;
    for (let step = 0; step <= steps; step++) {
      const [right, down, near] = start.map((from, axis) => from + ((end[axis] - from) * step) / steps);
      for (let i = 0; i < width * width; i++) {
        const [at, row] = [Math.round(right) + (i % width), Math.round(down) + Math.floor(i / width)];
        if (at >= 0 && at < this.wide && row >= 0 && row < this.high) this.set(row * this.wide + at, near + nudge, ink);
      }
    }
  }
}

// Red, green and blue as one number, as the bytes of an image lie in memory.
function word([red, green, blue]) {
  return ((255 << 24) | (blue << 16) | (green << 8) | red) >>> 0;
}

// Where a side passes a row: [right, towards the eye].
function cut(one, other, row) {
  const share = (row - one[1]) / (other[1] - one[1] || 1);
  return [one[0] + share * (other[0] - one[0]), one[2] + share * (other[2] - one[2])];
}

// A line over the bodies, its name at its last end, and an arrow to there. taken : boxes of the names drawn before.
function drawWire(pen, wire, points, fine, taken = []) {
  const [end, before] = [points.at(-1), points.at(-2) ?? points[0]];
  const length = Math.hypot(end[0] - before[0], end[1] - before[1]) || 1;
  const way = [(end[0] - before[0]) / length, (end[1] - before[1]) / length];
  Object.assign(pen, { strokeStyle: wire.colour, fillStyle: wire.colour, lineWidth: 1.6 * fine });
  pen.setLineDash(wire.dashed ? [5 * fine, 3 * fine] : []);
  pen.beginPath();
  for (const [right, down] of points) pen.lineTo(right, down);
  pen.stroke();
  if (wire.arrow) {
    pen.beginPath();
    for (const [back, aside] of [[-4, 0], [7, 4], [7, -4]]) {
      pen.lineTo(end[0] - fine * (back * way[0] + aside * way[1]), end[1] - fine * (back * way[1] - aside * way[0]));
    }
    pen.fill();
  }
  if (wire.name) drawName(pen, wire.name, end, way, fine, taken);
}

// A name beyond the end of its line, on a white rim, within the window, lowered until it covers no other.
function drawName(pen, name, end, way, fine, taken) {
  const high = LETTERS * fine;
  Object.assign(pen, { font: `bold ${high}px sans-serif`, textAlign: "center", textBaseline: "middle" });
  const wide = pen.measureText(name).width;
  const within = (at, room) => Math.max(Math.min(at, room - 0.5 * wide), 0.5 * wide);
  const x = within(end[0] + (0.5 * wide + 0.4 * high) * way[0], pen.canvas.width);
  const box = { x, y: end[1] + 0.9 * high * way[1], wide, high };
  const covers = (other) => 2 * Math.abs(other.x - box.x) < other.wide + wide && Math.abs(other.y - box.y) < high;
  while (taken.some(covers)) box.y += 0.25 * high;
  taken.push(box);
  pen.setLineDash([]);
  Object.assign(pen, { strokeStyle: "#fff", lineWidth: 0.25 * high, lineJoin: "round" });
  pen.strokeText(name, box.x, box.y);
  pen.fillText(name, box.x, box.y);
}

// The axes of the project, in the lower left corner.
function drawTriad(pen, axes, high, fine) {
  const origin = [38 * fine, high - 38 * fine, 0];
  "xyz".split("").forEach((name, axis) => {
    const end = [origin[0] + 24 * fine * axes[0][axis], origin[1] - 24 * fine * axes[1][axis], 0];
    drawWire(pen, { name, colour: "#1b2733" }, [origin, end], fine / 1.2);
  });
}
