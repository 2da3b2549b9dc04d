// check_player.js - presses the buttons of every player on this page, and looks.
//
// Each player says in data-name what it shows, and in data-edges the edges of the
// triangulation, which the program tri has told in another way. check_player.sh makes the
// page and reads the report: a line for each sentence, which holds for all players to
// which it applies, or names one for which it does not. `book` and `pages` are the folder
// of the book and its pages with players.
"use strict";

const sentences = new Map(); // sentence -> { players, failure }

// The sentence holds for this player, or `seen` is what was seen instead.
function expect(sentence, player, holds, seen) {
  if (!sentences.has(sentence)) sentences.set(sentence, { players: new Set() });
  const entry = sentences.get(sentence);
  entry.players.add(player.name);
  if (!holds) entry.failure ??= `${player.name}: ${seen}`;
}

// What can be seen of a player, and pressed.
function playerIn(root) {
  const find = (selector) => root.querySelector(selector);
  const all = (selector) => [...root.querySelectorAll(selector)];
  return {
    root, find, all,
    name: root.dataset.name,
    expected: root.dataset.edges.split(" ").filter((edge) => edge !== "").sort().join(" "),
    trace: JSON.parse(find("script").textContent),
    press: (name) => find(`[data-go=${name}]`).click(),
    key: (key, target = root) => target.dispatchEvent(
      new KeyboardEvent("keydown", { key, bubbles: true, cancelable: true })),
    scrubTo(k) {
      find(".scrub input").value = k;
      find(".scrub input").dispatchEvent(new Event("input", { bubbles: true }));
    },
    position: () => Number(find("output").textContent.match(/^step (\d+) of \d+$/)[1]),
    sentence: () => find(".say").textContent,
    stack: () => all(".stack li").map((item) => item.textContent),
    lit: () => all(".figure [aria-current=step]").map((item) => item.dataset.line),
    drawn: (style) => all(`.stage .edge${style}`).map((line) => line.dataset.edge)
      .sort().join(" "),
    // All that depends on the step.
    looks: () => [".stage", ".say", ".figure", ".stack", "output"]
      .map((selector) => find(selector).innerHTML).join("\n"),
  };
}

const namesOf = (edges) => (edges ?? []).map(([a, b]) => `${a}-${b}`).sort().join(" ");

// ---- Each step, as it is reached with Forward. ----

function checkStep(player, k) {
  const step = player.trace.steps[k - 1];
  const lit = player.lit().join(" ");
  expect("the sentence is that of the step, and is read out", player,
    player.sentence() === step.say && player.find(".say[aria-live=polite]"),
    `step ${k}: "${player.sentence()}"`);
  expect("the line of the step is lit, and no other one", player, lit === step.line,
    `step ${k}: "${lit}", not "${step.line}"`);
  expect("what appears is thick, what goes is dashed", player,
    player.drawn(".new") === namesOf(step.add) &&
    player.drawn(".gone") === namesOf(step.remove),
    `step ${k}: new ${player.drawn(".new")}, gone ${player.drawn(".gone")}`);
}

// Discs lie in the picture, and each edge begins and ends at its points.
function checkPlaces(player, k) {
  const [, , width, height] = player.find(".stage svg").getAttribute("viewBox").split(" ");
  const place = new Map(player.all(".stage .point").map((disc) =>
    [disc.textContent, disc.querySelector("circle")]));
  const isInside = (disc) => disc.getAttribute("cx") > 0 && disc.getAttribute("cy") > 0 &&
    disc.getAttribute("cx") < Number(width) && disc.getAttribute("cy") < Number(height);
  expect("all points lie in the picture", player,
    place.size === player.trace.points.length && [...place.values()].every(isInside),
    `step ${k}: not all of ${player.trace.points.length} points`);
  for (const line of player.all(".stage .edge")) {
    const [a, b] = line.dataset.edge.split("-").map((point) => place.get(point));
    expect("edges are drawn from point to point", player,
      line.getAttribute("x1") === a.getAttribute("cx") &&
      line.getAttribute("y1") === a.getAttribute("cy") &&
      line.getAttribute("x2") === b.getAttribute("cx") &&
      line.getAttribute("y2") === b.getAttribute("cy"), `step ${k}: ${line.outerHTML}`);
  }
  expect("every number of the picture is finite", player,
    !/NaN|Infinity|undefined/.test(player.find(".stage").innerHTML), `step ${k}`);
}

