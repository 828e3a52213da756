// The page's own documents, which are Markdown: their tables, and the few marks that a cell has.
import { el } from "./dom.js";

// section_of is what stands below a heading, up to the next of its rank or above.
export function section_of(text, heading) {
  const lines = text.split("\n"),
    at = lines.findIndex(line => line.replace(/^#+ /, "").startsWith(heading) && line.startsWith("#"));
  if (at < 0) return "";
  const rank = /^#+/.exec(lines[at])[0].length;
  let end = lines.findIndex((line, i) => i > at && /^#+ /.test(line) && /^#+/.exec(line)[0].length <= rank);
  if (end < 0) end = lines.length;
  return lines.slice(at + 1, end).join("\n");
}

// rows_of gives the rows of the first table, without its head.
export function rows_of(text) {
  const rows = [];
  for (const line of text.split("\n")) {
    if (!line.startsWith("|")) {
      if (rows.length) break;
      continue;
    }
    rows.push(
      line
        .slice(1)
        .replace(/\|\s*$/, "")
        .split(/(?<!\\)\|/)
        .map(cell => cell.trim().replaceAll("\\|", "|")),
    );
  }
  return rows.slice(2);
}

// all_rows gives the rows of every table.
export function all_rows(text) {
  const rows = [];
  let head = true;
  for (const line of text.split("\n")) {
    if (!line.startsWith("|")) {
      head = true;
      continue;
    }
    if (/^\|[\s|:-]+\|?\s*$/.test(line)) {
      head = false;
      continue;
    }
    if (!head)
      rows.push(
        line
          .slice(1)
          .replace(/\|\s*$/, "")
          .split(/(?<!\\)\|/)
          .map(cell => cell.trim()),
      );
  }
  return rows;
}

// nodes_of shows `code`, **strong**, *emphasis* and [links](…), whose places are outside of this page.
export function nodes_of(text) {
  return text.split(/(`[^`]+`|\*\*[^*]+\*\*|\*[^*]+\*|!?\[[^\]]*\]\([^)]*\)|\\\(.*?\\\))/).map(part => {
    if (part.startsWith("`")) return el("code", {}, part.slice(1, -1));
    if (part.startsWith("**")) return el("strong", {}, part.slice(2, -2));
    if (/^\*[^*]+\*$/.test(part)) return el("em", {}, part.slice(1, -1));
    const link = /^!?\[([^\]]*)\]\(/.exec(part);
    if (link) return el("span", {}, link[1]);
    return part.startsWith("\\(") ? el("i", {}, part.slice(2, -2).replaceAll("\\", "")) : part;
  });
}
