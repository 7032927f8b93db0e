// How the view of a chart moves.
Object.assign(Plot.prototype, {
  // The plots whose x moves together with this one's.
  peers() { return this.spec.cursor ? plots.filter(plot => plot.spec.cursor === this.spec.cursor) : [this]; },

  show(range, y) {
    for (const plot of this.peers()) {
      plot.u.batch(() => {
        plot.u.setScale("x", { min: range[0], max: range[1] });
        if (y) plot.u.setScale("y", { min: y[0], max: y[1] });
      });
    }
  },

  reset() { this.show(this.full); },

  zoomMap(u) {
    const { left, top, width, height } = u.select;
    if (width < 4 && height < 4) return;
    const x = [u.posToVal(left, "x"), u.posToVal(left + width, "x")];
    const y = [u.posToVal(top + height, "y"), u.posToVal(top, "y")];
    u.setSelect({ left: 0, top: 0, width: 0, height: 0 }, false);
    this.show(...this.fitted(u, x, y));
  },

  // The view about a fixed point, larger or smaller; moved by a share of itself.
  zoom(factor, about = 0.5, moved = 0) {
    const { spec, u } = this;
    const turn = (side, about) => {
      const log = spec[side].log, { min, max } = u.scales[side];
      const [from, to] = log ? [Math.log(min), Math.log(max)] : [min, max];
      const fixed = from + about * (to - from), shift = side === "x" ? moved * (to - from) : 0;
      const ends = [from, to].map(end => fixed + factor * (end - fixed) + shift);
      return log ? ends.map(Math.exp) : ends;
    };
    this.show(turn("x", about), spec.map ? turn("y", 0.5) : undefined);
  },

  pan(u, down) {
    const starts = { x: { ...u.scales.x }, y: { ...u.scales.y } };
    const to = (side, share) => {
      const { min, max } = starts[side];
      if (!this.spec[side].log) return [min - share * (max - min), max - share * (max - min)];
      const factor = (max / min) ** -share;
      return [min * factor, max * factor];
    };
    const move = event => this.show(
      to("x", (event.clientX - down.clientX) / u.over.clientWidth),
      this.spec.map ? to("y", (down.clientY - event.clientY) / u.over.clientHeight) : undefined);
    const up = () => { removeEventListener("mousemove", move); removeEventListener("mouseup", up); };
    addEventListener("mousemove", move);
    addEventListener("mouseup", up);
  },

  // Two fingers: what was between them stays between them.
  pinch(u) {
    let start = null;
    const seen = event => {
      const [a, b] = event.touches, { left, width } = u.over.getBoundingClientRect();
      return [a, b].map(touch => (touch.clientX - left) / width);
    };
    u.over.addEventListener("touchstart", event => {
      start = event.touches.length === 2 ? { at: seen(event), x: { ...u.scales.x } } : null;
    }, { passive: true });
    u.over.addEventListener("touchmove", event => {
      if (!start || event.touches.length !== 2) return;
      event.preventDefault();
      const log = this.spec.x.log, [from, to] = [start.x.min, start.x.max].map(end => log ? Math.log(end) : end);
      const [a, b] = start.at.map(part => from + part * (to - from)), [p, q] = seen(event);
      if (Math.abs(p - q) < 0.02) return;
      const width = (b - a) / (q - p), low = a - p * width;
      const range = [low, low + width].map(end => log ? Math.exp(end) : end);
      if (width > 0) this.show(range);
    }, { passive: false });
  },

  key(event) {
    const act = {
      "+": () => this.zoom(0.8), "-": () => this.zoom(1.25), "0": () => this.reset(),
      ArrowLeft: () => this.zoom(1, 0.5, -0.1), ArrowRight: () => this.zoom(1, 0.5, 0.1),
    }[event.key];
    if (act) { event.preventDefault(); act(); }
  },
});
