// The view in space: what its controls and the mouse do.

class View {
  constructor(root, model, colours) {
    this.root = root;
    this.model = model;
    this.canvas = root.querySelector("canvas");
    this.renderer = new Renderer(this.canvas, model, colours);
    const { low, high, mirrors } = model.header;
    this.size = Math.hypot(...high.map((h, k) => h - low[k]));
    this.camera = new Camera(model.header.up);
    this.state = {
      field: 0, stretch: 1, threshold: -1, exaggeration: 0, mesh: false, whole: false, cut: null,
    };
    this.makeControls();
    this.follow();
    this.reset();
    if (mirrors.length === 0) this.startCut();
    new ResizeObserver(() => this.changed()).observe(this.canvas);
  }

  get(name) {
    return this.root.querySelector(`[data-control="${name}"]`);
  }

  // Draws with the next frame, however often it is asked for.
  changed() {
    if (this.waiting) return;
    this.waiting = true;
    requestAnimationFrame(() => {
      this.waiting = false;
      const { clientWidth, clientHeight } = this.canvas;
      const pixels = window.devicePixelRatio || 1;
      const width = Math.max(1, Math.round(clientWidth * pixels));
      const height = Math.max(1, Math.round(clientHeight * pixels));
      if (this.canvas.width !== width || this.canvas.height !== height) {
        Object.assign(this.canvas, { width, height });
      }
      this.renderer.draw(this.camera, this.state);
      this.root.dataset.frames = Number(this.root.dataset.frames ?? 0) + 1;
    });
  }

  // What is seen now, as an address of a picture.
  still() {
    this.renderer.draw(this.camera, this.state);
    return this.canvas.toDataURL("image/png");
  }

  reset() {
    const { low, high, mirrors, up } = this.model.header;
    const whole = this.state.whole;
    const middle = low.map((l, k) => (whole && mirrors.includes(k) ? 0 : 0.5 * (l + high[k])));
    const [a, b] = this.camera.axes;
    const [wide, deep] = [high[a] - low[a], high[b] - low[b]];
    this.camera.target = middle;
    this.camera.tilt = 0.42;
    // Towards the planes of symmetry, or square to a thin slice.
    this.camera.turn = -2.25;
    if (deep < 0.2 * wide) this.camera.turn = -1.75;
    if (wide < 0.2 * deep) this.camera.turn = -3.3;
    if (Math.min(wide, deep) < 0.2 * Math.max(wide, deep)) this.camera.tilt = 0.2;
    const times = (axis) => (whole && mirrors.includes(axis) ? 2 : 1);
    const flat = Math.hypot(times(a) * wide, times(b) * deep);
    const seen = (high[up] - low[up]) * Math.cos(this.camera.tilt) + flat * Math.sin(this.camera.tilt);
    this.camera.height = 1.08 * Math.max(seen, 0.8 * flat, 1e-9);
    this.changed();
  }

  // A whole model shows its inside from the start.
  startCut() {
    const [first] = this.model.header.places;
    if (!first || this.model.header.elements === 0) return;
    const axis = this.camera.axes[1];
    this.get("cut").value = String(axis);
    this.setCut();
    this.get("at").value = String(this.shareOf(axis, first.at[axis]));
    this.get("turned").checked = true;
    this.setCut();
  }

  range(axis) {
    const { low, high, mirrors } = this.model.header;
    const start = this.state.whole && mirrors.includes(axis) ? -high[axis] : low[axis];
    return [start, high[axis]];
  }

  shareOf(axis, at) {
    const [low, high] = this.range(axis);
    return (at - low) / (high - low || 1);
  }

