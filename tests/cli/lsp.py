"""The language server as an editor uses it: `lsp.py DURERO [TEST...]`."""
import os
import pathlib
import subprocess
import sys
import time

from lsp_client import Failure, LspClient, applied, part, uri_of
from running import is_sanitized, run_tests

DURERO = os.path.abspath(sys.argv[1])
ROOT = pathlib.Path(__file__).resolve().parents[2]

UNICODE = """Prose.

┌ S
known : 𝔽 ℕ
└

┌ Op
ΔS
n? : ℕ
|
known′ = known ∪ {n?}
└
"""
LATEX = r"""A counter.
\begin{schema}{S}
  mi\_n : \nat
\where
  mi\_n < 10
\end{schema}
\begin{schema}{Op}
  \Delta S
\where
  mi\_n' = mi\_n + 1
\end{schema}
"""


def checked(*files):
    """The defects that spec check prints of files: no lines about sections and conjectures."""
    out = subprocess.run([DURERO, "spec", "check", "--states", "0", "--quiet", *files], capture_output=True, text=True,
                         check=False).stdout
    return [line for line in out.splitlines() if ": section " not in line and ": conjecture " not in line]


def told(client, path, version):
    """The same lines, of what the client was told; places are those of a text of one unit a character."""
    weight = {1: "", 2: "warning: ", 3: "opinion: "}
    return [f"{path}:{each['range']['start']['line'] + 1}:{each['range']['start']['character'] + 1}: "
            f"{weight[each['severity']]}{each['message']}" for each in client.defects(uri_of(path), version)]


def test_a_session_from_its_start_to_its_end():
    client = LspClient(DURERO, {})
    assert client.server["capabilities"]["positionEncoding"] == "utf-16"
    assert client.server["serverInfo"]["name"] == "durero spec lsp"
    assert client.end() == (0, "")
    assert LspClient(DURERO, {}).end(shut_down=False) == (1, "")
    gone = LspClient(DURERO, {})
    gone.process.stdin.close()
    assert gone.process.wait(timeout=60) == 1


def test_headers_that_count_no_bytes():
    for headers, said in ((b"Content-Length: x\r\n\r\n", "<stdin>:1:1: Content-Length is wrong; expected it once"),
                          (b"Content-Type: a\r\n\r\n", "<stdin>:1:1: there is no Content-Length; expected it"),
                          (b"Content-Length: 2\r\nContent-Length: 2\r\n\r\n{}", "<stdin>:2:1: Content-Length is wrong"),
                          (b"Content-Length: 99999999\r\n\r\n", "<stdin>:1:1: a message of 99999999 bytes; expected"),
                          (b"nothing\r\n\r\n", "<stdin>:1:1: this is no header; expected NAME: VALUE"),
                          (b"a" * 5000, "<stdin>:1:1: the headers do not end; expected an empty line")):
        client = LspClient(DURERO)
        client.write(headers)
        assert client.next()["error"]["code"] == -32700
        client.process.stdin.close()
        assert client.process.wait(timeout=60) == 2
        assert client.process.stderr.read().decode().startswith("durero: " + said), said


def test_messages_in_pieces_and_many_at_once():
    client = LspClient(DURERO, {})
    body = b'{"jsonrpc":"2.0","id":70,"method":"nothing","params":{}}'
    whole = b"content-length: %d\r\nContent-Type: application/vscode-jsonrpc; charset=utf-8\r\n\r\n%s" % (len(body), body)
    for byte in whole:
        client.write(bytes([byte]))
    client.write(whole.replace(b"70", b"71") + whole.replace(b"70", b"72"))
    for identity in (70, 71, 72):
        try:
            client.result(identity)
            raise AssertionError("an error is expected")
        except Failure as failure:
            assert failure.code == -32601
    client.write(b"Content-Length: 1\r\n\r\n{")
    assert client.next()["error"]["code"] == -32700
    assert client.end() == (0, "")


def test_defects_are_those_of_spec_check():
    for name, text in (("u.utf8", UNICODE), ("w.utf8", UNICODE.replace("n? : ℕ", "n? : M; m? : ℕ")), ("l.tex", LATEX),
                       ("f.utf8", "─\nT ::= a | b\nU == T\n⊢? ∀ x : U • x = a % U.conj.1\n└\n"),
                       ("b.tex", LATEX.replace(r"\nat", r"\nat \\ (")), ("p.tex", "Only prose.\n")):
        pathlib.Path(name).write_text(text, encoding="utf-8")
        path = os.path.abspath(name)
        client = LspClient(DURERO, {"general": {"positionEncodings": ["utf-32"]}})
        client.open(uri_of(path), text)
        want = checked(path)
        assert told(client, path, 1) == want, (told(client, path, 1), want)
        assert bool(want) == (name not in ("u.utf8", "l.tex")), want
        assert client.end() == (0, "")


