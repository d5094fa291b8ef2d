"use strict";
const data = JSON.parse(document.getElementById("data").textContent);
const P = data.parameters, F = P.slice(0, data.free), M = data.metrics, cloud = data.cloud;
const style = (name) => getComputedStyle(document.documentElement).getPropertyValue(name).trim();
const ACCENT = "#2a86b8";
let INK, SOFT, HOT, LINE, CARD;
function colours() { [INK, SOFT, HOT, LINE, CARD] = ["--ink", "--ink-soft", "--accent", "--grid", "--card"].map(style); }
colours();
const byId = (id) => document.getElementById(id);
const config = { displaylogo: false, responsive: true, modeBarButtonsToRemove: ["lasso2d", "select2d", "autoScale2d"] };

function text(value) {
  if (value === null || value === undefined) return "";
  if (typeof value === "string") return value;
  const size = Math.abs(value);
  const words = size !== 0 && (size >= 1e6 || size < 1e-3) ? value.toExponential(2)
    : size >= 1000 ? value.toFixed(0) : String(parseFloat(value.toPrecision(4)));
  return words.replace("-", "\u2212");
}
const shown = (column, value) => (column.labels.length ? column.labels[value] : text(value));
const label = (column) => column.title + (column.unit ? " (" + column.unit.replace("^3", "³").replace("um", "µm") + ")" : "");
const short = (column) => column.title.replace(/\./g, ".<wbr>");

function layout(more) {
  return Object.assign({
    font: { family: "system-ui, 'Segoe UI', Roboto, 'DejaVu Sans', sans-serif", size: 13, color: INK },
    paper_bgcolor: CARD, plot_bgcolor: CARD, margin: { l: 70, r: 20, t: 30, b: 55 }, hovermode: "closest", showlegend: false,
  }, more);
}
const axis = (title, more) => Object.assign({ title: { text: title, standoff: 8 }, gridcolor: LINE, linecolor: LINE, zeroline: false, automargin: true }, more);
function ticks(column) {
  return column.labels.length ? { tickvals: column.labels.map((_, k) => k), ticktext: column.labels, range: [-0.5, column.labels.length - 0.5] } : {};
}

function fill(id, columns, chosen, onChange) {
  const select = byId(id);
  columns.forEach((column, k) => select.add(new Option(label(column), k, false, k === chosen)));
  select.addEventListener("change", onChange);
}
const chosen = (id) => Number(byId(id).value);

/* -- main effects ------------------------------------------------------------------------------ */
function drawEffects() {
  const m = chosen("effect-metric"), columns = Math.min(3, F.length), rows = Math.ceil(F.length / columns);
  const traces = [], figure = layout({ height: 60 + 260 * rows, grid: { rows, columns, pattern: "independent", xgap: 0.12, ygap: 0.32 }, margin: { l: 70, r: 15, t: 15, b: 60 } });
  F.forEach((parameter, p) => {
    const own = data.effects[m][p], n = p ? p + 1 : "", ax = { xaxis: "x" + n, yaxis: "y" + n };
    traces.push({ type: "scattergl", mode: "markers", x: cloud.parameters[p], y: cloud.metrics[m], marker: { size: 3, color: SOFT, opacity: 0.25 }, hoverinfo: "skip", ...ax });
    traces.push({ type: "scatter", mode: "lines", x: own.centres.concat([...own.centres].reverse()), y: own.high.concat([...own.low].reverse()), fill: "toself", fillcolor: "rgba(42,111,151,.16)", line: { width: 0 }, hoverinfo: "skip", ...ax });
    traces.push({ type: "scatter", mode: "lines+markers", x: own.centres, y: own.mean, line: { color: ACCENT, width: 2.5 }, marker: { size: 5 }, hovertemplate: "%{x:.4g}<br>mean %{y:.4g}<extra></extra>", ...ax });
    if (M[m].name in data.base) {
      const now = data.baseValues[parameter.name];
      const at = parameter.labels.length ? parameter.labels.indexOf(now) : now;
      if (typeof at === "number" && at !== -1) traces.push({ type: "scatter", mode: "markers", x: [at], y: [data.base[M[m].name]], marker: { symbol: "diamond", size: 10, color: HOT }, hovertemplate: "base<extra></extra>", ...ax });
    }
    figure["xaxis" + n] = axis(label(parameter), ticks(parameter));
    figure["yaxis" + n] = axis("", {});
  });
  Plotly.react("effect-plot", traces, figure, config);
}

