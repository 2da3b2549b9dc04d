// steps.js - what there is after k steps of an algorithm. No picture, no buttons:
// picture.js draws it, player.js goes from step to step.
//
// A trace (docs/trace.md) is a list of steps. Each step says which edges vanish and
// which appear, what is put on the stack and taken from it, and which points become
// vertices. So what there is after k steps follows from the first k steps alone; to go
// back is to begin again and to stop earlier.
"use strict";

// The edge between points a and b is called "a-b"; a is the smaller number.
const nameOf = ([a, b]) => `${a}-${b}`;

// ---- The state after k steps. ----

// Before the first step.
function emptyState() {
  return { edges: new Set(), stack: [], vertices: new Set() };
}

// The top of the stack is the end of the array. A flip turns half-edges, and so an entry
// of the stack may be another edge afterwards (page 3.5, erratum E35).
function applyStep(state, step) {
  for (const edge of step.remove ?? []) state.edges.delete(nameOf(edge));
  for (const edge of step.add ?? []) state.edges.add(nameOf(edge));
  for (const edge of step.pop ?? []) state.stack.pop();
  for (const [entry, a, b] of step.turned ?? []) state.stack[entry] = nameOf([a, b]);
  for (const edge of step.push ?? []) state.stack.push(nameOf(edge));
  for (const point of step.insert ?? []) state.vertices.add(point);
}

function stateAfter(trace, k) {
  const state = emptyState();
  for (const step of trace.steps.slice(0, k)) applyStep(state, step);
  return state;
}

// ---- Predict before you step. ----

// Taking an edge from the stack changes no edge, and would give the answer away.
const changesNoEdge = (step) => step.event === "pop" || step.event === "keep";

// The flips to be predicted: step `flip` replaces `edge`, and nothing but looking at
// edges happens from the moment `at` on. So this is when to ask.
function questionsOf(trace) {
  const questions = [];
  trace.steps.forEach((step, flip) => {
    if (step.event !== "flip" || (step.remove ?? []).length === 0) return;
    let at = flip;
    while (at > 0 && changesNoEdge(trace.steps[at - 1])) at--;
    questions.push({ at, flip, edge: nameOf(step.remove[0]) });
  });
  return questions;
}

const speaksOf = (edges, name) => (edges ?? []).some((edge) => nameOf(edge) === name);

// Why the edge `guess`, which is not the answer, is not the next to flip.
function whyNot(trace, question, guess) {
  const { at, flip } = question, { steps } = trace;
  const popped = steps.slice(at, flip).findIndex((step) => speaksOf(step.pop, guess));
  if (popped >= 0) // and the next step says that it stays
    return `${steps[at + popped + 1].say}. It comes off the stack before the next flip.`;
  if (stateAfter(trace, at).stack.includes(guess))
    return `${guess} is on the stack, but something else lies above it.`;
  if (steps.some((step) => step.push))
    return `${guess} is not on the stack, so it is not looked at.`;
  return steps.slice(flip).some((step) => speaksOf(step.remove, guess))
    ? `${guess} will go, but not yet.` : `${guess} stays to the end.`;
}
