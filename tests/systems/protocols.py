"""protocols.py ROOT: what the files that adapters share make of a question, and of what an adapter answers.

Small systems in Python, JavaScript and C++ answer a mesh of two triangles that share an edge; the one in JavaScript is
left out where there is no node.
"""
import pathlib
import shutil
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(sys.argv[1]).resolve()
SCENE = "scene a\ntriangulo m:0 0 0 5 4 0 5 0 4 5\ntriangulo m:1 4 0 5 4 4 5 0 4 5\n"
QUESTION = (SCENE + "rays 2\n1 0.5 0 0 0 2\n9 9 0 0 0 2\n" + SCENE + "ranges 1\n1 0.5 0 0 0 2 3 8\n" +
            SCENE + "points 2\n1 0.5 0\n8 8 8\n")
LISTS = (SCENE + "crossings 2\n1 0.5 0 0 0 2\n9 9 0 0 0 2\n" + SCENE + "counts 1\n1 0.5 0 0 0 2\n" +
         SCENE + "shadows 2\n1 0.5 0 0 0 2 8\n9 9 0 0 0 2 8\n")

# Each answers with the last face, the number of points at t, and what it was asked.
PYTHON = """
import sys
sys.path.append(sys.argv[1])
import protocol

def build(points, faces):
    assert faces == [(0, 1, 2), (1, 3, 2)]
    return lambda p, v, *ends: None if p[0] == 9 else (1, len(points), ends or p)

def every(points, faces):
    return lambda p, v: [] if p[0] == 9 else [(1, 3), (0, 2)]

def shadows(points, faces):
    return lambda p, v, end: p[0] < end

def closest(points, faces):
    return lambda p: (0, 7, p)

protocol.serve("small", "1", protocol.rays_of_faces(build), *map(protocol.of_faces, (shadows, build, every)),
               load_closest=protocol.of_faces(closest))
"""
JAVASCRIPT = """
const { ofFaces, serve } = await import(process.argv[3] + "/protocol.mjs");
const build = (points, faces) => (p, v, ...ends) => p[0] === 9 || faces.join() !== "0,1,2,1,3,2" ? undefined
  : [1, points.length, ends.length ? ends : p];
await serve("small", "1", ofFaces(build), { ranges: ofFaces(build), points: ofFaces(() => (p) => [0, 7, p]) });
"""
ONE_BY_ONE = """
const { ofFaces, serve, triangleByTriangle } = await import(process.argv[3] + "/protocol.mjs");
const meet = (p, corners) => (p[0] === 9 ? undefined : p[0] === 1 ? [9 - corners[0][0]] : [undefined, corners[0]]);
await serve("small", "1", ofFaces(triangleByTriangle((corners) => corners, (p) => p, meet)));
"""
CPP = """
#include "ask.hpp"
using namespace ask;
struct Asked {
  const Scene& of;
  void ask(const Ray& ray) const {
    const Mesh mesh = mesh_of(of);
    if (ray.is_point) return void(std::printf("hit m:0 7 %g %g %g\\n", ray.p[0], ray.p[1], ray.p[2]));
    if (ray.p[0] == 9 || mesh.faces[1] != std::array<unsigned, 3>{1, 3, 2}) return miss();
    if (ray.begin > 0) return void(std::printf("hit m:1 %zu %g %g\\n", mesh.points.size(), ray.begin, ray.end));
    if (segment(mesh, ray) == 8) hit_at(of.elements[1].name, ray.p);
  }
};
int main() { return answer("small 1", [](const Scene& scene) { return Asked{scene}; }); }
"""
FILES = {"small.py": PYTHON, "small.mjs": JAVASCRIPT, "one.mjs": ONE_BY_ONE, "small.cpp": CPP}
ANSWERS = ["system small 1", "hit m:1 4 1 0.5 0", "miss", "hit m:1 4 3 8", "hit m:0 7 1 0.5 0", "hit m:0 7 8 8 8"]
OF_ONE_BY_ONE = ["system small 1", "hit m:1 5", "miss", "hit m:0 - 0 0 5"]
OF_LISTS = ["system small 1", "hit m:0 2 ; hit m:1 3", "miss", "count 2", "hit", "miss"]


def plain(line):
    """The line with numbers as C++ writes them, and no distance for none."""
    return " ".join(word.removesuffix(".0") for word in line.split())


def wrong(what, command, question, expected):
    ended = subprocess.run(command, input=question, capture_output=True, text=True)
    got = [plain(line) for line in ended.stdout.splitlines()]
    return [] if got == expected else ["%s: %s, expected %s; %s" % (what, got, expected, ended.stderr.strip())]


def main():
    systems, found = str(ROOT / "systems"), []
    with tempfile.TemporaryDirectory() as folder:
        for name, text in FILES.items():
            pathlib.Path(folder, name).write_text(text)
        found += wrong("protocol.py", [sys.executable, folder + "/small.py", systems], QUESTION, ANSWERS)
        found += wrong("protocol.py", [sys.executable, folder + "/small.py", systems], LISTS, OF_LISTS)
        if shutil.which("node"):
            found += wrong("protocol.mjs", ["node", folder + "/small.mjs", folder, systems], QUESTION, ANSWERS)
            rays = SCENE + "rays 3\n1 0.5 0 0 0 2\n9 9 0 0 0 2\n-1 0 0 0 0 2\n"
            found += wrong("triangleByTriangle", ["node", folder + "/one.mjs", folder, systems], rays, OF_ONE_BY_ONE)
        subprocess.run(["c++", "-std=c++17", "-I" + systems, "-o", folder + "/small", folder + "/small.cpp"], check=True)
        of_point = [*ANSWERS[:1], "hit m:1 - 1 0.5 0", *ANSWERS[2:]]
        found += wrong("ask.hpp", [folder + "/small"], QUESTION, of_point)
    print("\n".join(found) or "all answer as they should")
    sys.exit(bool(found))


main()
