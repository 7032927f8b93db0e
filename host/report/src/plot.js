// Charts: uPlot has the axes, the zoom and the shared cursor; each chart's layers are drawn here.
"use strict";
const root = document.documentElement;
const colour = name => getComputedStyle(root).getPropertyValue("--" + name).trim();
const minus = text => text.replaceAll("-", "−");

// A value for people, with as many digits as the data have.
const say = (value, digits = 5) => {
  if (value == null || Number.isNaN(value)) return "–";
  const size = Math.abs(value);
  if (size !== 0 && (size < 1e-4 || size >= 1e7)) return minus(value.toExponential(digits - 1).replace(/\.?0+e/, "e").replace("e+", "e"));
  return minus(String(+value.toPrecision(digits)));
};

// A tick, with the decimals that its step needs.
const tick = (value, step) => {
  if (value === 0) return "0";
  let decimals = 0;
  while (decimals < 9 && Math.abs(step * 10 ** decimals - Math.round(step * 10 ** decimals)) > 1e-6) decimals++;
  if (decimals > 6 || Math.abs(value) >= 1e7) return say(value, 4);
  return minus(value.toFixed(decimals));
};
// One on a scale of decades: whole multiples of powers of ten.
const power = value => {
  if (value == null) return null;
  const digit = value / 10 ** Math.floor(Math.log10(value) + 1e-9);
  if (Math.abs(digit - Math.round(digit)) > 1e-6) return null;
  return value >= 0.01 && value < 1e4 ? String(+value.toPrecision(3)) : say(value, 3);
};

// Numbers: first, last and count of equal steps, or singles in base 64.
const numbers = code => {
  if (Array.isArray(code)) {
    const [first, last, count] = code;
    return Float64Array.from({ length: count }, (_, i) => count > 1 ? first + (last - first) * i / (count - 1) : first);
  }
  return new Float32Array(Uint8Array.from(atob(code), c => c.charCodeAt(0)).buffer);
};

const extent = (values, from = [Infinity, -Infinity]) => {
  let [low, high] = from;
  for (const value of values) if (Number.isFinite(value)) { low = Math.min(low, value); high = Math.max(high, value); }
  return [low, high];
};

