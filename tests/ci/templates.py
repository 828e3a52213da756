"""The action for GitHub and the template for GitLab: templates.py DURERO ROOT.

Their steps run as the two services run them, by sh, on a program that is right, on one that is wrong, and on one that is
absent; the JUnit report says so. The program that is built where none is given is a stand-in here, which tells its call.
"""
import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile
import xml.etree.ElementTree

DURERO = os.path.abspath(sys.argv[1])
ROOT = pathlib.Path(sys.argv[2]).resolve()
ACTION = (ROOT / "ci/github/action.yml").read_text(encoding="utf-8")
TEMPLATE = (ROOT / "ci/gitlab/durero.yml").read_text(encoding="utf-8")

RIGHT = f"{DURERO} conform answer"
WRONG = f"python3 {ROOT}/systems/examples/sphere.py"
PROFILE = f"{ROOT}/systems/examples/sphere.json"


def block(lines, at):
    """The text of a block scalar (YAML 1.2, 8.1.2) whose key stands in a line: the lines below, indented deeper."""
    indent = len(lines[at]) - len(lines[at].lstrip(" -"))
    body = []
    for line in lines[at + 1:]:
        if line.strip() and len(line) - len(line.lstrip()) <= len(lines[at]) - len(lines[at].lstrip()):
            break
        body.append(line)
    depth = min(len(line) - len(line.lstrip()) for line in body if line.strip())
    assert depth > indent - 2
    return "\n".join(line[depth:] for line in body) + "\n"


def github_steps():
    """Of each step with a shell: its environment, and what it runs."""
    steps = []
    for text in re.split(r"^    - (?=name: )", ACTION.split("  steps:\n")[1], flags=re.M)[1:]:
        lines = text.splitlines()
        runs = [at for at, line in enumerate(lines) if line.strip() == "run: |"]
        if not runs:
            continue
        assert "      shell: sh" in lines, text
        environment = dict(re.findall(r"^        ([A-Z]+): (.*)$", "\n".join(lines[:runs[0]]), re.M))
        steps.append((environment, block(lines, runs[0])))
    return steps


def github_defaults():
    """The inputs with their defaults; one that is required has none."""
    inputs = ACTION.split("inputs:\n")[1].split("\noutputs:\n")[0]
    found = {}
    for name, body in re.findall(r"^  ([a-z]+):\n((?:    .*\n)+)", inputs + "\n", re.M):
        default = re.search(r"^    default: \"?([^\"\n]*)\"?$", body, re.M)
        assert bool(default) != ("required: true" in body), name
        found[name] = default and default.group(1)
    return found


def sh(script, environment):
    return subprocess.run(["sh", "-c", script], env={**os.environ, **environment}, capture_output=True, text=True,
                          check=False)


def run_github(folder, **given):
    """Runs the action with these inputs; returns the status, what was printed, and the outputs of its last step."""
    inputs = {**github_defaults(), **given}
    assert None not in inputs.values(), inputs
    outputs = {}
    for environment, script in github_steps():
        out, summary = folder / "output", folder / "summary"
        out.write_text("")
        values = {}
        for name, value in environment.items():
            kind, key = re.fullmatch(r"\$\{\{ (inputs\.|steps\.find\.outputs\.)([a-z]+) \}\}", value).groups()
            values[name] = inputs[key] if kind == "inputs." else outputs[key]
        done = sh(script, {**values, "GITHUB_OUTPUT": str(out), "GITHUB_STEP_SUMMARY": str(summary),
                           "GITHUB_ACTION_PATH": str(folder / "ci/github")})
        outputs = dict(line.split("=", 1) for line in out.read_text().splitlines())
        if done.returncode != 0:
            break
    return done, outputs, summary.read_text() if summary.exists() else ""


def run_gitlab(**given):
    lines = TEMPLATE.splitlines()
    defaults = dict(re.findall(r"^    (DURERO_[A-Z]+): \"(.*)\"$", TEMPLATE, re.M))
    assert set(given) <= set(defaults), given
    script = block(lines, lines.index("    - |"))
    return sh(script, {**defaults, **given})


def verdicts(report):
    """How many families a JUnit report has, and how many of them failed."""
    suite = xml.etree.ElementTree.parse(report).getroot()
    cases = list(suite.iter("testcase"))
    return len(cases), sum(case.find("failure") is not None for case in cases)


