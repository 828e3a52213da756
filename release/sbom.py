"""sbom.py --version V --time SECONDS --licences PAGE --compiled FILE --installed FILE FOLDER: the list of the software in a
release, in SPDX 2.3, as JSON.

FOLDER has the files of the release. COMPILED has a line `SOURCE VERSION` for each source package of Debian that was compiled
into the wheels and the program. INSTALLED has dpkg's facts, a line `PACKAGE VERSION SOURCE SOURCE-VERSION` each. PAGE is
docs/licences.md: its tables say which package is a part of what, and under which licence. A licence that is no expression of
SPDX stands in the comment of its package, and NOASSERTION in its place. The same input gives the same bytes."""
import argparse
import datetime
import hashlib
import json
import pathlib
import re
import sys
import urllib.parse

# The identifiers of SPDX that the page uses.
IDENTIFIERS = frozenset("""Apache-2.0 BSD-2-Clause BSD-3-Clause BSL-1.0 GPL-2.0-or-later GPL-3.0-or-later IJG ISC
  LGPL-2.1-or-later LGPL-3.0-or-later MIT PSF-2.0 Zlib libpng-2.0""".split())
CARRIED = "## In a wheel and the program of one file"
LINKED = "## In the program and the library"


def give_up(what):
    print(f"sbom: {what}", file=sys.stderr)
    sys.exit(2)


def rows(page, heading):
    """The rows of the first table below a heading, as lists of cells."""
    _, found, below = page.partition(heading + "\n")
    if not found:
        give_up(f"no heading {heading!r} in the page of licences; expected its table")
    table = re.search(r"^\|.*(?:\n\|.*)*", below.partition("\n## ")[0], re.M)
    if table is None:
        give_up(f"no table below {heading!r}; expected one")
    lines = table.group().split("\n")[2:]
    return [[cell.strip() for cell in line.strip("|").split("|")] for line in lines]


def licence(text):
    """The licence of a row as the members of a package: an expression of SPDX where it is one."""
    words = text.split()
    names, joints = words[::2], set(words[1::2])
    if IDENTIFIERS.issuperset(names) and len(words) % 2 == 1 and joints in (set(), {"or"}, {"and"}):
        return {"licenseDeclared": " ".join(word.upper() if word in ("or", "and") else word for word in words)}
    return {"licenseDeclared": "NOASSERTION", "licenseComments": text}


def identifier(kind, name):
    return f"SPDXRef-{kind}-" + re.sub(r"[^A-Za-z0-9.-]", "-", name)


def read_facts(path, count):
    facts = {}
    for number, line in enumerate(path.read_text(encoding="utf-8").splitlines(), 1):
        words = line.split()
        if len(words) != count:
            give_up(f"{path}:{number}:1: {len(words)} words; expected {count}")
        facts[words[0]] = words[1:]
    return facts


class Contents:
    """The packages of a release, each once."""

    def __init__(self, compiled, installed):
        self.compiled, self.installed, self.packages = compiled, installed, {}

    def add(self, name, text, archive):
        """Adds a package of Debian, by its name there; of what a wheel carries the sources that were compiled. Answers its
        identifier."""
        if name == "pybind11":
            return self.put(name, self.compiled[name][0], f"pkg:pypi/pybind11@{self.compiled[name][0]}", text)
        if name not in self.installed:
            give_up(f"{name} is not installed; expected a row of a package that a release is built with")
        version, source, source_version = self.installed[name]
        if archive and source in self.compiled:
            source_version = self.compiled[source][0]
            return self.put(source, source_version, self.debian(source, source_version, "source"), text)
        return self.put(name, version, self.debian(name, version, "amd64"), text)

    @staticmethod
    def debian(name, version, kind):
        return f"pkg:deb/debian/{name}@{urllib.parse.quote(version, safe='')}?arch={kind}"

    def put(self, name, version, purl, text):
        key = identifier("Package", f"{name}-{version}")
        self.packages[key] = {
            "SPDXID": key, "name": name, "versionInfo": version, "downloadLocation": "NOASSERTION", "filesAnalyzed": False,
            "licenseConcluded": "NOASSERTION", **licence(text), "copyrightText": "NOASSERTION",
            "externalRefs": [{"referenceCategory": "PACKAGE-MANAGER", "referenceType": "purl", "referenceLocator": purl}]}
        return key


def file_package(path, version):
    """A file of the release."""
    return {
        "SPDXID": identifier("File", path.name), "name": path.name, "versionInfo": version, "packageFileName": path.name,
        "downloadLocation": "NOASSERTION", "filesAnalyzed": False, "licenseConcluded": "NOASSERTION", "licenseDeclared": "MIT",
        "copyrightText": "NOASSERTION",
        "checksums": [{"algorithm": "SHA256", "checksumValue": hashlib.sha256(path.read_bytes()).hexdigest()}]}


def is_linked(name):
    """Whether what Debian's package of that name needs is linked when it runs, and not carried."""
    return name.endswith(".deb")


def document(options):
    page = options.licences.read_text(encoding="utf-8")
    contents = Contents(read_facts(options.compiled, 2), read_facts(options.installed, 4))
    # The first table has what the program uses, the second what a wheel and the program of one file carry.
    linked = {cells[0].strip("`"): cells for cells in rows(page, LINKED)}
    shared = [(contents.add(name, cells[2], False), "headers" if cells[3].startswith("headers") else "shared")
              for name, cells in linked.items()]
    carried = [(contents.add(cells[0].strip("`"), cells[2], True), cells[3]) for cells in rows(page, CARRIED)]
    # The headers of what is not compiled anew are in both.
    carried += [(key, "both") for key, how in shared if how == "headers"]
    files = [file_package(path, options.version) for path in sorted(options.folder.iterdir())]
    relations = []
    for file in files:
        relations.append(("SPDXRef-DOCUMENT", "DESCRIBES", file["SPDXID"]))
        if is_linked(file["name"]):
            relations += [(file["SPDXID"], "DEPENDS_ON", key) for key, how in shared if how == "shared"]
            relations += [(file["SPDXID"], "CONTAINS", key) for key, how in shared if how == "headers"]
        for kind, ending in (("wheel", ".whl"), ("program", "-x86_64")):
            if file["name"].endswith(ending):
                relations += [(file["SPDXID"], "STATIC_LINK", key) for key, how in carried if how in ("both", kind)]
    created = datetime.datetime.fromtimestamp(options.time, datetime.timezone.utc).strftime("%Y-%m-%dT%H:%M:%SZ")
    # The namespace is one document's own: a digest of what it lists.
    digest = hashlib.sha256(json.dumps([files, sorted(contents.packages)], sort_keys=True).encode()).hexdigest()
    return {
        "spdxVersion": "SPDX-2.3", "dataLicense": "CC0-1.0", "SPDXID": "SPDXRef-DOCUMENT", "name": f"durero-{options.version}",
        "documentNamespace": f"urn:sha256:{digest}",
        "creationInfo": {"created": created, "creators": [f"Tool: durero-release-{options.version}"]},
        "packages": files + [contents.packages[key] for key in sorted(contents.packages)],
        "relationships": [{"spdxElementId": a, "relationshipType": how, "relatedSpdxElement": b}
                          for a, how, b in sorted(set(relations))]}


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("--version", required=True)
    parser.add_argument("--time", type=int, required=True)
    for name in ("--licences", "--compiled", "--installed"):
        parser.add_argument(name, type=pathlib.Path, required=True)
    parser.add_argument("folder", type=pathlib.Path)
    json.dump(document(parser.parse_args()), sys.stdout, indent=1, ensure_ascii=False)
    print()


main()
