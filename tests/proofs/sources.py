"""A source of Coq sentence by sentence, with what its file .glob says that each names."""
import bisect
import re

STATEMENTS = "Theorem", "Lemma", "Corollary"
PROVED = *STATEMENTS, "Definition", "Instance", "Let", "Fixpoint"  # what a proof follows, where it has no :=


class Sentence:
    """A sentence of a source, without comments before it."""

    def __init__(self, source, index, text, start, end, before):
        self.source, self.index, self.start, self.end, self.before = source, index, start, end, before
        self.text = text
        words = re.sub(r"^((Local|Global|#\[\w*\])\s+)*", "", text)
        self.kind = re.match(r"[A-Za-z]*", words)[0]
        self.proof = False   # part of one
        self.inside = ()     # the sentences that open the sections and modules around it
        self.ends = None     # the one that opens what it ends
        self.refers = []     # (file, name) of each name in it of these proofs
        self.shows = text    # with its proof, where that is what it defines

    def states(self):
        return self.kind in STATEMENTS

    def opens(self):
        return self.kind in ("Section", "Module") and ":=" not in self.text

    def shown(self):
        """As it is written, with its indentation."""
        indent = re.search(r"\n([ \t]*)$", self.before)
        return (indent[1] if indent else "") + self.shows

    def comment(self):
        """The lines of comment that lie next to it, but for the title of what follows."""
        lines = self.before.rstrip(" \t").split("\n")[1:-1] if "\n" in self.before else []
        near = []
        for line in reversed(lines):
            if not line.strip():
                break
            near.insert(0, line)
        text = "\n".join(near)
        return text + "\n" if text.lstrip().startswith("(*") and not text.lstrip().startswith("(** *") else ""


def after_comment(text, at):
    """The place after the comment that begins there; comments nest, and have strings in them."""
    depth = 0
    for token in re.compile(r'\(\*|\*\)|"[^"]*"').finditer(text, at):
        depth += {"(*": 1, "*)": -1}.get(token[0], 0)
        if depth == 0:
            return token.end()
    raise ValueError("a comment does not end")


def spans(text):
    """Where each sentence begins and ends: with a full stop, or three, and a blank."""
    at, start = 0, None
    token = re.compile(r'\s+|(?P<comment>\(\*)|"[^"]*"|(?P<end>(\.\.\.|(?<!\.)\.)(?=\s|$))|.', re.DOTALL)
    while at < len(text):
        found = token.match(text, at)
        at = after_comment(text, at) if found["comment"] else found.end()
        if found["comment"] or found[0].isspace():
            continue
        start = found.start() if start is None else start
        if found["end"]:
            yield start, at
            start = None


def whole_name(path, name):
    return name if path == "<>" else f"{path}.{name}"


class Source:
    def __init__(self, build, stem):
        self.stem = stem
        text = (build / f"{stem}.v").read_bytes().decode("latin-1")  # a byte a character, as Coq counts
        utf8 = lambda piece: piece.encode("latin-1").decode()
        self.sentences, last = [], 0
        for start, end in spans(text):
            self.sentences.append(
                Sentence(self, len(self.sentences), utf8(text[start:end]), start, end, utf8(text[last:start])))
            last = end
        self.mark_proofs()
        self.mark_sections()
        self.defined = {}  # of each name, with its path, what defines it: (kind, sentence), in their order
        self.read_glob((build / f"{stem}.glob").read_text().splitlines()[2:])

    def mark_proofs(self):
        of = None
        for sentence in self.sentences:
            if of is not None:
                sentence.proof = True
                of.shows += sentence.before + sentence.text
                if re.search(r"\b(Qed|Defined)\.$", sentence.text):
                    if not sentence.text.endswith("Defined."):
                        of.shows = of.text
                    of = None
            elif sentence.kind in STATEMENTS or (sentence.kind in PROVED and ":=" not in sentence.text):
                of = sentence

    def mark_sections(self):
        around = ()
        for sentence in self.sentences:
            if sentence.kind == "End" and not sentence.proof:
                sentence.ends, around = around[-1], around[:-1]
            sentence.inside = around
            if sentence.opens() and not sentence.proof:
                around = (*around, sentence)

    def given(self, sentence):
        """The variables and hypotheses of the sections that it is in."""
        return {name.split(".")[-1] for name, found in self.defined.items() for kind, s in found
                if kind == "var" and set(s.inside) <= set(sentence.inside)}

    def read_glob(self, lines):
        for line in lines:
            reference = re.match(r"R(\d+):\d+ Durero\.(\S+) (\S+) (\S+) ", line)
            definition = re.match(r"(?!binder|sec)([a-z]+) (\d+):\d+ (\S+) (\S+)$", line)
            if reference:
                self.at(int(reference[1])).refers.append((reference[2], whole_name(reference[3], reference[4])))
            elif definition:
                name, sentence = whole_name(definition[3], definition[4]), self.at(int(definition[2]))
                self.defined.setdefault(name, []).append((definition[1], sentence))

    def at(self, place):
        """The sentence that the place in bytes is in."""
        return self.sentences[bisect.bisect_left(self.sentences, place, key=lambda sentence: sentence.end)]

    def around(self, name, sentence):
        """What the name means in that sentence: where notations of some sections share it, the nearest before."""
        found = [s for _, s in self.defined.get(name, []) if s.source is not sentence.source or s.start < sentence.start]
        return found[-1] if found else None

    def defining(self, name):
        """The sentence that defines the constant or the type NAME or MODULE.NAME; a principle of induction is a type's."""
        found = self.defined.get(name) or self.defined[re.sub(r"_s?(ind|rec|rect)$", "", name)]
        return next(s for kind, s in found if kind not in ("abbrev", "not", "var"))
