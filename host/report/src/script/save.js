// A chart as a file: a picture, a drawing, its numbers.
const hand = (plot, form, blob) => {
  const link = document.createElement("a");
  link.href = URL.createObjectURL(blob);
  link.download = plot.spec.title.toLowerCase().replace(/[^a-z0-9]+/g, "-").replace(/^-|-$/g, "") + "." + form;
  link.click();
  setTimeout(() => URL.revokeObjectURL(link.href), 1000);
};
const markup = text => String(text).replace(/[&<>"]/g, c => `&#${c.charCodeAt(0)};`);

// Takes what a canvas takes, and keeps it as paths.
class Drawing {
  constructor() { this.parts = []; this.path = ""; this.dash = []; this.globalAlpha = 1; }
  beginPath() { this.path = ""; }
  moveTo(x, y) { this.path += `M${x.toFixed(1)} ${y.toFixed(1)}`; }
  lineTo(x, y) { this.path += `L${x.toFixed(1)} ${y.toFixed(1)}`; }
  closePath() { this.path += "Z"; }
  arc(x, y, r) { this.path += `M${(x - r).toFixed(1)} ${y.toFixed(1)}a${r} ${r} 0 1 0 ${2 * r} 0a${r} ${r} 0 1 0 ${-2 * r} 0`; }
  setLineDash(dash) { this.dash = dash; }
  fill() { this.parts.push(`<path d="${this.path}" fill="${this.fillStyle}" fill-opacity="${this.globalAlpha}"/>`); }
  stroke() {
    const dash = this.dash.length ? ` stroke-dasharray="${this.dash.join(" ")}"` : "";
    this.parts.push(`<path d="${this.path}" fill="none" stroke="${this.strokeStyle}" stroke-width="${this.lineWidth}"${dash}/>`);
  }
  fillText(text, x, y, size = 11, weight = 400) {
    const anchor = { right: "end", center: "middle" }[this.textAlign] ?? "start";
    this.parts.push(`<text x="${x.toFixed(1)}" y="${y.toFixed(1)}" fill="${this.fillStyle}" font-size="${size}" font-weight="${weight}" text-anchor="${anchor}">${markup(text)}</text>`);
  }
}

const save = {
  png(plot) {
    const drawn = plot.u.ctx.canvas, scale = devicePixelRatio, head = 28 * scale;
    const sheet = document.createElement("canvas");
    [sheet.width, sheet.height] = [drawn.width, drawn.height + head];
    const pen = sheet.getContext("2d");
    pen.fillStyle = colour("paper");
    pen.fillRect(0, 0, sheet.width, sheet.height);
    pen.fillStyle = colour("text");
    pen.font = `600 ${13 * scale}px system-ui, sans-serif`;
    pen.fillText(plot.spec.title, 10 * scale, 18 * scale);
    pen.drawImage(drawn, 0, head);
    sheet.toBlob(blob => hand(plot, "png", blob));
  },

  svg(plot) {
    const { u, spec } = plot, k = 1 / devicePixelRatio, head = 28;
    const [left, top, width, height] = ["left", "top", "width", "height"].map(side => u.bbox[side] * k);
    const pen = new Drawing();
    const line = (...points) => {
      pen.beginPath();
      points.forEach(([x, y], i) => i ? pen.lineTo(x, y) : pen.moveTo(x, y));
      pen.stroke();
    };
    pen.lineWidth = 1;
    for (const [axis, side] of [[u.axes[0], "x"], [u.axes[1], "y"]]) {
      (axis._splits ?? []).forEach((value, i) => {
        const label = axis._values?.[i], at = plot.at(side, value, false);
        if (label == null || !Number.isFinite(at)) return;
        pen.strokeStyle = colour("grid");
        pen.fillStyle = colour("muted");
        pen.textAlign = side === "x" ? "center" : "right";
        if (side === "x") { line([at, top], [at, top + height]); pen.fillText(label, at, top + height + 16); }
        else { line([left, at], [left + width, at]); pen.fillText(label, left - 7, at + 4); }
      });
    }
    pen.textAlign = "center";
    pen.fillText(u.axes[0].label, left + width / 2, top + height + 34);
    const ground = pen.parts;
    pen.parts = [];
    plot.paint(pen, false);
    const paper = colour("paper");
    const text = `<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 ${-head} ${u.width} ${u.height + head}" font-family="system-ui, sans-serif">
<rect y="${-head}" width="100%" height="100%" fill="${paper}"/>
<clipPath id="c"><rect x="${left}" y="${top}" width="${width}" height="${height}"/></clipPath>
<text x="10" y="-9" font-size="13" font-weight="600" fill="${colour("text")}">${markup(spec.title)}</text>
${ground.join("\n")}\n<g clip-path="url(#c)">${pen.parts.join("\n")}</g></svg>\n`;
    hand(plot, "svg", new Blob([text], { type: "image/svg+xml" }));
  },

  csv(plot) {
    const { x, y, layers } = plot.spec;
    const cell = text => /[",\n]/.test(text) ? `"${text.replaceAll('"', '""')}"` : text;
    const head = ["series", `${x.label} ${x.unit}`, `least ${y.unit}`, `greatest ${y.unit}`].map(text => cell(text.trim()));
    const rows = layers.flatMap(layer => Array.from(layer.x, (at, i) =>
      [cell(layer.labels?.[i] ?? layer.name), +at.toPrecision(9), +layer.low[i].toPrecision(7), +layer.high[i].toPrecision(7)].join(",")));
    hand(plot, "csv", new Blob([[head.join(","), ...rows].join("\n") + "\n"], { type: "text/csv" }));
  },
};