  setCut() {
    const axis = this.get("cut").value;
    this.renderer.forgetCuts();
    for (const name of ["at", "turned"]) this.get(name).disabled = axis === "";
    if (axis === "") {
      this.state.cut = null;
      this.get("at-value").textContent = "";
    } else {
      const [low, high] = this.range(Number(axis));
      // Off the very ends, where a plane would cut nothing.
      const share = Math.min(0.9999, Math.max(0.0001, Number(this.get("at").value)));
      const at = low + share * (high - low);
      const slack = 1e-6 * this.size;
      this.state.cut = { axis: Number(axis), at, turned: this.get("turned").checked, slack };
      this.get("at-value").textContent = `${digits(at, 3)} ${this.model.header.length}`;
    }
    this.changed();
  }

  setField() {
    this.state.field = Number(this.get("field").value);
    const field = this.model.header.fields[this.state.field];
    // Where a field is zero nearly everywhere the bare steel is grey.
    this.state.threshold = this.state.field === 0 ? -1 : 0.004;
    this.get("upper").value = digits(field.largest, 4);
    this.setRange();
  }

  setRange() {
    const field = this.model.header.fields[this.state.field];
    const upper = Number(this.get("upper").value);
    const top = upper > 0 ? upper : field.largest;
    this.state.stretch = field.largest > 0 && top > 0 ? field.largest / top : 1;
    const ticks = this.get("ticks");
    ticks.replaceChildren(...[1, 0.75, 0.5, 0.25, 0].map((share) => {
      const tick = document.createElement("span");
      const over = share === 1 && top < 0.9995 * field.largest ? "≥ " : "";
      tick.textContent = over + digits(share * top, 3);
      return tick;
    }));
    this.get("quantity").textContent = field.unit ? `${field.name}, ${field.unit}` : field.name;
    this.get("note").textContent = `${field.note}; largest ${digits(field.largest, 4)} ${field.unit}`;
    this.changed();
  }

  setExaggeration() {
    const { displacement } = this.model.header;
    const share = Number(this.get("deform").value);
    const most = displacement > 0 ? (0.2 * this.size) / displacement : 0;
    this.state.exaggeration = Number(digits(most * share ** 2, 2));
    this.get("deform-value").textContent =
      share === 0 ? "none" : `${this.state.exaggeration} ×`;
    this.changed();
  }

  lookAt() {
    const place = this.model.header.places[Number(this.get("look").value)];
    if (!place) return this.reset();
    this.camera.target = [...place.at];
    this.camera.height = place.size;
    this.changed();
  }

  turnTo(name) {
    const [turn, tilt] = {
      first: [0, 0], second: [-Math.PI / 2, 0], above: [-Math.PI / 2, 1.5707],
    }[name];
    Object.assign(this.camera, { turn, tilt });
    this.changed();
  }

  makeControls() {
    const { header, bodies } = this.model;
    const on = (name, kind, work) => this.get(name).addEventListener(kind, work);
    header.fields.forEach((field, k) => this.get("field").append(new Option(field.name, k)));
    this.get("look").append(new Option("the whole", "-1"));
    header.places.forEach((place, k) => this.get("look").append(new Option(place.name, k)));
    bodies.forEach((body) => this.get("bodies").append(this.bodyBox(body)));
    on("field", "change", () => this.setField());
    on("upper", "change", () => this.setRange());
    on("deform", "input", () => this.setExaggeration());
    on("cut", "change", () => this.setCut());
    on("at", "input", () => this.setCut());
    on("turned", "change", () => this.setCut());
    on("look", "change", () => this.lookAt());
    on("reset", "click", () => { this.get("look").value = "-1"; this.reset(); });
    for (const name of ["first", "second", "above"]) on(name, "click", () => this.turnTo(name));
    on("mesh", "change", (e) => { this.state.mesh = e.target.checked; this.changed(); });
    on("whole", "change", (e) => {
      this.state.whole = e.target.checked;
      this.setCut();
      this.reset();
    });
    this.get("whole").closest("label").hidden = header.mirrors.length === 0;
    this.get("cut").closest("fieldset").hidden = header.elements === 0;
    this.setField();
    this.setExaggeration();
    this.setCut();
  }