/* -- pairs ------------------------------------------------------------------------------------- */
function drawMap() {
  const m = chosen("map-metric"), x = chosen("map-x"), y = chosen("map-y");
  const found = data.maps.find((each) => (each.first === x && each.second === y) || (each.first === y && each.second === x));
  if (!found) { Plotly.purge("map-plot"); byId("map-plot").textContent = "Choose two different parameters."; return; }
  byId("map-plot").textContent = "";
  const turned = found.first !== x, means = found.means[m];
  const z = turned ? found.x.map((_, i) => found.y.map((_, j) => means[j][i])) : means;
  const fitted = (column, values) => (column.labels.length ? values.map((value) => column.labels[value]) : values);
  const trace = { type: "heatmap", x: fitted(P[x], turned ? found.y : found.x), y: fitted(P[y], turned ? found.x : found.y), z, colorscale: "Viridis", hoverongaps: false,
    colorbar: { title: { text: label(M[m]), side: "right" }, thickness: 14 }, hovertemplate: "%{x:.4g}, %{y:.4g}<br>%{z:.4g}<extra></extra>" };
  Plotly.react("map-plot", [trace], layout({ height: 460, xaxis: axis(label(P[x])), yaxis: axis(label(P[y])) }), config);
}

/* -- trade-offs -------------------------------------------------------------------------------- */
function front(x, y) {
  const sign = (k) => (M[k].better === "smaller" ? -1 : 1), a = cloud.metrics[x], b = cloud.metrics[y];
  const order = a.map((_, k) => k).sort((i, j) => sign(x) * (a[j] - a[i]) || sign(y) * (b[j] - b[i]));
  let best = -Infinity;
  return order.filter((k) => { const value = sign(y) * b[k]; if (value <= best) return false; best = value; return true; });
}
const about = (k) => P.map((column, p) => column.name + " = " + shown(column, cloud.parameters[p][k]));
function drawFront() {
  const x = chosen("front-x"), y = chosen("front-y"), c = chosen("front-colour"), columns = P.concat(M);
  const colour = c < P.length ? cloud.parameters[c] : cloud.metrics[c - P.length];
  const bar = { title: { text: label(columns[c]), side: "right" }, thickness: 14, ...(columns[c].labels.length ? { tickvals: columns[c].labels.map((_, k) => k), ticktext: columns[c].labels } : {}) };
  const ahead = front(x, y), wanted = (k) => (M[k].better === "smaller" ? " \u2190 better" : " better \u2192");
  const traces = [
    { type: "scattergl", mode: "markers", x: cloud.metrics[x], y: cloud.metrics[y], customdata: cloud.number, text: cloud.number.map((n, k) => "design " + n + "<br>" + about(k).join("<br>")),
      marker: { size: 6, color: colour, colorscale: "Viridis", opacity: 0.75, colorbar: bar }, hovertemplate: "%{text}<extra></extra>" },
    { type: "scatter", mode: "lines", x: ahead.map((k) => cloud.metrics[x][k]), y: ahead.map((k) => cloud.metrics[y][k]), line: { color: HOT, width: 2 }, hoverinfo: "skip" },
  ];
  if (M[x].name in data.base) traces.push({ type: "scatter", mode: "markers+text", x: [data.base[M[x].name]], y: [data.base[M[y].name]], text: ["base"], textposition: "top center", marker: { symbol: "diamond", size: 12, color: HOT }, hovertemplate: "base<extra></extra>" });
  Plotly.react("front-plot", traces, layout({ height: 520, xaxis: axis(label(M[x]) + wanted(x)), yaxis: axis(label(M[y]) + wanted(y)) }), config);
}
const command = (n) => data.command.replaceAll("{number}", String(n));

