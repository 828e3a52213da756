#!/usr/bin/env python3
"""mesh_audit.py DURERO: what this program and others find wrong with the same meshes.

Prints the table of docs/mesh-audit.md. The meshes are made here. The others are asked where they are installed: MeshLab
(pymeshlab), Open3D, trimesh and, where its headers and a compiler are there, CGAL (mesh_audit.cpp beside this script). Each says
whether it finds a thing or not; "-" stands where it has no such question.
"""
import fractions
import importlib
import json
import math
import pathlib
import subprocess
import sys
import tempfile

HERE = pathlib.Path(__file__).resolve().parent
SMALL = 2.0**-46  # what is cut or left at a touch, beside coordinates of about 1

TETRAHEDRON = ([(0, 0, 0), (3, 0, 0), (0, 3, 0), (0, 0, 3)], [(0, 2, 1), (0, 1, 3), (1, 2, 3), (0, 3, 2)])


def moved(mesh, x, y, z):
    """The mesh elsewhere."""
    return [(px + x, py + y, pz + z) for px, py, pz in mesh[0]], mesh[1]


def both(a, b):
    """Two meshes as one, without a vertex in common."""
    return a[0] + b[0], a[1] + [tuple(i + len(a[0]) for i in face) for face in b[1]]


def welded(mesh):
    """The mesh with each point once."""
    points = sorted(set(mesh[0]))
    at = {point: i for i, point in enumerate(points)}
    return points, [tuple(at[mesh[0][i]] for i in face) for face in mesh[1]]


def ball(turns):
    """A closed ball of triangles."""
    points = [(0.0, 0.0, 1.0)] + [(math.sin(math.pi * i / turns) * math.cos(2 * math.pi * j / turns),
                                   math.sin(math.pi * i / turns) * math.sin(2 * math.pi * j / turns),
                                   math.cos(math.pi * i / turns))
                                  for i in range(1, turns) for j in range(turns)] + [(0.0, 0.0, -1.0)]
    at = lambda i, j: 1 + (i - 1) * turns + j % turns  # noqa: E731
    faces = [(0, at(1, j), at(1, j + 1)) for j in range(turns)]
    faces += [f for i in range(1, turns - 1) for j in range(turns)
              for f in ((at(i, j), at(i + 1, j), at(i + 1, j + 1)), (at(i, j), at(i + 1, j + 1), at(i, j + 1)))]
    return points, faces + [(len(points) - 1, at(turns - 1, j + 1), at(turns - 1, j)) for j in range(turns)]


def dart(tip):
    """A tetrahedron whose lowest corner is at the height `tip` above the middle of the tetrahedron's base, beneath it."""
    return [(1.0, 1.0, tip), (1.25, 1.0, -2.0), (1.0, 1.25, -2.0), (0.75, 0.75, -2.0)], [(0, 1, 2), (0, 2, 3), (0, 3, 1), (1, 3, 2)]


def meshes():
    """Each mesh by what it is."""
    points, faces = TETRAHEDRON
    yield "a closed ball of 4,900 faces", ball(50)
    yield "the same without a face", (ball(50)[0], ball(50)[1][1:])
    yield "a face turned over", (points, [(0, 1, 2)] + faces[1:])
    yield "a face twice", (points, faces + faces[:1])
    yield "two that share an edge", welded(both(TETRAHEDRON, ([(0, 0, 0), (3, 0, 0), (0, -3, 0), (0, 0, -3)],
                                                              [(0, 1, 2), (0, 3, 1), (1, 3, 2), (0, 2, 3)])))
    yield "two that share a vertex", welded(both(TETRAHEDRON, moved(TETRAHEDRON, 3, 0, 0)))
    yield "an edge with a vertex within", ([(0, 0, 0), (2, 0, 0), (0, 2, 0), (0, 0, 2), (1, 0, 0)],
                                           [(0, 2, 1), (0, 4, 3), (4, 1, 3), (1, 2, 3), (0, 3, 2)])
    yield "two that cut each other", both(TETRAHEDRON, moved(TETRAHEDRON, 0.5, 0.5, 0.5))
    yield "a tip 2⁻⁴⁶ within a face", both(TETRAHEDRON, dart(SMALL))
    yield "a tip on a face", both(TETRAHEDRON, dart(0.0))
    yield "a tip 2⁻⁴⁶ before a face", both(TETRAHEDRON, dart(-SMALL))
    yield "two in one plane that overlap", both(([(0, 0, 0), (2, 0, 0), (0, 2, 0)], [(0, 1, 2)]),
                                                ([(0.5, 0.5, 0), (2, 2, 0), (0, 3, 0)], [(0, 1, 2)]))
    yield "a fold along an edge", ([(0, 0, 0), (2, 0, 0), (0, 2, 0), (1, 1, 0)], [(0, 1, 2), (1, 0, 3)])
    yield "a tetrahedron of volume 9/2, 2³⁰ away", moved(TETRAHEDRON, 2.0**30, 2.0**30, 2.0**30)


QUESTIONS = ("open", "multiple", "turned", "singular", "twice", "crossing", "volume")