// At the end a point that is no vertex lies under one at the same place.
function checkCopies(player) {
  const discs = player.all(".stage .point");
  const at = (disc) => ["cx", "cy"].map((c) => disc.firstChild.getAttribute(c)).join(" ");
  const hidden = discs.filter((disc) => disc.matches(".waiting")).every((copy) =>
    discs.slice(discs.indexOf(copy)).some((disc) =>
      disc.matches(".vertex") && at(disc) === at(copy)));
  expect("of points at one place the vertex is seen", player,
    hidden || player.trace.steps.length === 0, discs.map(at).join(", "));
}

// What is taken from the stack was on top of it; above is what was there before.
function checkStack(player, k, before) {
  const { pop, push } = player.trace.steps[k - 1];
  const left = (pop ?? []).length;
  expect("what is taken from the stack lay on top, and what is put there does", player,
    before.slice(0, left).sort().join(" ") === namesOf(pop) &&
    player.stack().slice(0, (push ?? []).length).sort().join(" ") === namesOf(push) &&
    player.stack().length === before.length - left + (push ?? []).length,
    `step ${k}: ${before.join(" ")} became ${player.stack().join(" ")}`);
  const edges = player.drawn(":not(.gone)").split(" ");
  expect("only edges that are there are on the stack", player,
    player.stack().every((edge) => edges.includes(edge)),
    `step ${k}: ${player.stack().join(" ")}`);
}

// ---- Going through it. ----

function checkWays(player) {
  const end = player.trace.steps.length, forward = [player.looks()];
  const sameAs = (k) => player.looks() === forward[k] && player.position() === k;
  expect("before the first step there is no edge and no line is lit", player,
    player.drawn("") === "" && player.lit().length === 0 && player.position() === 0,
    player.drawn(""));
  for (let k = 1; k <= end; k++) {
    const stack = player.stack();
    player.press("forward");
    forward.push(player.looks());
    checkStep(player, k);
    checkPlaces(player, k);
    checkStack(player, k, stack);
  }
  expect("forward to the end gives the edges of the triangulation", player,
    player.drawn(":not(.gone)") === player.expected && sameAs(end),
    `step ${player.position()}: ${player.drawn(":not(.gone)")}, not ${player.expected}`);
  checkCopies(player);
  const everyStep = (go) => forward.every((_, i) => (go(i), sameAs(i)));
  expect("the scrubber leads to the same as Forward", player,
    everyStep((k) => player.scrubTo(k)), `at step ${player.position()}`);
  player.press("forward");
  let back = sameAs(end);
  for (let k = end - 1; k >= 0; k--) {
    player.press("back");
    back &&= sameAs(k);
  }
  player.press("back");
  expect("Back leads through the same steps to the beginning", player,
    back && sameAs(0) && player.drawn("") === "", player.drawn(""));
  player.press("forward");
  expect("beyond the ends there is nothing", player, back && sameAs(Math.min(1, end)),
    `step ${player.position()}`);
  player.press("last");
  expect("Last and First lead to the ends", player,
    sameAs(end) && (player.press("first"), sameAs(0)), `step ${player.position()}`);
}

function checkKeys(player) {
  const end = player.trace.steps.length;
  const leads = (key, k, target) => {
    player.key(key, target);
    expect("the keys →, ←, End and Home do what the buttons do", player,
      player.position() === k, `${key} leads to step ${player.position()}, not ${k}`);
  };
  leads("ArrowRight", Math.min(1, end));
  leads("ArrowRight", Math.min(2, end), player.find(".scrub input"));
  leads("ArrowLeft", Math.min(2, end) - Math.min(1, end), player.find("button"));
  leads("End", end);
  leads("Home", 0);
  player.root.focus();
  expect("a player can have the focus, and one sees that it has", player,
    document.activeElement === player.root &&
    parseFloat(getComputedStyle(player.root).outlineWidth) >= 2,
    `${document.activeElement.tagName}, ${getComputedStyle(player.root).outline}`);
}

