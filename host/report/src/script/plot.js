// A chart: uPlot has its axes, its zoom and its cursor; layers are drawn over them.
class Plot {
  constructor(figure) {
    this.figure = figure;
    this.spec = JSON.parse(figure.querySelector("script").textContent);
    this.place = figure.querySelector(".draw");
    for (const layer of this.spec.layers) {
      layer.x = numbers(layer.x);
      layer.high = numbers(layer.high);
      layer.low = layer.low ? numbers(layer.low) : layer.high;
      layer.shown = true;
    }
    const all = this.spec.layers.reduce((range, layer) => extent(layer.x, range), [Infinity, -Infinity]);
    const { x, map } = this.spec;
    // What begins a sample after zero begins at zero.
    if (!x.log && !map && all[0] > 0 && all[0] < 0.02 * all[1]) all[0] = 0;
    this.full = x.range ?? (x.log || map || this.spec.airy ? aired(all, x) : all[0] < all[1] ? all : aired(all, x));
    this.view = this.full;
    this.legend();
    this.draw();
    figure.dataset.drawn = "";
  }

  // The y range of what is shown between two x.
  span([from, to]) {
    const { y } = this.spec;
    if (y.range) return y.range;
    let range = [Infinity, -Infinity];
    for (const { x, low, high, shown } of this.spec.layers) {
      if (!shown) continue;
      for (let i = 0; i < x.length; i++) {
        // What a line comes from and goes to is seen, too.
        if ((x[i + 1] ?? x[i]) < from && x[i] < from || (x[i - 1] ?? x[i]) > to && x[i] > to) continue;
        const values = y.log ? [low[i], high[i]].filter(value => value > 0) : [low[i], high[i]];
        range = extent(values, range);
      }
    }
    return aired(range, y);
  }

  // Both ranges of a map, widened to one scale.
  fitted(u, x, y) {
    const shape = u.bbox.width / u.bbox.height || 1;
    const [width, height] = [x[1] - x[0], y[1] - y[0]];
    const room = Math.max(height, width / shape);
    const wider = (room * shape - width) / 2, higher = (room - height) / 2;
    return [[x[0] - wider, x[1] + wider], [y[0] - higher, y[1] + higher]];
  }

  size() {
    const width = root.dataset.print === undefined ? this.place.clientWidth : this.figure.matches(".wide, .whole") ? 640 : 310;
    return { width: Math.max(200, width), height: this.spec.height };
  }

  draw() {
    const { spec } = this;
    const ranges = {
      x: (u, low, high) => {
        const whole = low === this.full[0] && high === this.full[1];
        this.whole = whole;
        this.view = [low, high];
        if (whole && spec.map) this.view = this.fitted(u, this.full, this.span(this.full))[0];
        return this.view;
      },
      y: u => spec.map ? this.fitted(u, this.full, this.span(this.full))[1] : this.span(this.view),
    };
    // Of many decades, the powers of ten alone.
    const decades = (u, splits, axis) => {
      const side = axis === 0 ? "x" : "y", { min, max } = u.scales[side];
      if (!spec[side].log || max / min < 1e5) return splits;
      return splits.map(value => Math.abs(Math.log10(value) - Math.round(Math.log10(value))) < 1e-6 ? value : null);
    };
    // As many of a decade's labels as there is room for.
    const labelled = (u, splits, axis, space) => {
      const side = axis === 0 ? "x" : "y", { min } = u.scales[side];
      if (!spec[side].log) return splits;
      const decade = Math.abs(u.valToPos(10 * min, side) - u.valToPos(min, side));
      const kept = [...(0.05 * decade > space ? [3, 4, 6, 7, 8, 9] : []), ...(0.3 * decade > space ? [2, 5] : []), 1];
      const each = Math.ceil(space / decade);
      return splits.map(value => {
        const power = Math.floor(Math.log10(value) + 1e-9), digit = Math.round(value / 10 ** power);
        return kept.includes(digit) && power % each === 0 ? value : null;
      });
    };
    const axis = side => ({
      scale: side,
      stroke: () => colour("muted"),
      font: "11px system-ui, sans-serif",
      labelFont: "11px system-ui, sans-serif",
      grid: { stroke: () => colour("grid"), width: 1, filter: decades },
      ticks: { stroke: () => colour("grid"), width: 1, size: 4, filter: decades },
      space: side === "x" ? 56 : 26,
      filter: labelled,
      ...(spec[side].log && { splits: (u, _, min, max) => digits(min, max) }),
      values: (u, splits, _, __, step) => splits.map(value => spec[side].log ? power(value) : value == null ? null : tick(value, step)),
      ...(side === "x"
        ? { label: [spec.x.label, spec.x.unit].filter(Boolean).join(", "), labelSize: 18, labelGap: 0, size: 26, gap: 3 }
        : { size: (u, values) => 14 + 6.4 * Math.max(3, ...(values ?? []).map(value => value?.length ?? 0)) }),
    });
    const scale = side => ({ time: false, range: ranges[side], distr: spec[side].log ? 3 : 1, auto: side === "y" || undefined });
    const pan = (u, _, usual) => event => event.shiftKey ? this.pan(u, event) : usual(event);
    this.u = new uPlot({
      ...this.size(),
      padding: [8, 12, 0, 0],
      scales: { x: scale("x"), y: scale("y") },
      axes: [axis("x"), axis("y")],
      series: [{}, { paths: () => null, points: { show: false } }],
      legend: { show: false },
      cursor: {
        y: spec.map, points: { show: false }, bind: { mousedown: pan },
        drag: { x: true, y: spec.map, setScale: !spec.map },
        ...(spec.cursor && { sync: { key: spec.cursor, setSeries: false, scales: ["x", null] } }),
      },
      hooks: {
        draw: [u => this.paintOn(u)],
        setCursor: [u => this.read(u)],
        setSelect: [u => spec.map && this.zoomMap(u)],
      },
    }, [this.full, [null, null]], this.place);
    this.values = document.createElement("div");
    this.values.className = "values";
    this.values.hidden = true;
    this.u.over.append(this.values);
    this.u.over.addEventListener("wheel", event => {
      if (!event.ctrlKey) return;
      event.preventDefault();
      this.zoom(event.deltaY > 0 ? 1.25 : 0.8, event.offsetX / this.u.over.clientWidth);
    }, { passive: false });
    if (spec.map) this.u.over.addEventListener("dblclick", () => this.reset());
    if (!spec.map) this.pinch(this.u);
    this.place.addEventListener("keydown", event => this.key(event));
    new ResizeObserver(() => {
      const size = this.size();
      if (size.width !== this.u.width) this.u.setSize(size);
    }).observe(this.place);
  }

