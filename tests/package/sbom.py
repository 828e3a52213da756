"""sbom.py ROOT: the list of software in a release is one of SPDX 2.3, names what docs/licences.md and release/libraries.sh say,
and is the same each time. Each rule then sees a fault that is planted in it, and bad facts get one line."""
import copy
import datetime
import hashlib
import json
import pathlib
import re
import subprocess
import sys
import tempfile

root = pathlib.Path(sys.argv[1]).resolve()
EXPRESSION = re.compile(r"NOASSERTION|[A-Za-z0-9.+-]+( (AND|OR) [A-Za-z0-9.+-]+)*")
# What SPDX 2.3 asks of each package, and the kinds of relationships that are used here.
MEMBERS = {"SPDXID", "name", "versionInfo", "downloadLocation", "filesAnalyzed", "licenseConcluded", "licenseDeclared",
           "copyrightText"}
KINDS = {"DESCRIBES", "CONTAINS", "DEPENDS_ON", "STATIC_LINK"}
WHEEL = "durero-0.1.0-cp311-cp311-manylinux_2_35_x86_64.whl"
FILES = {"durero-0.1.0.tar.gz": b"sources", "durero-0.1.0-x86_64": b"program", "durero_0.1.0_amd64.deb": b"package",
         WHEEL: b"wheel", "CHANGES-0.1.0.md": b"changes"}
TOOLS = {"g++", "cmake", "ninja-build", "pkg-config"}


def compiled_sources():
    """Each `SOURCE PACKAGE` that release/libraries.sh compiles."""
    text = (root / "release/libraries.sh").read_text(encoding="utf-8")
    return dict(line.split() for line in re.search(r"<<'END'\n(.*?)END\n", text, re.S).group(1).splitlines())


def packages_of_build():
    text = (root / "x").read_text(encoding="utf-8")
    return set(re.search(r'^build_packages="([^"]*)"', text, re.M).group(1).split()) - TOOLS


def of_licences():
    """Each package that a table of the page names."""
    return set(re.findall(r"^\| `([a-z0-9+.-]+)` \|", (root / "docs/licences.md").read_text(encoding="utf-8"), re.M))


class Case:
    """Stand-ins for a release and for what dpkg says."""

    def __init__(self, folder):
        self.folder, self.files = folder, folder / "files"
        self.files.mkdir()
        for name, content in FILES.items():
            (self.files / name).write_bytes(content)
        self.sources = compiled_sources()
        by_package = {package: source for source, package in self.sources.items()}
        facts = [f"{name} 1:{number}+x {by_package.get(name, name + '-source')} {number}~s"
                 for number, name in enumerate(sorted(of_licences() | packages_of_build()))]
        self.write("installed", facts)
        self.write("compiled", [f"{source} 9.{number}-built" for number, source in enumerate(self.sources)] + ["pybind11 3.1.0"])
        self.page = root / "docs/licences.md"

    def write(self, name, lines):
        (self.folder / name).write_text("".join(line + "\n" for line in lines), encoding="utf-8")

    def lines(self, name):
        return (self.folder / name).read_text(encoding="utf-8").splitlines()

    def run(self):
        return subprocess.run(
            [sys.executable, root / "release/sbom.py", "--version", "0.1.0", "--time", "1795000000", "--licences", self.page,
             "--compiled", self.folder / "compiled", "--installed", self.folder / "installed", self.files],
            capture_output=True, text=True, check=False)


def faults(document, case):
    """What is wrong with a document."""
    if document.get("spdxVersion") != "SPDX-2.3" or document.get("dataLicense") != "CC0-1.0":
        yield "another version or licence of the document"
    if document.get("creationInfo", {}).get("created") != datetime.datetime.fromtimestamp(
            1795000000, datetime.timezone.utc).strftime("%Y-%m-%dT%H:%M:%SZ"):
        yield "another time than the commit's"
    if not re.fullmatch(r"[a-z][a-z0-9+.-]*:[^#]+", document.get("documentNamespace", "")):
        yield "no namespace"
    packages = {package.get("SPDXID"): package for package in document["packages"]}
    if len(packages) != len(document["packages"]):
        yield "an identifier of two packages"
    for key, package in packages.items():
        if not MEMBERS <= package.keys():
            yield f"{key}: lacks {MEMBERS - package.keys()}"
        elif not re.fullmatch(r"SPDXRef-[A-Za-z0-9.-]+", key):
            yield f"{key}: no identifier"
        elif not EXPRESSION.fullmatch(package["licenseDeclared"]):
            yield f"{key}: no expression of licences"
        elif package["licenseDeclared"] == "NOASSERTION" and not package.get("licenseComments"):
            yield f"{key}: no licence"
    links = set()
    for relation in document["relationships"]:
        ends = relation["spdxElementId"], relation["relatedSpdxElement"]
        if relation["relationshipType"] not in KINDS:
            yield f"{relation}: another kind"
        if not {*ends} <= {*packages, "SPDXRef-DOCUMENT"}:
            yield f"{relation}: leads nowhere"
        else:
            links.add((packages.get(ends[0], {}).get("name"), relation["relationshipType"], packages[ends[1]]["name"]))
    yield from lost(document, case, links)