// ---- Predict before you step. ----

// Steps forward until a question is open, or the end.
function toNextQuestion(player) {
  const end = player.trace.steps.length;
  while (player.all(".choice").length === 0 && player.position() < end)
    player.press("forward");
  return player.all(".choice").length > 0;
}

function checkPredictions(player) {
  const flips = player.trace.steps.filter((step) =>
    step.event === "flip" && (step.remove ?? []).length > 0);
  const toggle = player.find(".predict input");
  const press = (choice) => choice.dispatchEvent(new Event("click", { bubbles: true }));
  player.press("first");
  expect("prediction is offered if there are flips", player,
    player.find(".predict").hidden === (flips.length === 0), "");
  if (flips.length === 0) return;
  toggle.click();
  let asked = 0, right = 0;
  while (toNextQuestion(player)) {
    const flip = flips[asked], answer = namesOf(flip.remove);
    const choices = player.all(".choice");
    const names = choices.map((choice) => choice.dataset.edge).sort().join(" ");
    expect("it asks before each flip, about the edges that are there", player,
      names === player.drawn("") && names.split(" ").includes(answer) &&
      player.sentence().includes("?") && player.lit().length === 0, names);
    expect("it asks while the answer still lies on the stack", player,
      !player.trace.steps.some((step) => step.push) || player.stack().includes(answer),
      `${answer} at step ${player.position()}`);
    choices[0].focus();
    expect("while it asks the edges can be reached and have names", player,
      document.activeElement === choices[0] &&
      choices.every((choice) => choice.getAttribute("aria-label") ===
        `edge ${choice.dataset.edge}` && choice.getAttribute("role") === "button"),
      choices[0].outerHTML);
    const correct = choices.find((choice) => choice.dataset.edge === answer);
    if (asked % 3 === 1) {
      const at = player.position(), { steps } = player.trace;
      const between = steps.slice(at, steps.indexOf(flip));
      for (const wrong of choices.filter((choice) => choice !== correct)) {
        const { edge } = wrong.dataset;
        const kept = between.find(({ event }, i) =>
          event === "keep" && namesOf(between[i - 1]?.pop) === edge);
        press(wrong);
        expect("a wrong answer is judged, and the step stays", player,
          player.sentence().startsWith(`No: ${edge} `) && player.position() === at &&
          player.sentence().includes(kept ? kept.say : ""), player.sentence());
        expect("what is said to be on the stack is there", player,
          kept || player.sentence().includes(" is on the stack") ===
            player.stack().includes(edge), player.sentence());
      }
    }
    if (asked % 3 === 2) player.press("forward");
    else if (asked % 3 === 1) press(correct);
    else player.key("Enter", correct);
    expect("a right answer goes on to the flip; Forward tells", player,
      player.sentence().endsWith(flip.say) && player.drawn(".gone") === answer &&
      player.sentence().startsWith(asked % 3 === 2 ? `It is ${answer}:` : "Right:"),
      player.sentence());
    right += asked % 3 === 0;
    asked++;
    expect("the first answer to each question counts", player,
      player.find(".score").textContent === `${right} of ${asked} predicted`,
      player.find(".score").textContent);
  }
  expect("it asks about every flip", player, asked === flips.length,
    `${asked} of ${flips.length}`);
  expect("no choice is left when the questions are over", player,
    player.position() === player.trace.steps.length &&
    player.drawn(":not(.gone)") === player.expected, "");
  toggle.click();
}

// ---- Play; all at the same time. ----

