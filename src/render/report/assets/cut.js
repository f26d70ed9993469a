// The faces that a coordinate plane cuts into the bodies, with the fields on them.

// Corners at the ends of the twelve edges of a hexahedron.
const EDGES = [0, 1, 1, 2, 2, 3, 3, 0, 4, 5, 5, 6, 6, 7, 7, 4, 0, 4, 1, 5, 2, 6, 3, 7];

// The cut where coordinate `axis` is `at`: points, and for each body its triangles, the lines of the
// mesh in the plane, and the edges of the body there.
function cutModel(model, axis, at) {
  const { data, faces, elements } = model;
  const points = [];
  const bodies = model.bodies.map((body) => {
    const triangles = [];
    const lines = [];
    for (let e = body.elements[0]; e < body.elements[1]; e++) {
      const ring = ringOf(data, elements, 8 * e, axis, at);
      if (!ring) continue;
      const first = points.length / STRIDE;
      for (const point of ring) points.push(...point);
      for (let k = 0; k < ring.length; k++) {
        if (k > 1) triangles.push(first, first + k - 1, first + k);
        lines.push(first + k, first + ((k + 1) % ring.length));
      }
    }
    const edges = [];
    for (let f = body.faces[0]; f < body.faces[1]; f++) {
      const ends = crossings(data, faces, 4 * f, [0, 1, 1, 2, 2, 3, 3, 0], axis, at);
      if (ends.length < 2) continue;
      const first = points.length / STRIDE;
      points.push(...ends[0], ...ends[1]);
      edges.push(first, first + 1);
    }
    return {
      triangles: Uint32Array.from(triangles),
      mesh: Uint32Array.from(lines),
      edges: Uint32Array.from(edges),
    };
  });
  return { data: Float32Array.from(points), bodies };
}

// The corners of the cut through one element in their order around it.
function ringOf(data, elements, start, axis, at) {
  let below = 0;
  for (let k = 0; k < 8; k++) if (data[elements[start + k] * STRIDE + axis] < at) below++;
  if (below === 0 || below === 8) return null;
  const ring = crossings(data, elements, start, EDGES, axis, at);
  if (ring.length < 3) return null;
  const [u, v] = [(axis + 1) % 3, (axis + 2) % 3];
  const middle = [u, v].map((k) => ring.reduce((sum, p) => sum + p[k], 0) / ring.length);
  const angle = (p) => Math.atan2(p[v] - middle[1], p[u] - middle[0]);
  return ring.sort((p, q) => angle(p) - angle(q));
}

// Where the edges of one face or element meet the plane, with all that points carry.
function crossings(data, corners, start, edges, axis, at) {
  const found = [];
  for (let k = 0; k < edges.length; k += 2) {
    const a = corners[start + edges[k]] * STRIDE;
    const b = corners[start + edges[k + 1]] * STRIDE;
    const from = data[a + axis] - at;
    const to = data[b + axis] - at;
    if ((from < 0) === (to < 0)) continue;
    const share = from / (from - to);
    const point = new Array(STRIDE);
    for (let i = 0; i < STRIDE; i++) point[i] = data[a + i] + share * (data[b + i] - data[a + i]);
    found.push(point);
  }
  return found;
}
