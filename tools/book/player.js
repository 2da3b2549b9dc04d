// player.js - goes through a trace step by step: a picture, a sentence, the lines of the
// figure, the stack, and buttons.
//
// A page has <div class="player"> with the trace (docs/trace.md) in a <script
// type="application/json">. steps.js says what there is after k steps, picture.js draws
// it; here is what depends on the moment: k, the clock, and the question that is open.
// Nothing moves unless somebody presses Play, and then a whole step at a time.
"use strict";

const SKELETON = `
  <div class="stage"><svg class="picture"></svg></div>
  <p class="say" aria-live="polite"></p>
  <div class="controls">
    <div class="buttons">
      <button type="button" data-go="first">First</button>
      <button type="button" data-go="back">Back</button>
      <button type="button" data-go="play">Play</button>
      <button type="button" data-go="forward">Forward</button>
      <button type="button" data-go="last">Last</button>
    </div>
    <label class="scrub"><input type="range" min="0" step="1" aria-label="Step">
      <output></output></label>
    <div class="options">
      <label>Speed <select>
        <option value="3000">slow</option>
        <option value="1500" selected>normal</option>
        <option value="500">fast</option>
      </select></label>
      <label class="predict"><input type="checkbox"> Predict before you step</label>
      <span class="score" aria-live="polite"></span>
    </div>
  </div>
  <div class="beside">
    <div class="figure"><p class="title"></p><ol></ol></div>
    <div class="stack"><p class="title">Stack, top first</p><ol></ol></div>
    <p class="key"></p>
  </div>
  <div class="printed" aria-hidden="true">
    <svg class="picture"></svg><svg class="picture"></svg>
  </div>`;

// What the styles of lines mean, for those that the trace needs.
function keyTo(trace) {
  const meanings = [
    ["edge new", "new", (step) => step.add?.length > 0],
    ["edge gone", "gone", (step) => step.remove?.length > 0],
    ["mark", "looked at", (step) => step.edges || step.push],
    ["circle", "circle", (step) => step.circle],
  ];
  return meanings.filter(([, , isIn]) => trace.steps.some(isIn)).map(([style, meaning]) =>
    `<span><svg class="picture" viewBox="0 0 34 14"><line class="${style}"
      x1="6" x2="28" y1="7" y2="7"/></svg> ${meaning}</span>`).join(" ");
}

function htmlElement(name, text) {
  const element = document.createElement(name);
  if (text !== undefined) element.textContent = text;
  return element;
}

