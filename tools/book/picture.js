// picture.js - draws the state after k steps as SVG.
//
// What the last step did is drawn in styles that differ in more than colour: new edges
// are thick, edges that have gone are dashed, what the step speaks of lies on a broad
// band. What is drawn is rounded, and decides nothing.
"use strict";

const WIDTH = 480, MARGIN = 40, DISC = 11; // in the units of the picture

// ---- Where things are drawn. ----

// A power of two about as large as the largest coordinate. To divide by it is exact, and
// no difference of quotients is too large for a double.
function scaleOf(points) {
  const largest = Math.max(0, ...points.flat().map(Math.abs));
  return largest === 0 ? 1 : 2 ** Math.floor(Math.log2(largest));
}

// The least value, and how far the others go beyond it.
function rangeOf(values) {
  const least = Math.min(...values);
  return values.length === 0 ? { least: 0, size: 0 }
    : { least, size: Math.max(...values) - least };
}

// The place of each point, y down, and the height of the picture. x and y are enlarged
// alike, so circles stay round.
function layoutOf(points) {
  const scale = scaleOf(points);
  const xs = points.map(([x]) => x / scale), ys = points.map(([, y]) => y / scale);
  const across = rangeOf(xs), up = rangeOf(ys);
  const unit = (WIDTH - 2 * MARGIN) / (Math.max(across.size, up.size) || 1);
  const height = Math.max(WIDTH / 2, up.size * unit + 2 * MARGIN);
  const places = xs.map((x, i) => ({
    x: WIDTH / 2 + (x - across.least - across.size / 2) * unit,
    y: height / 2 - (ys[i] - up.least - up.size / 2) * unit,
  }));
  return { height, places };
}

// The circle through three places; null if it is as good as a line.
function circleThrough(a, b, c) {
  const bx = b.x - a.x, by = b.y - a.y, cx = c.x - a.x, cy = c.y - a.y;
  const twice = 2 * (bx * cy - by * cx);
  const x = (cy * (bx * bx + by * by) - by * (cx * cx + cy * cy)) / twice;
  const y = (bx * (cx * cx + cy * cy) - cx * (bx * bx + by * by)) / twice;
  const radius = Math.hypot(x, y);
  return radius < 20 * WIDTH ? { x: a.x + x, y: a.y + y, radius } : null;
}

// ---- The elements of a picture. ----

function svgElement(name, attributes, text) {
  const element = document.createElementNS("http://www.w3.org/2000/svg", name);
  for (const [key, value] of Object.entries(attributes))
    element.setAttribute(key, typeof value === "number" ? +value.toFixed(2) : value);
  if (text !== undefined) element.textContent = text;
  return element;
}

const lineFrom = (a, b, style) =>
  svgElement("line", { class: style, x1: a.x, y1: a.y, x2: b.x, y2: b.y });

// The edge "a-b"; its name goes with it.
function edgeOf(places, name, style) {
  const [a, b] = name.split("-");
  const line = lineFrom(places[a], places[b], style);
  line.dataset.edge = name;
  return line;
}

const triangleOf = (corners, style) =>
  svgElement("polygon", { class: style, points: corners.map((p) =>
    `${p.x.toFixed(2)},${p.y.toFixed(2)}`).join(" ") });

function circleOf(corners, style) {
  const circle = circleThrough(...corners);
  return circle ? svgElement("circle",
    { class: style, cx: circle.x, cy: circle.y, r: circle.radius })
    : lineFrom(corners[0], corners[1], style);
}

// A point: a disc with its number, dashed until it is a vertex.
function discOf(place, number, style) {
  const group = svgElement("g", { class: style });
  group.append(svgElement("circle", { cx: place.x, cy: place.y, r: DISC }),
    svgElement("text", { x: place.x, y: place.y }, number));
  return group;
}

// ---- The picture. ----

// What there is after k steps, and what the k-th of them did (nothing, if `plain`).
function drawState(svg, trace, layout, k, plain) {
  const { height, places } = layout;
  const state = stateAfter(trace, k);
  const step = plain || k === 0 ? {} : trace.steps[k - 1];
  const added = new Set((step.add ?? []).map(nameOf));

  const below = [], edges = [], discs = [];
  const triangles = (step.visits ?? []).filter((corners) => corners.length === 3);
  if (step.triangle) triangles.push(step.triangle);
  for (const corners of triangles)
    below.push(triangleOf(corners.map((p) => places[p]), "triangle"));
  if (step.circle) below.push(circleOf(step.circle.map((p) => places[p]), "circle"));
  for (const edge of [...step.edges ?? [], ...step.push ?? []])
    below.push(edgeOf(places, nameOf(edge), "mark"));
  for (const name of state.edges)
    edges.push(edgeOf(places, name, added.has(name) ? "edge new" : "edge"));
  for (const edge of step.remove ?? [])
    edges.push(edgeOf(places, nameOf(edge), "edge gone"));
  const here = [step.point, ...step.insert ?? [], ...(step.moves ?? []).map(([p]) => p)];
  places.forEach((place, point) => {
    const style = ["point", state.vertices.has(point) ? "vertex" : "waiting"];
    if (here.includes(point)) style.push("here");
    discs.unshift(discOf(place, point, style.join(" "))); // copies lie below the first
  });

  svg.setAttribute("viewBox", `0 0 ${WIDTH} ${height.toFixed(2)}`);
  svg.replaceChildren(...below, ...edges, ...discs);
}

// Each edge can be chosen: it gets a broad invisible line that can be clicked, and has
// its turn when the student goes on with Tab.
function drawChoices(svg, layout, edges) {
  for (const name of edges) {
    const choice = edgeOf(layout.places, name, "choice");
    choice.setAttribute("tabindex", 0);
    choice.setAttribute("role", "button");
    choice.setAttribute("aria-label", `edge ${name}`);
    svg.insertBefore(choice, svg.querySelector(".point"));
  }
}
