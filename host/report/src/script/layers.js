// How the layers of a chart are drawn, and the scale bar of a map.
Object.assign(Plot.prototype, {
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
  },

  // The scale bar of a map, and north.
  rule(pen, scale, isCanvas) {
    const k = isCanvas ? 1 : 1 / devicePixelRatio;
    const [left, top, width, height] = ["left", "top", "width", "height"].map(side => this.u.bbox[side] * k);
    const { min, max } = this.u.scales.x, rough = (max - min) / 4;
    const decade = 10 ** Math.floor(Math.log10(rough));
    const length = [5, 2, 1].find(digit => digit * decade <= rough) * decade;
    const pixels = length / (max - min) * width;
    // On the left, unless a name stands there.
    const marks = this.spec.layers.filter(layer => layer.kind === "marks");
    const stands = inside => marks.some(({ x, high }) => Array.from(x).some((at, i) =>
      inside((this.at("x", at, isCanvas) - left) / width, (this.at("y", high[i], isCanvas) - top) / height)));
    const isTaken = stands((right, down) => right < 0.6 && down > 0.8);
    const [x, y] = [isTaken ? left + width - pixels - 10 * scale : left + 10 * scale, top + height - 10 * scale];
    pen.strokeStyle = pen.fillStyle = colour("text");
    pen.lineWidth = 1.5 * scale;
    pen.font = `${11 * scale}px system-ui, sans-serif`;
    pen.textAlign = "left";
    pen.beginPath();
    pen.moveTo(x, y - 4 * scale); pen.lineTo(x, y); pen.lineTo(x + pixels, y); pen.lineTo(x + pixels, y - 4 * scale);
    pen.stroke();
    pen.fillText(`${say(length)} ${this.spec.x.unit}`, x + 4 * scale, y - 5 * scale);
    const isUpTaken = stands((right, down) => right > 0.5 && down < 0.2);
    const [nx, ny] = [isUpTaken ? left + 12 * scale : left + width - 12 * scale, top + 28 * scale];
    pen.beginPath();
    pen.moveTo(nx, ny); pen.lineTo(nx, ny - 14 * scale);
    pen.moveTo(nx - 4 * scale, ny - 8 * scale); pen.lineTo(nx, ny - 15 * scale); pen.lineTo(nx + 4 * scale, ny - 8 * scale);
    pen.stroke();
    pen.textAlign = "center";
    pen.fillText("N", nx, ny + 12 * scale);
  },
});