def test_a_false_conjecture_is_told():
    text = "─\nT ::= a | b\n⊢? ∀ x : T • x = a ∨ x ≠ b % T.conj.1\n└\n"
    pathlib.Path("c.utf8").write_text(text, encoding="utf-8")
    said = subprocess.run([DURERO, "spec", "check", "--quiet", "c.utf8"], capture_output=True, text=True, check=False)
    assert said.returncode == 1 and "c.utf8:3:1: conjecture T.conj.1 is false, as in this state:\n  x = b" in said.stdout
    client = LspClient(DURERO, {})
    client.open("untitled:c", text)
    while not client.diagnostics.get("untitled:c", {}).get("diagnostics"):
        client.next()
    (defect,) = client.diagnostics["untitled:c"]["diagnostics"]
    assert defect["message"] == "conjecture T.conj.1 is false, as in this state:\n  x = b", defect
    assert defect["range"]["start"] == {"line": 2, "character": 0} and defect["severity"] == 1
    assert client.end() == (0, "")


def test_the_files_of_spec_are_checked_together():
    client = LspClient(DURERO, {"general": {"positionEncodings": ["utf-32"]}})
    files = sorted(str(path) for path in (ROOT / "spec").glob("*.tex"))
    want = checked(*files)
    found = []
    for path in files:
        client.open(uri_of(path), pathlib.Path(path).read_text(encoding="utf-8"))
        found += told(client, path, 1)
    assert sorted(found) == sorted(want), set(found) ^ set(want)
    tipos = uri_of(ROOT / "spec" / "tipos.tex")
    text = (ROOT / "spec" / "tipos.tex").read_text(encoding="utf-8")
    line = next(i for i, each in enumerate(text.splitlines()) if "Elemento" in each and "[" in each)
    places = client.at("references", tipos, line, text.splitlines()[line].index("Elemento"),
                       context={"includeDeclaration": True})
    assert len({place["uri"] for place in places}) > 5, places
    assert client.end() == (0, "")


def refuses(client, uri, line, column, name, said):
    """Asks for a renaming that is refused with these words."""
    try:
        client.at("rename", uri, line, column, newName=name)
    except Failure as failure:
        assert failure.code == -32803 and said in str(failure), failure
    else:
        raise AssertionError("a refusal is expected")


def test_names_in_both_mark_ups():
    client = LspClient(DURERO, {"textDocument": {"hover": {"contentFormat": ["plaintext"]}}})
    for uri, text, line, column in (("untitled:u", UNICODE, 10, 10), ("untitled:l", LATEX, 9, 14)):
        client.open(uri, text)
        assert client.defects(uri, 1) == []
        hover = client.at("hover", uri, line, column)
        assert hover["contents"]["kind"] == "plaintext" and "component" in hover["contents"]["value"], hover
        definition = client.at("definition", uri, line, column)
        assert [each["range"]["start"]["line"] for each in definition] == [3 if uri.endswith("u") else 2]
        assert client.at("prepareRename", uri, line, column)["placeholder"] in ("known", "mi_n")
        changes = client.at("rename", uri, line, column, newName="mi_total")["changes"][uri]
        if uri.endswith("l"):
            assert applied(text, changes) == text.replace(r"mi\_n", r"mi\_total")
        for name, said in (("∪", "has a meaning in Z"), ("a b", "no word of Z")):
            refuses(client, uri, line, column, name, said)
        client.change(uri, 2, *({"range": each["range"], "text": each["newText"]} for each in reversed(changes)))
        assert client.defects(uri, 2) == []
    client.open("untitled:c", "┌ S\nx : ℕ\n|\n∀ n : ℕ • n ≥ x\n└\n")
    refuses(client, "untitled:c", 1, 0, "n", "would stand for something else")
    refuses(client, "untitled:c", 1, 4, "N", "ℕ is a name of the toolkit")
    assert client.end() == (0, "")


def test_completion():
    client = LspClient(DURERO, {})
    client.open("untitled:u", UNICODE)
    labels = {each["label"] for each in client.at("completion", "untitled:u", 10, 1)}
    assert {"known", "known'", "n?", "S", "Op", "first", "dom"} <= labels, labels
    client.change("untitled:u", 2, part(10, 9, 21, "\\em"))
    items = client.at("completion", "untitled:u", 10, 12)
    empty = next(each for each in items if each["label"] == "\\emptyset")
    assert empty["textEdit"] == {"range": {"start": {"line": 10, "character": 9}, "end": {"line": 10, "character": 12}},
                                 "newText": "∅"}, empty
    client.open("untitled:l", LATEX)
    items = client.at("completion", "untitled:l", 9, 20)
    assert any(each["textEdit"]["newText"] == r"mi\_n'" for each in items), items
    assert client.at("completion", "untitled:l", 0, 3) == []
    client.open("untitled:s", "┌ P\nx, y : ℕ\n└\n─\na == {p : P | p. = 1}\n└\n")
    assert {each["label"] for each in client.at("completion", "untitled:s", 4, 16)} == {"x", "y"}
    assert client.end() == (0, "")