/* -- best designs ------------------------------------------------------------------------------ */
function drawBest() {
  const m = chosen("best-metric"), table = byId("best-table");
  table.textContent = "";
  const row = (cells, kind) => {
    const line = (table.tBodies[0] ?? table.createTBody()).insertRow();
    cells.forEach((cell) => {
      const place = document.createElement(kind);
      if (cell instanceof Node) place.append(cell); else place.innerHTML = cell;
      place.className = cell instanceof Node || kind === "th" ? "" : "number";
      line.append(place);
    });
  };
  const columns = [M[m], ...M.filter((_, k) => k !== m)];
  const values = (k) => columns.map((column) => text(cloud.metrics[M.indexOf(column)][k]));
  row(["design", "", ...columns.map(label), ...P.map((column) => short({ title: label(column) }))], "th");
  table.createTHead().append(table.rows[0]);
  if (Object.keys(data.base).length)
    row(["base", "", ...columns.map((column) => text(data.base[column.name])), ...P.map((column) => text(data.baseValues[column.name]))], "td");
  data.best[M[m].name].forEach((number) => {
    const k = cloud.number.indexOf(number), buttons = document.createElement("span");
    const save = document.createElement("button"), copy = document.createElement("button");
    save.textContent = "design file";
    save.addEventListener("click", () => {
      const link = document.createElement("a");
      link.href = URL.createObjectURL(new Blob([data.designs[number]], { type: "application/toml" }));
      link.download = "design-" + number + ".toml";
      link.click();
      URL.revokeObjectURL(link.href);
    });
    copy.textContent = "command";
    copy.addEventListener("click", () => {
      byId("copied").textContent = command(number);
      if (navigator.clipboard) navigator.clipboard.writeText(command(number)).catch(() => {});
    });
    buttons.style.whiteSpace = "nowrap";
    buttons.append(save, " ", copy);
    row([number, buttons, ...values(k), ...P.map((column, p) => shown(column, cloud.parameters[p][k]))], "td");
  });
  byId("caution").textContent = M[m].caution;
  byId("copied").textContent = command(data.best[M[m].name][0]);
}

/* -- level and phase --------------------------------------------------------------------------- */
function drawFamily() {
  const own = data.families[chosen("family")], traces = [];
  own.points.forEach((point, k) => {
    const share = own.points.length > 1 ? k / (own.points.length - 1) : 0;
    const colour = `hsl(${Math.round(210 + 190 * share) % 360}, 65%, ${Math.round(42 + 8 * Math.sin(Math.PI * share))}%)`;
    ["level", "phase"].forEach((kind, a) => traces.push({ type: "scatter", mode: "lines", x: own.frequency, y: own[kind][k], name: "point " + point, legendgroup: point, showlegend: a === 0,
      line: { color: colour, width: 1.8 }, xaxis: a ? "x2" : "x", yaxis: a ? "y2" : "y", hovertemplate: "point " + point + "<br>%{x:.4g} Hz: %{y:.4g}<extra></extra>" }));
  });
  Plotly.react("family-plot", traces, layout({ height: 430, grid: { rows: 1, columns: 2, pattern: "independent", xgap: 0.14 }, showlegend: true, legend: { font: { size: 11 } },
    xaxis: axis("frequency (Hz)"), xaxis2: axis("frequency (Hz)"), yaxis: axis("ILD, " + own.pair + " (dB)"), yaxis2: axis("IPD, " + own.pair + " (degrees)") }), config);
}

/* -- start ------------------------------------------------------------------------------------- */
document.querySelectorAll("[data-base]").forEach((cell) => { cell.textContent = text(data.baseValues[cell.dataset.base]); });
document.querySelectorAll("[data-base-metric]").forEach((cell) => { cell.textContent = text(data.base[cell.dataset.baseMetric]); });
const strongest = data.effects[0].map((own, p) => [own.share, p]).sort((a, b) => b[0] - a[0]).map((pair) => pair[1]);
fill("effect-metric", M, 0, drawEffects);
fill("map-metric", M, 0, drawMap);
fill("map-x", F, strongest[0], drawMap);
fill("map-y", F, strongest.length > 1 ? strongest[1] : 0, drawMap);
fill("front-x", M, 0, drawFront);
fill("front-y", M, Math.min(1, M.length - 1), drawFront);
fill("front-colour", P.concat(M), strongest[0], drawFront);
fill("best-metric", M, data.leading, drawBest);
data.families.forEach((own, k) => byId("family").add(new Option(own.title, k)));
byId("family").addEventListener("change", drawFamily);
const drawPlots = () => { drawEffects(); drawMap(); drawFront(); drawFamily(); };
drawPlots();
drawBest();
addEventListener("themechange", () => { colours(); drawPlots(); });
byId("front-plot").on("plotly_click", (event) => {
  const n = event.points[0].customdata;
  if (n === undefined) return;
  const k = cloud.number.indexOf(n);
  byId("picked").textContent = "design " + n + ": " + about(k).join(", ") + ". " + command(n);
});
