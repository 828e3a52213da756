// Elements of the page.

// el makes an element: el("button", { class: "plain", onclick: f }, "text", other).
export function el(tag, attributes = {}, ...children) {
  const made = document.createElement(tag);
  for (const [name, value] of Object.entries(attributes)) {
    if (value === undefined || value === null || value === false) continue;
    if (name.startsWith("on")) made.addEventListener(name.slice(2), value);
    else if (name === "value" || name === "checked" || name === "disabled" || name === "selected") made[name] = value;
    else made.setAttribute(name, value === true ? "" : value);
  }
  made.append(...children.flat(Infinity).filter(child => child !== null && child !== undefined && child !== false));
  return made;
}

const svg_space = "http://www.w3.org/2000/svg";
export function svg(tag, attributes = {}, ...children) {
  const made = document.createElementNS(svg_space, tag);
  for (const [name, value] of Object.entries(attributes))
    if (value !== undefined && value !== null && value !== false) made.setAttribute(name, value);
  made.append(...children.flat(Infinity).filter(child => child !== null && child !== undefined));
  return made;
}

export const find = id => document.getElementById(id);

// fill replaces what an element holds, and keeps the focus on the control of the same name and the place of each scroll.
export function fill(holder, ...children) {
  const held = holder.contains(document.activeElement) ? document.activeElement.dataset.key : null;
  const scrolled = [...holder.querySelectorAll(".scroll[id]")].map(e => [e.id, e.scrollTop]);
  holder.replaceChildren(
    ...children.flat(Infinity).filter(child => child !== null && child !== undefined && child !== false),
  );
  for (const [id, top] of scrolled) {
    const again = find(id);
    if (again) again.scrollTop = top;
  }
  if (held)
    [...holder.querySelectorAll("[data-key]")].find(e => e.dataset.key === held)?.focus({ preventScroll: true });
}

// later calls f once after the calls have stopped for that many milliseconds.
export function later(f, wait) {
  let timer = 0;
  return (...values) => {
    clearTimeout(timer);
    timer = setTimeout(() => f(...values), wait);
  };
}