def lost(document, case, links):
    """What a document does not say of the release."""
    by_name = {package["name"]: package for package in document["packages"]}
    for name, content in FILES.items():
        sums = by_name.get(name, {}).get("checksums", [{}])
        if sums[0].get("checksumValue") != hashlib.sha256(content).hexdigest() or (None, "DESCRIBES", name) not in links:
            yield f"{name}: is not described"
    versions = dict(line.split() for line in case.lines("compiled"))
    for source in case.sources:
        for file in ("durero-0.1.0-x86_64", WHEEL):
            if ((file, "STATIC_LINK", source) in links) != (file != WHEEL or source != "glibc"):
                yield f"{file}: not as {source} is in it"
        if not any(package["name"] == source and package["versionInfo"] == versions[source] for package in document["packages"]):
            yield f"{source}: another version than the compiled one"
    for name in packages_of_build():
        if not {how for file, how, package in links if file == "durero_0.1.0_amd64.deb" and package == name}:
            yield f"durero_0.1.0_amd64.deb: nothing of {name}"
    if ("durero-0.1.0-x86_64", "STATIC_LINK", "pybind11") in links:
        yield "the program has pybind11"


def planted(document):
    """Copies of the document with a fault each."""
    def fault(change):
        copied = copy.deepcopy(document)
        change(copied)
        return copied
    last = len(document["packages"]) - 1
    yield "a second package of one identifier", fault(lambda d: d["packages"].append(d["packages"][last]))
    yield "a package without its licence", fault(lambda d: d["packages"][last].pop("licenseDeclared"))
    yield "a licence that is none", fault(lambda d: d["packages"][last].update(licenseDeclared="MIT, mostly"))
    yield "an identifier with a space", fault(lambda d: d["packages"][last].update(SPDXID="SPDXRef-a b"))
    yield "a relationship to nothing", fault(lambda d: d["relationships"][0].update(relatedSpdxElement="SPDXRef-nothing"))
    yield "another digest", fault(lambda d: d["packages"][0]["checksums"][0].update(checksumValue="0" * 64))
    yield "the time of today", fault(lambda d: d["creationInfo"].update(created="2000-01-01T00:00:00Z"))
    yield "a library left out", fault(lambda d: d["relationships"].remove(
        next(r for r in d["relationships"] if r["relationshipType"] == "STATIC_LINK" and "gmp" in r["relatedSpdxElement"])))
    yield "another version", fault(lambda d: next(p for p in d["packages"] if p["name"] == "flint").update(versionInfo="0"))


def refusals(case):
    """Each refusal of a bad fact, which must be one line with the words."""
    def without(name):
        lines = case.lines("installed")
        case.write("installed", [line for line in lines if not line.startswith(name + " ")])
        yield
        case.write("installed", lines)
    for _ in without("libgmp-dev"):
        yield case.run(), "libgmp-dev is not installed; expected"
    lines = case.lines("compiled")
    case.write("compiled", [*lines, "zlib"])
    yield case.run(), f"compiled:{len(lines) + 1}:1: 1 words; expected 2"
    case.write("compiled", lines)
    case.page = case.folder / "page.md"
    case.page.write_text("# Licences\n", encoding="utf-8")
    yield case.run(), "no heading '## In the program and the library'"
    case.page = root / "docs/licences.md"


def main():
    bad = []
    with tempfile.TemporaryDirectory() as folder:
        case = Case(pathlib.Path(folder))
        once, again = case.run(), case.run()
        if once.returncode or once.stdout != again.stdout:
            sys.exit(f"sbom: status {once.returncode}, or two answers: {once.stderr}")
        document = json.loads(once.stdout)
        bad += faults(document, case)
        drills = list(planted(document))
        bad += [f"no rule sees {what}" for what, wrong in drills if not list(faults(wrong, case))]
        for answer, words in refusals(case):
            if answer.returncode != 2 or words not in answer.stderr or answer.stderr.count("\n") != 1 or answer.stdout:
                bad.append(f"status {answer.returncode}, {answer.stderr!r}; expected a line with {words!r}")
    for line in bad:
        print(line)
    print(f"{len(document['packages'])} packages, {len(document['relationships'])} relationships, {len(drills)} planted faults, {len(bad)} wrong")
    sys.exit(bool(bad))


main()
