// Draws every chart, again in light colours for paper, and in the other theme when that changes.
const plots = [];
for (const figure of document.querySelectorAll("figure.plot")) plots.push(new Plot(figure));
const again = () => plots.forEach(plot => { plot.u.setSize(plot.size()); plot.redraw(); });
matchMedia("(prefers-color-scheme: dark)").addEventListener("change", again);
addEventListener("beforeprint", () => { root.dataset.print = ""; again(); });
addEventListener("afterprint", () => { delete root.dataset.print; again(); });
