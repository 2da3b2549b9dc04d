// measure.js - opens the pages one after the other in a frame as wide as a phone, and
// writes down what is wider. `pages` and `book` are given by check_book.sh.
const frame = document.createElement("iframe");
const report = document.createElement("pre");
frame.style.cssText = "width: 390px; height: 844px; border: 0";
document.documentElement.append(frame, report);

let measured = 0;
const widest = (root) => [...root.querySelectorAll("main *")].find(
  (element) => element.getBoundingClientRect().right > 390 && !element.closest("pre, .table"));

frame.onload = () => {
  const root = frame.contentDocument.documentElement;
  if (root.scrollWidth > 390) {
    const culprit = widest(root);
    report.append(`\nwide: ${pages[measured]}: ${root.scrollWidth} pixels, because of ` +
      (culprit ? culprit.outerHTML.slice(0, 80).replace(/\n/g, " ") : "its frame"));
  }
  measured++;
  if (measured < pages.length) frame.src = book + pages[measured];
  else report.append(`\nmeasured: ${measured}\n`);
};
frame.src = book + pages[0];
