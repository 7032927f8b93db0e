// The cheapest way within a budget, among the points with some words in their names.
const budget = document.getElementById("budget"), words = document.getElementById("words");
for (const plot of plots) {
  for (const layer of plot.spec.layers) layer.all = { x: layer.x, high: layer.high, labels: layer.labels };
  plot.budget = { kind: "line", ink: "bad", name: "", width: 1.5, dashed: true, shown: true, x: [], high: [], low: [], all: { x: [], high: [] } };
  plot.spec.layers.push(plot.budget);
}
const inMetres = metres => {
  for (const [unit, size] of [["km", 1e3], ["m", 1], ["mm", 1e-3], ["µm", 1e-6], ["nm", 1e-9]]) {
    if (metres >= size * 0.9999) return `${say(metres / size, 2)} ${unit}`;
  }
  return `${say(metres / 1e-12, 2)} pm`;
};
const choose = () => {
  const most = 10 ** +budget.value;
  document.getElementById("within").textContent = inMetres(most);
  const asked = words.value.toLowerCase().split(/\s+/).filter(Boolean);
  const rows = plots.map(plot => {
    let best = null;
    for (const layer of plot.spec.layers) {
      if (!layer.all.labels) continue;
      const { x, high, labels } = layer.all;
      // A whole word each, so that "f32" is not "f32x2", nor "20" "200".
      const kept = labels.map((_, i) => i).filter(i => asked.every(word => labels[i].toLowerCase().split(" ").includes(word)));
      layer.x = kept.map(i => x[i]);
      layer.low = layer.high = kept.map(i => high[i]);
      layer.labels = kept.map(i => labels[i]);
      for (const i of kept) {
        if (high[i] <= most && !labels[i].includes("micromath") && (!best || x[i] < best[0])) best = [x[i], high[i], labels[i]];
      }
    }
    plot.budget.x = [...plot.full];
    plot.budget.high = plot.budget.low = [most, most];
    plot.redraw();
    const scene = plot.spec.title.split(":")[0];
    return best ? [scene, best[2], `${say(best[0], 3)} µs`, inMetres(best[1])] : [scene, "nothing that was measured is within", "", ""];
  });
  const table = document.createElement("table");
  for (const [i, row] of [["scene", "the cheapest is", "time per second", "error"], ...rows].entries()) {
    const line = table.insertRow();
    for (const cell of row) line.append(Object.assign(document.createElement(i ? "td" : "th"), { textContent: cell }));
  }
  const place = document.getElementById("cheapest");
  place.className = "panel";
  place.tabIndex = 0;
  place.setAttribute("role", "group");
  place.setAttribute("aria-label", "the cheapest");
  place.replaceChildren(table);
};
budget.addEventListener("input", choose);
words.addEventListener("input", choose);
choose();
