"use strict";
// The picture of the proofs: what a node is joined to stands out while the node is pointed at or has the focus.
document.addEventListener("DOMContentLoaded", () => {
  for (const svg of document.querySelectorAll("svg.graph")) {
    const mark = (node, on) => {
      for (const edge of svg.querySelectorAll(`.edge.${CSS.escape(node.dataset.key)}`)) edge.classList.toggle("near", on);
    };
    for (const node of svg.querySelectorAll(".node[data-key]")) {
      for (const event of ["mouseenter", "focusin"]) node.addEventListener(event, () => mark(node, true));
      for (const event of ["mouseleave", "focusout"]) node.addEventListener(event, () => mark(node, false));
    }
  }
});
