"use strict";
// Sphinx's search, with what readers ask for first: a page with a heading of their words before one that has them somewhere,
// at that heading; a page of the documents before one of a single system, of all statements or of all changes.
const DURERO_LAST = /^(CHANGELOG|proofs\/statements|docs\/(glossary|seeds|findings\/.*)|maps\/(systems|proofs)\/.*)$/;

// The words of a query, each cut before the ending that it may have in another form.
const dureroStems = (query) =>
  query.toLowerCase().split(/[^\p{L}\p{N}_]+/u).filter((word) => word.length > 2 && !stopwords.includes(word))
    .map((word) => (word.length > 5 ? word.slice(0, -2) : word));

let dureroHeadings = null;
// Of each page its headings and their anchors.
const dureroHeadingsOf = (doc) => {
  if (!dureroHeadings) {
    dureroHeadings = new Map(Search._index.docnames.map((name) => [name, []]));
    for (const [title, places] of Object.entries(Search._index.alltitles))
      for (const [file, id] of places) dureroHeadings.get(Search._index.docnames[file]).push([title, id]);
  }
  return dureroHeadings.get(doc) || [];
};

var Scorer = {
  score: (result) => {
    const [doc, title, anchor, , score] = result;
    const stems = dureroStems(document.querySelector('input[name="q"]').value);
    const share = (heading) => stems.filter((stem) => heading.toLowerCase().includes(stem)).length / Math.max(stems.length, 1);
    const best = dureroHeadingsOf(doc).map(([heading, id]) => [share(heading), heading, id])
      .sort((a, b) => b[0] - a[0] || a[1].length - b[1].length)[0];
    if (!anchor && best && best[0] >= 0.5 && best[2] !== null && best[1] !== title) {
      result[1] = `${title} > ${best[1]}`;
      result[2] = `#${best[2]}`;
    }
    return score + (best ? 12 * best[0] : 0) + 6 * share(title) - (DURERO_LAST.test(doc) ? 8 : 0);
  },
  objNameMatch: 11, objPartialMatch: 6,
  objPrio: { 0: 15, 1: 5, 2: -5 }, objPrioDefault: 0,
  title: 15, partialTitle: 7, term: 5, partialTerm: 2,
};