def test_layout_and_outline():
    client = LspClient(DURERO, {"textDocument": {"documentSymbol": {"hierarchicalDocumentSymbolSupport": True}}})
    client.open("untitled:l", LATEX.replace("  ", "      "))
    edits = client.ask("textDocument/formatting", {"textDocument": {"uri": "untitled:l"}, "options": {"tabSize": 8}})
    assert applied(LATEX.replace("  ", "      "), edits) == LATEX
    symbols = client.ask("textDocument/documentSymbol", {"textDocument": {"uri": "untitled:l"}})
    assert [(each["name"], [part["name"] for part in each["children"]]) for each in symbols] == [("S", ["mi_n"]),
                                                                                               ("Op", [])]
    client.open("untitled:w", r"\begin{zed} a == ( \end{zed}")
    try:
        client.ask("textDocument/formatting", {"textDocument": {"uri": "untitled:w"}, "options": {}})
        raise AssertionError("a refusal is expected")
    except Failure as failure:
        assert failure.code == -32803
    assert client.end() == (0, "")


def test_edits_within_a_pair_of_surrogates():
    client = LspClient(DURERO, {})
    client.open("untitled:u", UNICODE)
    assert client.defects("untitled:u", 1) == []
    client.change("untitled:u", 2, part(3, 9, 9, "-"))  # within 𝔽, which takes the units 8 and 9
    defects = client.defects("untitled:u", 2)
    assert defects and defects[0]["range"]["start"] == {"line": 3, "character": 8}, defects
    client.change("untitled:u", 3, part(3, 9, 10, ""))
    assert client.defects("untitled:u", 3) == []
    assert "𝔸" in client.at("hover", "untitled:u", 3, 1)["contents"]["value"]
    client.change("untitled:u", 4, part(3, 8, 9, ""), part(3, 8, 9, "ℙ"))
    assert client.defects("untitled:u", 4) == []
    assert client.end() == (0, "")
    bytes_of = LspClient(DURERO, {"general": {"positionEncodings": ["utf-8", "utf-16"]}})
    assert bytes_of.server["capabilities"]["positionEncoding"] == "utf-8"
    bytes_of.open("untitled:u", UNICODE)
    bytes_of.change("untitled:u", 2, part(3, 8, 12, "ℙ"))
    assert bytes_of.defects("untitled:u", 2) == []
    assert bytes_of.end() == (0, "")


def test_a_request_that_waits_is_cancelled():
    client = LspClient(DURERO, {})
    client.open("untitled:l", LATEX)
    client.defects("untitled:l", 1)
    messages = b""
    for body in (b'{"jsonrpc":"2.0","id":80,"method":"textDocument/documentSymbol","params":{"textDocument":{"uri":"untitled:l"}}}',
                 b'{"jsonrpc":"2.0","id":81,"method":"textDocument/documentSymbol","params":{"textDocument":{"uri":"untitled:l"}}}',
                 b'{"jsonrpc":"2.0","method":"$/cancelRequest","params":{"id":81}}'):
        messages += b"Content-Length: %d\r\n\r\n%s" % (len(body), body)
    client.write(messages)
    answers = {}
    while len(answers) < 2:
        message = client.next()
        answers[message["id"]] = message.get("error", {}).get("code")
    assert answers == {80: None, 81: -32800}, answers
    assert client.end() == (0, "")


def test_a_change_of_a_text_of_ten_thousand_lines():
    """The time is measured and printed, and not asserted."""
    boxes = 100 if is_sanitized(DURERO) else 1250
    text = "".join(f"\\begin{{schema}}{{S{i}}}\n  known : \\power \\nat \\\\\n  n : \\nat\n\\where\n  n \\in known\n"
                   f"\\end{{schema}}\nProse.\n\n" for i in range(boxes))
    client = LspClient(DURERO, {})
    client.open("untitled:big", text)
    assert client.defects("untitled:big", 1) == []
    times = []
    for version in range(2, 12):
        start = time.monotonic()
        wrong = version % 2 == 0
        client.change("untitled:big", version, part(8 * (boxes // 2) + 4, 4, 7, "\\no" if wrong else "\\in"))
        assert bool(client.defects("untitled:big", version)) == wrong
        times.append(time.monotonic() - start)
    print(f"a change in {text.count(chr(10))} lines: {sorted(times)[len(times) // 2] * 1000:.0f} ms until its defects")
    assert client.end() == (0, "")


if __name__ == "__main__":
    sys.exit(run_tests(globals()))