  bodyBox(body) {
    const label = document.createElement("label");
    const box = Object.assign(document.createElement("input"), { type: "checkbox", checked: true });
    box.addEventListener("change", () => { body.visible = box.checked; this.changed(); });
    label.append(box, ` ${body.name}`);
    return label;
  }

  // The mouse, fingers and keys.
  follow() {
    const { canvas, camera } = this;
    const held = new Map();
    const share = (e) => {
      const box = canvas.getBoundingClientRect();
      return [(e.clientX - box.left - box.width / 2) / box.height,
        (e.clientY - box.top - box.height / 2) / box.height];
    };
    canvas.addEventListener("pointerdown", (e) => {
      canvas.setPointerCapture(e.pointerId);
      held.set(e.pointerId, share(e));
    });
    const release = (e) => held.delete(e.pointerId);
    canvas.addEventListener("pointerup", release);
    canvas.addEventListener("pointercancel", release);
    canvas.addEventListener("pointermove", (e) => {
      const before = held.get(e.pointerId);
      if (!before) return this.tell(e);
      const now = share(e);
      const [dx, dy] = [now[0] - before[0], now[1] - before[1]];
      const others = [...held].filter(([id]) => id !== e.pointerId);
      held.set(e.pointerId, now);
      if (others.length > 0) {
        const [, fixed] = others[0];
        const apart = (p) => Math.hypot(p[0] - fixed[0], p[1] - fixed[1]);
        camera.pan(0.5 * dx, 0.5 * dy);
        camera.zoom(apart(before) / Math.max(apart(now), 1e-3), ...fixed);
      } else if (e.shiftKey || e.buttons & 6) {
        camera.pan(dx, dy);
      } else {
        camera.rotate(4 * dx, 4 * dy);
      }
      this.changed();
    });
    canvas.addEventListener("contextmenu", (e) => e.preventDefault());
    canvas.addEventListener("wheel", (e) => {
      e.preventDefault();
      const lines = e.deltaMode === 0 ? e.deltaY / 40 : e.deltaY;
      camera.zoom(Math.exp(0.06 * Math.max(-4, Math.min(4, lines))), ...share(e));
      this.changed();
    }, { passive: false });
    canvas.addEventListener("keydown", (e) => {
      const work = {
        ArrowLeft: () => camera.rotate(-0.1, 0), ArrowRight: () => camera.rotate(0.1, 0),
        ArrowUp: () => camera.rotate(0, -0.1), ArrowDown: () => camera.rotate(0, 0.1),
        "+": () => camera.zoom(0.8, 0, 0), "-": () => camera.zoom(1.25, 0, 0),
      }[e.key];
      if (!work) return;
      e.preventDefault();
      work();
      this.changed();
    });
  }

  // Says what is under the mouse.
  tell(e) {
    if (this.asking) return;
    this.asking = true;
    requestAnimationFrame(() => {
      this.asking = false;
      const box = this.canvas.getBoundingClientRect();
      const scale = this.canvas.width / box.width;
      const [x, y] = [(e.clientX - box.left) * scale, (box.bottom - e.clientY) * scale];
      const found = this.renderer.probeAt(this.camera, this.state, Math.floor(x), Math.floor(y));
      const out = this.get("told");
      if (!found) {
        out.textContent = "";
        return;
      }
      const { fields, length } = this.model.header;
      const field = fields[this.state.field];
      const place = found.place.map((c) => digits(c, 3)).join(", ");
      const value = digits(found.share * field.largest, 3);
      const name = this.model.bodies[found.body].name;
      out.textContent = `${name} at (${place}) ${length}: ${field.name} ${value} ${field.unit}`;
    });
  }
}

// `value` with so many significant digits, plainly where it can be.
function digits(value, count) {
  if (value === 0 || !Number.isFinite(value)) return "0";
  const size = Math.abs(value);
  if (size < 1e-4 || size >= 1e6) return value.toExponential(count - 1);
  const decimals = Math.max(0, count - 1 - Math.floor(Math.log10(size)));
  return value.toFixed(Math.min(decimals, 12));
}