function makePlayer(root) {
  const trace = JSON.parse(root.querySelector("script").textContent);
  const layout = layoutOf(trace.points);
  const questions = questionsOf(trace);
  const end = trace.steps.length;
  root.insertAdjacentHTML("beforeend", SKELETON);
  const find = (selector) => root.querySelector(selector);
  const svg = find(".stage svg"), scrub = find(".scrub input");
  const speed = find("select"), predict = find(".predict input");

  let k = 0;               // so many steps have been done
  let clock = null;        // set while it plays
  let open = null;         // the question that waits for an answer
  let answers = new Map(); // step of a flip -> was the first answer right?

  // ---- What is shown. ----

  function say(sentence) {
    find(".say").textContent = sentence;
  }

  function showLine() {
    const line = k === 0 || open ? "" : trace.steps[k - 1].line;
    for (const item of root.querySelectorAll(".figure li"))
      if (item.dataset.line === line) item.setAttribute("aria-current", "step");
      else item.removeAttribute("aria-current");
  }

  function showStack() {
    const entries = stateAfter(trace, k).stack.reverse();
    find(".stack ol").replaceChildren(...entries.map((name) => htmlElement("li", name)));
  }

  function showPicture() {
    const focused = svg.contains(document.activeElement);
    drawState(svg, trace, layout, k, open !== null);
    if (open) drawChoices(svg, layout, stateAfter(trace, k).edges);
    svg.setAttribute("role", open ? "group" : "img");
    svg.setAttribute("aria-label", `The points and edges after ${k} of ${end} steps`);
    if (focused) root.focus(); // what had the focus is no longer there
  }

  function show() {
    showPicture();
    showLine();
    showStack();
    scrub.value = k;
    scrub.setAttribute("aria-valuetext", `step ${k} of ${end}`);
    find("output").textContent = `step ${k} of ${end}`;
  }

  function showScore() {
    const right = [...answers.values()].filter((first) => first).length;
    find(".score").textContent =
      answers.size > 0 ? `${right} of ${answers.size} predicted` : "";
  }

  // ---- From step to step. ----

  function goTo(step) {
    k = Math.min(Math.max(step, 0), end);
    open = null;
    show();
    say(k > 0 ? trace.steps[k - 1].say : `${trace.points.length} points, no edge yet.`);
  }

  function forward() {
    const next = questions.find(({ at, flip }) => at === k && !answers.has(flip));
    if (open) answer(null);
    else if (next && predict.checked) ask(next);
    else goTo(k + 1);
  }

  function stop() {
    clearTimeout(clock);
    clock = null;
    find("[data-go=play]").textContent = "Play";
  }

  function tick() {
    forward();
    if (k === end || open) stop();
    else clock = setTimeout(tick, speed.value);
  }

  function playOrPause() {
    if (clock !== null) return stop();
    if (k === end) goTo(0);
    find("[data-go=play]").textContent = "Pause";
    clock = setTimeout(tick, 0);
  }

  // ---- Predict before you step. ----

  function ask(question) {
    open = question;
    show();
    if (root.contains(document.activeElement)) root.focus(); // Tab now leads to the edges
    const flips = (trace.steps[question.flip].add ?? []).length > 0;
    say(`Which edge ${flips ? "flips" : "is taken away"} next? Click it, or go there ` +
      "with Tab and press Enter. Forward tells.");
  }

  // The student points at an edge, or gives up (null). The first answer counts.
  function answer(edge) {
    const { flip, edge: next } = open, right = edge === next;
    if (!answers.has(flip)) answers.set(flip, right);
    showScore();
    if (edge !== null && !right) {
      say(`No: ${whyNot(trace, open, edge)} Another one?`);
    } else {
      goTo(flip + 1);
      say(`${right ? "Right" : `It is ${next}`}: ${trace.steps[flip].say}`);
    }
  }

  // ---- What people press. ----

  const go = {
    first: () => goTo(0),
    back: () => goTo(k - 1),
    forward,
    last: () => goTo(end),
  };
  const keys = {
    Home: go.first,
    ArrowLeft: go.back,
    " ": playOrPause,
    ArrowRight: go.forward,
    End: go.last,
  };

  root.addEventListener("click", (event) => {
    const button = event.target.closest("button"), choice = event.target.closest(".choice");
    if (choice) return answer(choice.dataset.edge);
    if (!button) return;
    if (button.dataset.go === "play") return playOrPause();
    stop();
    go[button.dataset.go]();
  });

  root.addEventListener("keydown", (event) => {
    const { key, target } = event;
    if (event.altKey || event.ctrlKey || event.metaKey) return;
    if (target.matches(".choice") && (key === "Enter" || key === " ")) {
      event.preventDefault();
      return answer(target.dataset.edge);
    }
    if (!(key in keys) || target.matches("select")) return;
    if (key === " " && target.matches("button, input[type=checkbox]")) return;
    event.preventDefault();
    if (key !== " ") stop();
    keys[key]();
  });

  scrub.addEventListener("input", () => {
    stop();
    goTo(Number(scrub.value));
  });

  predict.addEventListener("change", () => {
    answers = new Map();
    showScore();
    goTo(k);
  });

  // ---- The beginning. ----

  for (const { label, text } of trace.figure.lines) {
    const item = htmlElement("li");
    item.dataset.line = label;
    const words = htmlElement("span", text.trimStart());
    words.style.paddingLeft = `${(text.length - text.trimStart().length) / 2}em`;
    item.append(htmlElement("b", label), " ", words);
    find(".figure ol").append(item);
  }
  find(".figure .title").textContent = trace.figure.name;
  find(".key").innerHTML = keyTo(trace);
  find(".stack").hidden = !trace.steps.some((step) => step.push);
  find(".predict").hidden = questions.length === 0;
  scrub.max = end;
  root.tabIndex = 0;
  root.setAttribute("role", "group");
  root.setAttribute("aria-label", `${trace.figure.name}, step by step`);
  const [first, final] = root.querySelectorAll(".printed svg"); // on paper nothing moves
  drawState(first, trace, layout, 0, true);
  drawState(final, trace, layout, end, true);
  goTo(0);
}

document.querySelectorAll(".player").forEach(makePlayer);
