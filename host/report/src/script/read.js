// What the cursor tells.
Object.assign(Plot.prototype, {
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
  },

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
  },

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
  },
});
