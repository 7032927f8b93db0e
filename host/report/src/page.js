// Reads values under the pointer back from the drawn paths.
for (const svg of document.querySelectorAll("svg[data-box]")) {
  const [left, top, width, height] = svg.dataset.box.split(" ").map(Number);
  const [x0, x1, y0, y1] = svg.dataset.range.split(" ").map(Number);
  const xOf = px => x0 + (px - left) / width * (x1 - x0);
  const yOf = py => y1 - (py - top) / height * (y1 - y0);
  // A path's coordinates are multiples of 0.1: no more decimals than that resolves.
  const say = (value, range, pixels) =>
    value.toFixed(Math.min(9, Math.max(0, Math.ceil(-Math.log10(range / pixels / 10)))));
  const sayX = px => say(xOf(px), x1 - x0, width);
  const sayY = py => say(yOf(py), y1 - y0, height);
  const isMap = "map" in svg.dataset;
  const out = document.createElement("output");
  const cursor = document.createElementNS(svg.namespaceURI, "path");
  cursor.setAttribute("stroke", "currentColor");
  cursor.setAttribute("opacity", "0.5");
  let curves;
  svg.addEventListener("pointermove", event => {
    curves ??= [...svg.querySelectorAll("[data-name]")].map(path => ({
      name: path.dataset.name,
      points: path.getAttribute("d").slice(1).replace("Z", "").split("L").map(p => p.split(" ").map(Number)),
    }));
    const at = new DOMPoint(event.clientX, event.clientY).matrixTransform(svg.getScreenCTM().inverse());
    if (at.x < left || at.x > left + width || !curves.length) return hide();
    const far = p => isMap ? Math.hypot(p[0] - at.x, p[1] - at.y) : Math.abs(p[0] - at.x);
    const near = curves.map(c => c.points.reduce((a, b) => far(b) < far(a) ? b : a));
    const [px, py] = near[near.length - 1];
    cursor.setAttribute("d", isMap ? `M${px - 6} ${py}h12M${px} ${py - 6}v12` : `M${px} ${top}v${height}`);
    const lines = isMap ? [`east ${sayX(px)}\nnorth ${sayY(py)}`]
      : [`${svg.dataset.x} ${sayX(px)}`, ...curves.map((c, i) => `${c.name} ${sayY(near[i][1])}`).reverse()];
    out.textContent = lines.join("\n").replaceAll("-", "−");
    const right = px > left + width / 2;
    out.style.left = right ? "14%" : "auto";
    out.style.right = right ? "auto" : "5%";
    if (!out.parentNode) { svg.append(cursor); svg.parentNode.append(out); }
  });
  const hide = () => { out.remove(); cursor.remove(); };
  svg.addEventListener("pointerleave", hide);
}