// A range with some air; what is flat, or nothing, gets room on both sides.
const aired = ([low, high], { log, zero }) => {
  if (log) {
    if (!(low > 0) || !(high > 0)) return [0.1, 10];
    const air = Math.max(1.3, (high / low) ** 0.03);
    return [low / air, high * air];
  }
  if (low > high) return [-1, 1];
  if (zero) [low, high] = [Math.min(0, low), Math.max(0, high)];
  const least = 1e-6 * Math.max(Math.abs(low), Math.abs(high));
  const air = high - low > least ? 0.06 * (high - low) : least > 0 ? 5e4 * least : 1;
  return [zero && low === 0 ? 0 : low - air, high + air];
};

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
    const axis = side => ({
      scale: side,
      stroke: () => colour("muted"),
      font: "11px system-ui, sans-serif",
      labelFont: "11px system-ui, sans-serif",
      grid: { stroke: () => colour("grid"), width: 1, filter: decades },
      ticks: { stroke: () => colour("grid"), width: 1, size: 4, filter: decades },
      space: side === "x" ? 56 : 26,
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
    const pen = u.ctx, { left, top, width, height } = u.bbox;
    pen.save();
    pen.beginPath();
    pen.rect(left, top, width, height);
    pen.clip();
    this.paint(pen, true);
    pen.restore();
  }

  paint(pen, isCanvas) {
    const scale = isCanvas ? devicePixelRatio : 1;
    for (const layer of this.spec.layers) if (layer.shown) this.layer(pen, layer, scale, isCanvas);
    if (this.spec.map) this.rule(pen, scale, isCanvas);
  }

  layer(pen, { kind, ink, x, low, high, opacity, width, dashed, radius, ring, labels }, scale, isCanvas) {
    const X = i => this.at("x", x[i], isCanvas);
    const [upper, lower] = [high, low].map(values => i => this.at("y", values[i], isCanvas));
    pen.strokeStyle = pen.fillStyle = colour(ink);
    pen.lineWidth = (width ?? 1.2) * scale;
    pen.setLineDash(dashed ? [5 * scale, 3 * scale] : []);
    pen.globalAlpha = opacity ?? 1;
    const known = i => Number.isFinite(X(i)) && Number.isFinite(upper(i)) && Number.isFinite(lower(i));
    const trace = (of, from, to, step, isStart) => {
      for (let i = from; i !== to; i += step) {
        if (isStart && i === from) pen.moveTo(X(i), of(i)); else pen.lineTo(X(i), of(i));
      }
    };
    if (kind === "dots" || kind === "marks") {
      for (let i = 0; i < x.length; i++) {
        if (!known(i)) continue;
        pen.beginPath();
        pen.arc(X(i), upper(i), radius * scale, 0, 2 * Math.PI);
        pen.fill();
        if (ring) {
          pen.fillStyle = colour("paper");
          pen.beginPath();
          pen.arc(X(i), upper(i), 0.55 * radius * scale, 0, 2 * Math.PI);
          pen.fill();
          pen.fillStyle = colour(ink);
        }
        if (kind === "marks") {
          const { left, top, width: wide, height: tall } = this.u.bbox, k = isCanvas ? 1 : 1 / devicePixelRatio;
          const isRight = X(i) > (left + wide / 2) * k, isLow = upper(i) > (top + tall / 2) * k;
          pen.font = `${11 * scale}px system-ui, sans-serif`;
          pen.textAlign = isRight ? "right" : "left";
          pen.fillText(labels[i], X(i), upper(i) + (isLow ? 15 : -8) * scale);
        }
      }
      pen.globalAlpha = 1;
      return;
    }
    for (let from = 0; from < x.length;) {
      if (!known(from)) { from++; continue; }
      let to = from;
      while (to < x.length && known(to)) to++;
      pen.beginPath();
      if (kind === "bars") {
        for (let i = from; i < to; i++) { pen.moveTo(X(i), upper(i)); pen.lineTo(X(i), lower(i)); }
        pen.stroke();
      } else {
        trace(upper, from, to, 1, true);
        if (kind !== "line") {
          trace(lower, to - 1, from - 1, -1);
          pen.closePath();
          pen.fill();
        }
        if (kind !== "band") pen.stroke();
      }
      from = to;
    }
    pen.globalAlpha = 1;
    pen.setLineDash([]);
  }

  // The scale bar of a map, and north.
  rule(pen, scale, isCanvas) {
    const k = isCanvas ? 1 : 1 / devicePixelRatio;
    const [left, top, width, height] = ["left", "top", "width", "height"].map(side => this.u.bbox[side] * k);
    const { min, max } = this.u.scales.x, rough = (max - min) / 4;
    const decade = 10 ** Math.floor(Math.log10(rough));
    const length = [5, 2, 1].find(digit => digit * decade <= rough) * decade;
    const pixels = length / (max - min) * width;
    const [x, y] = [left + 10 * scale, top + height - 10 * scale];
    pen.strokeStyle = pen.fillStyle = colour("text");
    pen.lineWidth = 1.5 * scale;
    pen.font = `${11 * scale}px system-ui, sans-serif`;
    pen.textAlign = "left";
    pen.beginPath();
    pen.moveTo(x, y - 4 * scale); pen.lineTo(x, y); pen.lineTo(x + pixels, y); pen.lineTo(x + pixels, y - 4 * scale);
    pen.stroke();
    pen.fillText(`${say(length)} ${this.spec.x.unit}`, x + 4 * scale, y - 5 * scale);
    const [nx, ny] = [left + width - 12 * scale, top + 28 * scale];
    pen.beginPath();
    pen.moveTo(nx, ny); pen.lineTo(nx, ny - 14 * scale);
    pen.moveTo(nx - 4 * scale, ny - 8 * scale); pen.lineTo(nx, ny - 15 * scale); pen.lineTo(nx + 4 * scale, ny - 8 * scale);
    pen.stroke();
    pen.textAlign = "center";
    pen.fillText("N", nx, ny + 12 * scale);
  }

  // Values under the cursor, in every chart that shares it.
  read(u) {
    const { left } = u.cursor, { spec, values } = this;
    if (!values) return;
    if (left == null || left < 0) { values.hidden = true; return; }
    const lines = spec.map || spec.near ? this.nearest(u) : this.along(u.posToVal(left, "x"));
    values.hidden = lines.length === 0;
    values.textContent = lines.join("\n");
    const isRight = left > u.over.clientWidth / 2;
    values.style.left = isRight ? "6px" : "auto";
    values.style.right = isRight ? "auto" : "6px";
  }

  along(at) {
    const { x, y, layers } = this.spec;
    const lines = [`${x.label} ${say(at)} ${x.unit}`];
    for (const layer of layers) {
      if (!layer.shown || !layer.name || layer.x.length === 0) continue;
      let [from, to] = [0, layer.x.length - 1];
      while (to - from > 1) {
        const middle = (from + to) >> 1;
        if (layer.x[middle] <= at) from = middle; else to = middle;
      }
      const i = Math.abs(layer.x[from] - at) <= Math.abs(layer.x[to] - at) ? from : to;
      const [low, high] = [layer.low[i], layer.high[i]];
      const told = low === high || say(low) === say(high) ? say(high) : `${say(low)} … ${say(high)}`;
      lines.push(`${layer.name} ${told} ${y.unit}`);
    }
    return lines;
  }

  nearest(u) {
    const { x, y, layers } = this.spec;
    const [left, top] = [u.cursor.left + u.bbox.left / devicePixelRatio, u.cursor.top + u.bbox.top / devicePixelRatio];
    let best = null, least = 30;
    for (const layer of layers) {
      if (!layer.shown) continue;
      for (let i = 0; i < layer.x.length; i++) {
        const far = Math.hypot(this.at("x", layer.x[i]) - left, this.at("y", layer.high[i]) - top);
        if (far < least) { least = far; best = [layer, i]; }
      }
    }
    if (!best) return [];
    const [layer, i] = best;
    const name = layer.labels?.[i] ?? layer.name;
    return [...(name ? [name] : []), `${x.label} ${say(layer.x[i])} ${x.unit}`, `${y.label} ${say(layer.high[i])} ${y.unit}`];
  }

  // The plots whose x moves together with this one's.
  peers() { return this.spec.cursor ? plots.filter(plot => plot.spec.cursor === this.spec.cursor) : [this]; }

  show(range, y) {
    for (const plot of this.peers()) {
      plot.u.batch(() => {
        plot.u.setScale("x", { min: range[0], max: range[1] });
        if (y) plot.u.setScale("y", { min: y[0], max: y[1] });
      });
    }
  }

  reset() { this.show(this.full); }

  zoomMap(u) {
    const { left, top, width, height } = u.select;
    if (width < 4 && height < 4) return;
    const x = [u.posToVal(left, "x"), u.posToVal(left + width, "x")];
    const y = [u.posToVal(top + height, "y"), u.posToVal(top, "y")];
    u.setSelect({ left: 0, top: 0, width: 0, height: 0 }, false);
    this.show(...this.fitted(u, x, y));
  }

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
  }

  pan(u, down) {
    down.preventDefault();
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
  }

  key(event) {
    const act = {
      "+": () => this.zoom(0.8), "-": () => this.zoom(1.25), "0": () => this.reset(),
      ArrowLeft: () => this.zoom(1, 0.5, -0.1), ArrowRight: () => this.zoom(1, 0.5, 0.1),
    }[event.key];
    if (act) { event.preventDefault(); act(); }
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