async function checkPlaying(players) {
  const later = (milliseconds) => new Promise((done) => setTimeout(done, milliseconds));
  const isPlaying = (player) => player.find("[data-go=play]").textContent === "Pause";
  for (const player of players) {
    player.press("first");
    player.find("select").value = "500";
    player.key(" ");
  }
  await later(800);
  for (const player of players) {
    const end = player.trace.steps.length;
    expect("Space plays, a step at a time", player, player.position() === Math.min(2, end),
      `step ${player.position()} after two moments`);
    if (end <= 2) continue;
    player.key(" ");
    expect("Space again pauses", player, !isPlaying(player), "it plays");
  }
  await later(2000);
  for (const player of players) {
    const end = player.trace.steps.length;
    expect("Space again pauses", player, player.position() === Math.min(2, end),
      `step ${player.position()}`);
    player.press("play");
  }
  const longest = Math.max(...players.map((player) => player.trace.steps.length));
  await later(500 * (longest + 2));
  for (const player of players)
    expect("Play ends at the last step", player,
      player.position() === player.trace.steps.length && !isPlaying(player),
      `step ${player.position()}`);
}

// ---- On paper. ----

// Puts the rules for paper into force on the screen.
function checkPaper(players) {
  const paper = document.createElement("style");
  for (const { media, cssRules } of [...document.styleSheets].flatMap((s) => [...s.cssRules]))
    if (media?.mediaText === "print")
      paper.append(...[...cssRules].map((rule) => rule.cssText));
  document.head.append(paper);
  for (const player of players) {
    const visible = [...player.root.children].filter((part) => part.offsetHeight > 0);
    const edges = player.all(".printed svg:last-child .edge");
    expect("on paper there are two pictures, and no buttons", player,
      visible.length === 1 && visible[0].matches(".printed") &&
      player.all(".printed svg").length === 2 && player.expected ===
        edges.map((line) => line.dataset.edge).sort().join(" "),
      visible.map((part) => part.className).join(" "));
  }
  paper.remove();
}

// ---- On a phone. ----

// Opens a page of the book in a frame 360 pixels wide.
function openPage(path) {
  return new Promise((done) => {
    const frame = document.createElement("iframe");
    frame.style.cssText = "width: 360px; height: 740px; border: 0";
    frame.onload = () => done(frame);
    frame.src = book + path;
    document.body.append(frame);
  });
}

async function checkPages() {
  for (const path of pages) {
    const frame = await openPage(path), page = frame.contentDocument;
    const widest = page.documentElement.scrollWidth;
    const players = [...page.querySelectorAll(".player")];
    expect("a page with players fits on a phone 360 pixels wide", { name: path },
      players.length > 0 && widest <= 360, `${widest} pixels, ${players.length} players`);
    for (const player of players) {
      const picture = player.querySelector(".stage svg").getBoundingClientRect();
      const last = player.querySelector("[data-go=last]").getBoundingClientRect();
      expect("there, picture, sentence and buttons are on the screen at once", { name: path },
        picture.width >= 280 && picture.height >= 140 && last.right <= 360 &&
        last.bottom - picture.top <= 740, `${picture.width} x ${picture.height} pixels, ` +
        `buttons ${last.bottom - picture.top} pixels below its top`);
      expect("on a page the player stands at step 0", { name: path },
        player.querySelector("output").textContent.startsWith("step 0 of "),
        player.querySelector("output").textContent);
    }
    frame.remove();
  }
}

// ---- All players, and the report. ----

function checkCalm(player) {
  const moves = player.all("*").filter((element) => {
    const style = getComputedStyle(element);
    return style.animationName !== "none" || !/^(0s(, )?)+$/.test(style.transitionDuration);
  });
  expect("nothing is animated", player, moves.length === 0, moves[0]?.outerHTML);
}

async function checkAll() {
  const players = [...document.querySelectorAll(".player")].map(playerIn);
  for (const player of players) {
    checkWays(player);
    checkKeys(player);
    checkPredictions(player);
    checkCalm(player);
  }
  await checkPlaying(players);
  checkPaper(players);
  await checkPages();
  const report = document.createElement("pre");
  for (const [sentence, { players, failure }] of sentences)
    report.append(failure ? `\nnot ok - player: ${sentence}\n  ${failure}`
      : `\nok     - player: ${sentence} (${players.size} seen)`);
  report.append("\nplayers were checked\n");
  document.body.replaceChildren(report);
}

checkAll();
