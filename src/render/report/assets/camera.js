// A camera without perspective that turns about an upright axis, as engineers draw.

class Camera {
  // `up` is the upright axis; the others follow it in their cyclic order.
  constructor(up) {
    this.axes = [(up + 1) % 3, (up + 2) % 3, up];
    this.turn = -2.2;
    this.tilt = 0.45;
    this.target = [0, 0, 0];
    // Length that the height of the picture shows.
    this.height = 1;
  }

  // To the right, upwards, and towards the eye.
  frame() {
    const [c, s] = [Math.cos(this.turn), Math.sin(this.turn)];
    const [ct, st] = [Math.cos(this.tilt), Math.sin(this.tilt)];
    const place = (a, b, u) => {
      const v = [0, 0, 0];
      [a, b, u].forEach((value, k) => (v[this.axes[k]] = value));
      return v;
    };
    return [place(-s, c, 0), place(-st * c, -st * s, ct), place(ct * c, ct * s, st)];
  }

  // Column-major matrix from space to the picture, `depth` being the reach of what is seen.
  matrix(aspect, depth) {
    const [right, up, eye] = this.frame();
    const scale = 2 / this.height;
    const rows = [
      right.map((x) => (x * scale) / aspect),
      up.map((x) => x * scale),
      eye.map((x) => -x / depth),
    ];
    const matrix = new Float32Array(16);
    rows.forEach((row, r) => {
      row.forEach((x, c) => (matrix[4 * c + r] = x));
      matrix[12 + r] = -dot(row, this.target);
    });
    matrix[15] = 1;
    return matrix;
  }

  rotate(dx, dy) {
    this.turn -= dx;
    this.tilt = Math.max(-1.57, Math.min(1.57, this.tilt + dy));
  }

  // Moves what is seen by shares of the height of the picture.
  pan(dx, dy) {
    const [right, up] = this.frame();
    for (let k = 0; k < 3; k++) {
      this.target[k] -= this.height * (dx * right[k] - dy * up[k]);
    }
  }

  // Zooms about the place (dx, dy) from the middle of the picture, in shares of its height.
  zoom(factor, dx, dy) {
    this.pan(dx, dy);
    this.height *= factor;
    this.pan(-dx, -dy);
  }
}
