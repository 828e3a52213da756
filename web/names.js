import { el } from "./dom.js";

// Names of elements, which mark them in the picture.
export const chip = id => el("span", { "class": "chip", "data-marks": "el:" + id, "tabindex": "0" }, id);
export const set_of = ids =>
  ids?.length
    ? el(
        "span",
        { class: "set" },
        "{ ",
        ids.flatMap((id, i) => (i ? [", ", chip(id)] : [chip(id)])),
        " }",
      )
    : el("span", { class: "set" }, "∅");