def check_github(folder):
    common = {"profile": PROFILE, "rays": "16", "families": "generic tangent", "durero": DURERO}
    done, outputs, summary = run_github(folder, command=RIGHT, report="right", **common)
    assert done.returncode == 0, done
    families, failed = verdicts(outputs["junit"])
    assert families >= 2 and failed == 0, (families, failed)
    assert "0 gross, 0 off" in summary and summary.startswith("```text\n"), summary
    done, outputs, summary = run_github(folder, command=WRONG, report="wrong", **common)
    assert done.returncode == 1, done
    assert verdicts(outputs["junit"])[1] == 1 and "tangent off" in done.stdout, done
    done, outputs, _ = run_github(folder, command="./nothing-here", report="absent", **common)
    assert done.returncode == 2 and "junit" not in outputs, (done, outputs)
    done, outputs, _ = run_github(folder, command=RIGHT, profile=PROFILE, rays="16", report="all", durero=DURERO)
    assert done.returncode == 0 and verdicts(outputs["junit"])[0] > 10, done


def check_gitlab(folder):
    os.environ["PATH"] = f"{folder / 'bin'}:{os.environ['PATH']}"
    common = {"DURERO_PROFILE": PROFILE, "DURERO_RAYS": "16", "DURERO_FAMILIES": "generic tangent"}
    done = run_gitlab(DURERO_COMMAND=RIGHT, DURERO_REPORT="gl-right", **common)
    assert done.returncode == 0, done
    (report,) = pathlib.Path("gl-right").glob("*/report.xml")
    assert verdicts(report)[1] == 0
    done = run_gitlab(DURERO_COMMAND=WRONG, DURERO_REPORT="gl-wrong", **common)
    assert done.returncode == 1, done
    (report,) = pathlib.Path("gl-wrong").glob("*/report.xml")
    assert verdicts(report)[1] == 1
    assert "junit: $DURERO_REPORT/*/report.xml" in TEMPLATE
    done = run_gitlab(DURERO_COMMAND="./nothing-here", DURERO_REPORT="gl-absent", **common)
    assert done.returncode == 2, done


def check_build(folder):
    """Where no program is given, the sources build one; here they are a stand-in for x, which links the program."""
    sources = folder / "sources"
    (sources / "build/release").mkdir(parents=True)
    (sources / "x").write_text(f'#!/bin/sh\n[ "$1" = build ] && ln -s {DURERO} "${{0%/x}}/build/release/durero"\n')
    (sources / "x").chmod(0o755)
    git = ["git", "-c", "user.name=a", "-c", "user.email=a@b", "-C", str(sources)]
    subprocess.run([*git, "init", "-q", "-b", "main"], check=True)
    (sources / "build/release/kept").touch()
    subprocess.run([*git, "add", "x", "build"], check=True)
    subprocess.run([*git, "commit", "-q", "-m", "sources"], check=True)
    path = ":".join(part for part in os.environ["PATH"].split(":") if not shutil.which("durero", path=part))
    os.environ["PATH"] = path
    done = run_gitlab(DURERO_COMMAND=RIGHT, DURERO_PROFILE=PROFILE, DURERO_RAYS="16", DURERO_FAMILIES="generic",
                      DURERO_SOURCES=sources.as_uri())
    assert done.returncode == 0, done
    action = folder / "action"
    shutil.copytree(sources, action, ignore=shutil.ignore_patterns(".git"))
    (action / "ci/github").mkdir(parents=True)
    done, _, _ = run_github(action, command=RIGHT, profile=PROFILE, rays="16", families="generic", report="built")
    assert done.returncode == 0, done


def main():
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        os.chdir(folder)
        (folder / "bin").mkdir()
        (folder / "bin/durero").symlink_to(DURERO)
        (folder / "ci/github").mkdir(parents=True)
        check_github(folder)
        check_gitlab(folder)
        check_build(folder)
        os.chdir("/")
    try:
        import yaml
    except ImportError:
        print("absent: PyYAML; the two files are read line by line alone")
    else:
        assert yaml.safe_load(ACTION)["runs"]["steps"][1]["run"] == github_steps()[1][1]
        assert set(yaml.safe_load(ACTION)["inputs"]) == set(github_defaults())
        assert yaml.safe_load(TEMPLATE)[".durero"]["artifacts"]["when"] == "always"
    print("right, wrong and absent programs are told apart")


if __name__ == "__main__":
    main()