def durero(program, mesh, folder):
    """What this program finds."""
    path = folder / "mesh.obj"
    path.write_text("".join(f"v {x!r} {y!r} {z!r}\n" for x, y, z in mesh[0])
                    + "".join("f " + " ".join(str(i + 1) for i in face) + "\n" for face in mesh[1]))
    said = json.loads(subprocess.run([program, "check", "--mesh", path, "--format", "json"], capture_output=True, text=True).stdout)
    kinds = {finding["kind"] for finding in said["findings"]}
    names = dict(zip(QUESTIONS, ("abiertas", "multiples", "discordes", "singulares", "repetidas", "cruzadas")))
    volume = said.get("volume")
    if volume is not None and len(volume) > 40:
        volume = float(fractions.Fraction(volume))
    return {question: name in kinds for question, name in names.items()} | {"volume": volume}


def meshlab(module, mesh, _):
    """What MeshLab finds. Its volume is told of closed meshes alone."""
    import numpy
    meshes = module.MeshSet()
    meshes.add_mesh(module.Mesh(numpy.array(mesh[0], float), numpy.array(mesh[1])))
    told = meshes.get_topological_measures()
    found = {"open": told["boundary_edges"] > 0, "multiple": told["non_two_manifold_edges"] > 0,
             "singular": told["non_two_manifold_vertices"] > 0}
    meshes.compute_selection_by_self_intersections_per_face()
    found["crossing"] = meshes.current_mesh().selected_face_number() > 0
    before = meshes.current_mesh().face_number()
    found["volume"] = meshes.get_geometric_measures().get("mesh_volume")
    meshes.meshing_remove_duplicate_faces()
    return found | {"twice": meshes.current_mesh().face_number() < before}


def open3d(module, mesh, _):
    """What Open3D finds."""
    of = module.geometry.TriangleMesh(module.utility.Vector3dVector(mesh[0]), module.utility.Vector3iVector(mesh[1]))
    found = {"multiple": not of.is_edge_manifold(True), "singular": not of.is_vertex_manifold(), "crossing": of.is_self_intersecting()}
    if not found["multiple"]:
        found["open"] = not of.is_edge_manifold(False)
    if of.is_watertight() and of.is_orientable():
        found["volume"] = of.get_volume()
    faces = len(of.triangles)
    return found | {"twice": len(of.remove_duplicated_triangles().triangles) < faces}


def trimesh(module, mesh, _):
    """What trimesh finds. It gives a volume whatever the mesh; that of a mesh that is not watertight is left out."""
    of = module.Trimesh(vertices=mesh[0], faces=mesh[1], process=False)
    found = {"turned": not of.is_winding_consistent, "twice": bool((~of.unique_faces()).any())}
    if of.is_watertight:
        found |= {"open": False, "volume": float(of.volume)}
    elif len(module.grouping.group_rows(of.edges_sorted, require_count=1)):
        found["open"] = True
    return found


def cgal(program, mesh, folder):
    """What CGAL finds of what is a mesh to it."""
    path = folder / "mesh.off"
    path.write_text(f"OFF\n{len(mesh[0])} {len(mesh[1])} 0\n" + "".join(f"{x!r} {y!r} {z!r}\n" for x, y, z in mesh[0])
                    + "".join("3 " + " ".join(map(str, face)) + "\n" for face in mesh[1]))
    said = json.loads(subprocess.run([program, path], capture_output=True, text=True, check=True).stdout)
    return said


def built_cgal(folder):
    """The program that asks CGAL, or None."""
    program = folder / "mesh_audit"
    made = subprocess.run(["c++", "-std=c++17", "-O1", "-o", program, HERE / "mesh_audit.cpp", "-lgmp", "-lmpfr"], capture_output=True)
    return program if made.returncode == 0 else None


def told(found, question):
    """A cell: yes, no, or a number as short as it is."""
    answer = found.get(question)
    if answer is None:
        return "-"
    return {True: "yes", False: "no"}[answer] if isinstance(answer, bool) else answer if isinstance(answer, str) else f"{answer:.12g}"


def main():
    """Asks them all, and prints a row for each mesh and question on which they are not of one mind, or one where they are."""
    program = sys.argv[1]
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        asked = {"Durero": (durero, program)}
        for title, ask, module in (("MeshLab", meshlab, "pymeshlab"), ("Open3D", open3d, "open3d"), ("trimesh", trimesh, "trimesh")):
            try:
                asked[title] = (ask, importlib.import_module(module))
            except ImportError as absent:
                print(f"{title} is not asked: {absent}", file=sys.stderr)
        at = built_cgal(folder)
        if at:
            asked["CGAL"] = (cgal, at)
        else:
            print("CGAL is not asked: mesh_audit.cpp does not compile here", file=sys.stderr)
        print("| mesh | question | " + " | ".join(asked) + " |")
        print("| --- | --- |" + " --- |" * len(asked))
        for mesh_name, mesh in meshes():
            answers = {title: ask(what, mesh, folder) for title, (ask, what) in asked.items()}
            first = True
            for question in QUESTIONS:
                cells = [told(answers[title], question) for title in asked]
                of_interest = cells[0] == "yes" or (question == "volume" and cells[0] != "-") or len({c for c in cells if c != "-"}) > 1
                if of_interest:
                    print(f"| {mesh_name if first else ''} | {question} | " + " | ".join(cells) + " |")
                    first = False


if __name__ == "__main__":
    main()
