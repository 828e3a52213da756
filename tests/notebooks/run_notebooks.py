"""The notebooks, executed by Python's standard library: run_notebooks.py [--write] NOTEBOOK...

Each code cell runs as Jupyter runs it: what it prints is one output, and the value of its last expression another, as
text and, where it has one, as a picture. Outputs must be those that are stored; of a picture the pixels are. With --write
they are stored. Without, a fault is then planted in each notebook, which must be seen.
"""
import ast
import base64
import contextlib
import copy
import io
import json
import os
import pathlib
import struct
import sys
import zlib


def lines(text):
    return text.splitlines(keepends=True)


def value_of(cell, names):
    """Runs the source of a cell, and returns what it prints and the value of its last expression."""
    tree = ast.parse(cell)
    last = tree.body.pop() if tree.body and isinstance(tree.body[-1], ast.Expr) else None
    said = io.StringIO()
    value = None
    with contextlib.redirect_stdout(said):
        exec(compile(tree, "cell", "exec"), names)
        if last is not None:
            value = eval(compile(ast.Expression(last.value), "cell", "eval"), names)
    return said.getvalue(), value


def outputs_of(cell, count, names):
    said, value = value_of("".join(cell["source"]), names)
    outputs = []
    if said:
        outputs.append({"name": "stdout", "output_type": "stream", "text": lines(said)})
    if value is not None:
        data = {"text/plain": lines(repr(value))}
        if hasattr(value, "_repr_png_"):
            data = {"image/png": base64.b64encode(value._repr_png_()).decode(), **data}
        outputs.append({"data": data, "execution_count": count, "metadata": {}, "output_type": "execute_result"})
    return outputs


def pixels(png):
    """The size and the bytes of a picture as picture.py writes it: no two versions of zlib need pack them alike."""
    data = base64.b64decode(png)
    at, packed, size = 8, b"", None
    while at < len(data):
        length, kind = struct.unpack(">I4s", data[at:at + 8])
        body = data[at + 8:at + 8 + length]
        size = body if kind == b"IHDR" else size
        packed += body if kind == b"IDAT" else b""
        at += 12 + length
    return size, zlib.decompress(packed)


def comparable(outputs):
    made = copy.deepcopy(outputs)
    for output in made:
        if "image/png" in output.get("data", {}):
            output["data"]["image/png"] = pixels(output["data"]["image/png"])
    return made


def run(notebook):
    """The notebook as it is after it was executed."""
    made = copy.deepcopy(notebook)
    names = {"__name__": "__main__"}
    count = 0
    for cell in made["cells"]:
        if cell["cell_type"] == "code":
            count += 1
            cell["execution_count"] = count
            cell["outputs"] = outputs_of(cell, count, names)
    return made


def difference(stored, made):
    """The first cell whose outputs are not those that are stored; None where all are."""
    for number, (before, now) in enumerate(zip(stored["cells"], made["cells"]), start=1):
        if before["cell_type"] == "code" and comparable(before["outputs"]) != comparable(now["outputs"]):
            return f"cell {number}: expected {json.dumps(before['outputs'])[:2000]}; got {json.dumps(now['outputs'])[:2000]}"
    return None


def is_seen(stored, made):
    """Whether a fault in each kind of outputs that a notebook has is seen."""
    for cell in range(len(stored["cells"])):
        for output in range(len(stored["cells"][cell].get("outputs", []))):
            wrong = copy.deepcopy(stored)
            planted = wrong["cells"][cell]["outputs"][output]
            if "image/png" in planted.get("data", {}):
                size, data = pixels(planted["data"]["image/png"])
                changed = zlib.compress(data[:-1] + bytes([data[-1] ^ 1]))
                planted["data"]["image/png"] = base64.b64encode(
                    b"\x89PNG\r\n\x1a\n" + struct.pack(">I4s", len(size), b"IHDR") + size + bytes(4)
                    + struct.pack(">I4s", len(changed), b"IDAT") + changed + bytes(4)).decode()
            elif "data" in planted:
                planted["data"]["text/plain"] = ["another"]
            else:
                planted["text"] = ["another\n"]
            if difference(wrong, made) is None:
                return False
    return True


def main():
    write = sys.argv[1] == "--write"
    files = [pathlib.Path(file).resolve() for file in sys.argv[2 if write else 1:]]
    wrong = not files
    for file in files:
        stored = json.loads(file.read_text(encoding="utf-8"))
        os.chdir(file.parent)
        sys.path[0] = str(file.parent)
        made = run(stored)
        if write:
            file.write_text(json.dumps(made, ensure_ascii=False, indent=1) + "\n", encoding="utf-8")
            continue
        found = difference(stored, made)
        if found is None and not is_seen(stored, made):
            found = "a planted fault is not seen"
        if file.stat().st_size > 100_000:
            found = f"{file.stat().st_size} bytes; expected 100,000 at most"
        outputs = sum(len(cell.get("outputs", [])) for cell in made["cells"])
        print(f"{file.name}: {found or f'{outputs} outputs, and every fault that was planted is seen'}")
        wrong = wrong or found is not None or outputs == 0
    return wrong


if __name__ == "__main__":
    sys.dont_write_bytecode = True
    sys.exit(main())
