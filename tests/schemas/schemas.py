"""The schemas of schemas/, and whether a text keeps to one of them."""
import json
import pathlib
import sys
import warnings

try:
    import jsonschema
    from jsonschema import Draft202012Validator
except ImportError:
    print("skipped: this Python has no jsonschema (Debian: python3-jsonschema)")
    sys.exit(77)


def refuse_constant(word):
    raise ValueError(f"{word} is no JSON")


def parsed(text):
    """The value of a JSON text. NaN and Infinity, which Python takes, are none."""
    return json.loads(text, parse_constant=refuse_constant)


class Schemas:
    def __init__(self, root):
        self.of = {}
        for path in sorted(pathlib.Path(root, "schemas").glob("*.schema.json")):
            self.of[path.name.removesuffix(".schema.json")] = parsed(path.read_text(encoding="utf-8"))
        self.validators = {name: self.validator(schema) for name, schema in self.of.items()}

    def validator(self, schema):
        Draft202012Validator.check_schema(schema)
        with warnings.catch_warnings():  # newer versions resolve otherwise, and still know this way
            warnings.simplefilter("ignore")
            store = {other["$id"]: other for other in self.of.values()} | {f"{name}.schema.json": other
                                                                          for name, other in self.of.items()}
            resolver = jsonschema.RefResolver(schema["$id"], schema, store=store)
            return Draft202012Validator(schema, resolver=resolver)

    def complaint(self, name, value):
        """What is wrong with a value, in a line; empty where nothing is."""
        error = jsonschema.exceptions.best_match(self.validators[name].iter_errors(value))
        return "" if error is None else f"/{'/'.join(map(str, error.absolute_path))}: {error.message[:300]}"

    def accepts(self, name, text):
        """Whether a text is JSON that keeps to the schema."""
        try:
            value = parsed(text)
        except (ValueError, RecursionError):
            return False
        return self.validators[name].is_valid(value)
