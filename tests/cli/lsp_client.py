"""A client of durero spec lsp in Python's standard library: sends requests, and keeps what it is told."""
import json
import pathlib
import queue
import subprocess
import threading


class Failure(Exception):
    """The server answered with an error."""

    def __init__(self, error):
        super().__init__(error["message"])
        self.code = error["code"]


class LspClient:
    def __init__(self, durero, capabilities=None):
        self.process = subprocess.Popen([durero, "spec", "lsp"], stdin=subprocess.PIPE, stdout=subprocess.PIPE,
                                        stderr=subprocess.PIPE)
        self.messages = queue.Queue()
        self.last_id = 0
        self.diagnostics = {}
        threading.Thread(target=self._read, daemon=True).start()
        self.server = None
        if capabilities is not None:
            self.server = self.ask("initialize", {"processId": None, "rootUri": None, "capabilities": capabilities})
            self.tell("initialized", {})

    def _read(self):
        out = self.process.stdout
        while True:
            length = None
            while True:
                line = out.readline()
                if not line:
                    self.messages.put(None)
                    return
                if line == b"\r\n":
                    break
                name, _, value = line.partition(b":")
                if name.lower() == b"content-length":
                    length = int(value)
            self.messages.put(json.loads(out.read(length)))

    def write(self, data):
        self.process.stdin.write(data)
        self.process.stdin.flush()

    def send(self, message):
        body = json.dumps({"jsonrpc": "2.0", **message}).encode()
        self.write(b"Content-Length: %d\r\n\r\n%s" % (len(body), body))

    def tell(self, method, params):
        self.send({"method": method, "params": params})

    def begin(self, method, params):
        self.last_id += 1
        self.send({"id": self.last_id, "method": method, "params": params})
        return self.last_id

    def next(self):
        """The next message; defects are kept by their file on the way."""
        message = self.messages.get(timeout=60)
        if message and message.get("method") == "textDocument/publishDiagnostics":
            self.diagnostics[message["params"]["uri"]] = message["params"]
        return message

    def result(self, identity):
        while True:
            message = self.next()
            assert message is not None, "the server has ended"
            if message.get("id") == identity and "method" not in message:
                if "error" in message:
                    raise Failure(message["error"])
                return message["result"]

    def ask(self, method, params):
        return self.result(self.begin(method, params))

    def defects(self, uri, version):
        """The defects of a version of a text, once they are told."""
        while self.diagnostics.get(uri, {}).get("version") != version:
            assert self.next() is not None, "the server has ended"
        return self.diagnostics[uri]["diagnostics"]

    def open(self, uri, text):
        self.tell("textDocument/didOpen",
                  {"textDocument": {"uri": uri, "languageId": "z", "version": 1, "text": text}})

    def change(self, uri, version, *changes):
        self.tell("textDocument/didChange",
                  {"textDocument": {"uri": uri, "version": version}, "contentChanges": list(changes)})

    def at(self, method, uri, line, character, **more):
        return self.ask("textDocument/" + method, {"textDocument": {"uri": uri},
                                                   "position": {"line": line, "character": character}, **more})

    def end(self, shut_down=True):
        """Ends the session, and returns the exit status and what stands on stderr."""
        if shut_down:
            assert self.ask("shutdown", None) is None
        self.tell("exit", None)
        self.process.stdin.close()
        return self.process.wait(timeout=60), self.process.stderr.read().decode()


def part(line, first, last, text):
    """A change of a range in one line."""
    return {"range": {"start": {"line": line, "character": first}, "end": {"line": line, "character": last}},
            "text": text}


def uri_of(path):
    return pathlib.Path(path).absolute().as_uri()


def applied(text, edits):
    """A text with edits made, whose characters are all one unit of UTF-16."""
    lines = text.splitlines(keepends=True)
    starts = [0]
    for line in lines:
        starts.append(starts[-1] + len(line))
    for edit in sorted(edits, key=lambda each: (each["range"]["start"]["line"], each["range"]["start"]["character"]),
                       reverse=True):
        begin, end = (starts[edit["range"][side]["line"]] + edit["range"][side]["character"]
                      for side in ("start", "end"))
        text = text[:begin] + edit["newText"] + text[end:]
    return text
