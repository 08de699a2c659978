// Elements from plain values. Text only ever becomes text nodes: nothing a study says can be markup.

/** h("p", { class: "lead", onclick: f }, "text", child, [more]) */
export function h(tag, properties = {}, ...children) {
  const element = document.createElement(tag);
  for (const [name, value] of Object.entries(properties)) {
    if (value === undefined || value === null || value === false) continue;
    if (name.startsWith("on")) element.addEventListener(name.slice(2), value);
    else if (name === "style") element.style.cssText = value;
    else element.setAttribute(name, value === true ? "" : String(value));
  }
  element.append(...children.flat(Infinity).filter((child) => child !== null && child !== undefined && child !== false));
  return element;
}

const SVG = "http://www.w3.org/2000/svg";

export function svg(tag, properties = {}, ...children) {
  const element = document.createElementNS(SVG, tag);
  for (const [name, value] of Object.entries(properties)) {
    if (value !== undefined && value !== null) element.setAttribute(name, String(value));
  }
  element.append(...children.flat(Infinity).filter((child) => child !== null && child !== undefined));
  return element;
}

let count = 0;
export function freshId(stem) {
  count += 1;
  return `${stem}-${count}`;
}

/** A labelled select. options: [{ value, label, group }] */
export function select(label, options, chosen, onchange) {
  const id = freshId("choice");
  const groups = new Map();
  const box = h("select", { id, onchange: () => onchange(box.value) });
  for (const option of options) {
    const element = h("option", { value: option.value }, option.label);
    element.selected = option.value === chosen;
    if (option.group === undefined) {
      box.append(element);
      continue;
    }
    if (!groups.has(option.group)) {
      groups.set(option.group, h("optgroup", { label: option.group }));
      box.append(groups.get(option.group));
    }
    groups.get(option.group).append(element);
  }
  return h("span", { class: "choice" }, h("label", { for: id }, label), box);
}

/** Says by classes where a box that scrolls sideways has more to show; the style sheet draws it. */
export function showsItsOverflow(box) {
  const look = () => {
    box.classList.toggle("more-before", box.scrollLeft > 4);
    box.classList.toggle("more-behind", box.scrollLeft + box.clientWidth < box.scrollWidth - 4);
  };
  box.addEventListener("scroll", look, { passive: true });
  const observer = new ResizeObserver(look);
  observer.observe(box);
  for (const child of box.children) observer.observe(child);
  return box;
}

/** So wide is a sheet of A4 between its margins (style.css), in px. */
const SHEET_PX = 680;
const PRINT_LEAST = 0.4;

/** Paper does not scroll: what is wider than a sheet is printed smaller. */
function fitsOnPaper(box) {
  window.addEventListener("beforeprint", () => { for (const child of box.children) child.style.zoom = String(Math.max(PRINT_LEAST, Math.min(1, SHEET_PX / Math.max(1, child.scrollWidth)))); });
  window.addEventListener("afterprint", () => { for (const child of box.children) child.style.zoom = ""; });
}

/** A table or picture that may be wider than the page: it scrolls inside its own box, and says so. */
export function scrollBox(name, ...children) {
  const box = showsItsOverflow(h("div", { class: "scroll", tabindex: "0", role: "region", "aria-label": name }, children));
  fitsOnPaper(box);
  return h("div", { class: "scroll-frame" }, box, h("p", { class: "scroll-hint", "aria-hidden": "true" }, "Scrolls sideways →"));
}

let speaker;
let hush;

/** A short message at the edge of the window, read aloud. */
export function say(message) {
  if (!speaker) {
    speaker = h("div", { class: "toast", role: "status", "aria-live": "polite" });
    document.body.append(speaker);
  }
  speaker.textContent = message;
  speaker.classList.add("shown");
  clearTimeout(hush);
  hush = setTimeout(() => speaker.classList.remove("shown"), 2200);
}

function copyByHand(text) {
  const box = h("textarea", { "aria-hidden": "true", style: "position:fixed;left:-99em" });
  box.value = text;
  document.body.append(box);
  box.select();
  const done = document.execCommand("copy");
  box.remove();
  return done;
}

export async function copy(text, message = "Copied the command") {
  let done = false;
  try {
    await navigator.clipboard.writeText(text);
    done = true;
  } catch {
    done = copyByHand(text);
  }
  say(done ? message : "The browser does not let this page copy; select the text instead");
}

/** A command that breaks between its words, and inside one only where it must. */
export function commandText(text, properties = {}) {
  const words = text.split(" ");
  return h("code", properties, words.map((word, i) => [i ? " " : "", h("span", { class: "word" }, word)]));
}

/** A command that copies itself. */
export function command(text) {
  return h(
    "div",
    { class: "command" },
    commandText(text),
    h("button", { type: "button", class: "quiet", onclick: () => copy(text) }, "Copy"),
  );
}

export function download(name, type, text) {
  const url = URL.createObjectURL(new Blob([text], { type }));
  const link = h("a", { href: url, download: name });
  document.body.append(link);
  link.click();
  link.remove();
  setTimeout(() => URL.revokeObjectURL(url), 10_000);
}