  // Positions in pixels of the canvas, or of the page.
  at(side, value, isCanvas) {
    if (this.spec[side].log && !(value > 0)) return NaN;
    const { u } = this, box = side === "x" ? u.bbox.left : u.bbox.top;
    return u.valToPos(value, side, isCanvas) + (isCanvas ? 0 : box / devicePixelRatio);
  }

  paintOn(u) {
    if (this.spec.map && this.whole) this.settle(u);
    const pen = u.ctx, { left, top, width, height } = u.bbox;
    pen.save();
    pen.beginPath();
    pen.rect(left, top, width, height);
    pen.clip();
    this.paint(pen, true);
    pen.restore();
  }

  // A map's whole, once it is known how much room the labels leave.
  settle(u) {
    const [x] = this.fitted(u, this.full, this.span(this.full)), { min, max } = u.scales.x;
    const off = Math.abs(x[0] - min) + Math.abs(x[1] - max);
    this.settled = off < 1e-3 * (max - min) ? 0 : (this.settled ?? 0) + 1;
    if (this.settled > 0 && this.settled < 4) queueMicrotask(() => this.reset());
  }

  paint(pen, isCanvas) {
    const scale = isCanvas ? devicePixelRatio : 1;
    for (const layer of this.spec.layers) if (layer.shown) this.layer(pen, layer, scale, isCanvas);
    if (this.spec.map) this.rule(pen, scale, isCanvas);
  }

  legend() {
    const named = this.spec.layers.filter(layer => layer.name);
    const list = document.createElement("div");
    list.className = "legend";
    for (const layer of named.length > 1 ? named : []) {
      const button = document.createElement("button");
      const swatch = document.createElement("i");
      swatch.className = `i-${layer.ink} ${layer.kind}${layer.dashed ? " dashed" : ""}`;
      swatch.style.opacity = layer.kind === "band" ? Math.min(1, layer.opacity + 0.15) : 1;
      button.append(swatch, layer.name);
      button.setAttribute("aria-pressed", "true");
      button.addEventListener("click", () => {
        layer.shown = !layer.shown;
        button.setAttribute("aria-pressed", String(layer.shown));
        this.redraw();
      });
      list.append(button);
    }
    const tools = document.createElement("div");
    tools.className = "tools";
    const tool = (name, title, act) => {
      const button = document.createElement("button");
      button.textContent = name;
      button.title = title;
      button.setAttribute("aria-label", `${title}: ${this.spec.title}`);
      button.addEventListener("click", act);
      tools.append(button);
    };
    tool("all", "Show the whole", () => this.reset());
    for (const form of ["png", "svg", "csv"]) tool(form.toUpperCase(), `Save as ${form.toUpperCase()}`, () => save[form](this));
    this.figure.append(list, tools);
  }

  // With the ranges that follow from what is shown, in the colours of the page.
  redraw() {
    const { min, max } = this.u.scales.x;
    // Before it is drawn for the first time, that is still to come.
    if (min == null) return;
    if (this.whole) this.u.setScale("x", { min: this.full[0], max: this.full[1] });
    else this.u.setScale("x", { min, max });
  }
}
