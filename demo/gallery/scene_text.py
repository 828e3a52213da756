"""The text of a scene file: its stage on the first line, and then an element a line."""
import json


def scene_text(stage, elements):
    compact = {"separators": (",", ":")}
    lines = ",\n".join(json.dumps(element, **compact) for element in elements)
    return json.dumps(stage, **compact)[:-1] + ',\n"elementos":[\n' + lines + "\n]}"
