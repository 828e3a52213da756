"use strict";
// A file of the repository is shown in the light or the dark that was chosen on the pages.
document.addEventListener("DOMContentLoaded", () => {
  document.body.dataset.theme = localStorage.getItem("theme") || "auto";
});
