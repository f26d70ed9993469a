// The bodies as the renderer wants them: points with their fields, triangles, lines.

// Numbers a point: three coordinates, three displacements, three fields as shares of their range.
const STRIDE = 9;

function readModel(header, bytes) {
  const arrays = new Arrays(bytes);
  const count = header.points;
  const data = new Float32Array(count * STRIDE);
  const fill = (place, low, high) => {
    const steps = arrays.short(count);
    const scale = (high - low) / 65535;
    for (let i = 0; i < count; i++) data[i * STRIDE + place] = low + scale * steps[i];
  };
  for (let k = 0; k < 3; k++) fill(k, header.low[k], header.high[k]);
  for (let k = 0; k < 3; k++) fill(3 + k, -header.displacement, header.displacement);
  for (let k = 0; k < 3; k++) fill(6 + k, 0, 1);
  const faces = arrays.groups(header.faces, 4);
  const elements = arrays.groups(header.elements, 8);
  const bodies = header.bodies.map((body) => ({
    name: body.name,
    elements: body.elements,
    faces: body.faces,
    visible: true,
    triangles: trianglesOf(faces, body.faces),
    ...linesOf(data, faces, body.faces),
  }));
  return { header, data, faces, elements, bodies };
}

function trianglesOf(faces, [first, last]) {
  const triangles = new Uint32Array((last - first) * 6);
  for (let f = first, t = 0; f < last; f++) {
    const [a, b, c, d] = faces.subarray(4 * f, 4 * f + 4);
    for (const corner of [a, b, c, a, c, d]) triangles[t++] = corner;
  }
  return triangles;
}

// All edges of the faces, and those where the skin of the body turns by more than 30 degrees.
function linesOf(data, faces, [first, last]) {
  const seen = new Map();
  const count = data.length / STRIDE;
  const mesh = [];
  const edges = [];
  for (let f = first; f < last; f++) {
    const corners = faces.subarray(4 * f, 4 * f + 4);
    const normal = normalOf(data, corners);
    for (let k = 0; k < 4; k++) {
      const a = corners[k];
      const b = corners[(k + 1) % 4];
      const key = Math.min(a, b) * count + Math.max(a, b);
      const other = seen.get(key);
      if (other === undefined) {
        mesh.push(a, b);
        seen.set(key, { normal, a, b });
        continue;
      }
      if (dot(other.normal, normal) < Math.cos(Math.PI / 6)) edges.push(a, b);
      seen.delete(key);
    }
  }
  for (const { a, b } of seen.values()) edges.push(a, b);
  return { mesh: Uint32Array.from(mesh), edges: Uint32Array.from(edges) };
}

function normalOf(data, corners) {
  const [a, b, c, d] = Array.from(corners, (p) => data.subarray(p * STRIDE, p * STRIDE + 3));
  const u = [0, 1, 2].map((k) => c[k] - a[k]);
  const v = [0, 1, 2].map((k) => d[k] - b[k]);
  const n = cross(u, v);
  const length = Math.hypot(...n) || 1;
  return n.map((x) => x / length);
}

function dot(a, b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

function cross(a, b) {
  return [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
}
