#!/usr/bin/env python3
"""povray_texts.py DURERO: what a text says by its version, its gamma and the order of its camera's words is to `durero import` what
it is to POV-Ray, by POV-Ray's own pictures.

- A background and a surface in one term of light have the colours of POV-Ray's picture, for each version and each gamma; a byte
  may be off by one, where a component lies near the middle of two.
- A shaded picture is nearer to POV-Ray's than it is where the numbers are taken for linear light: by half at least.
- The words of a camera, in whatever order, are one camera to both.
- Expressions drawn at random have POV-Ray's values.
- Programs with names, loops, macros, transformations and solids show what they show in POV-Ray: but for pixels at outlines, no
  pixel differs by more than a little.

Exit status 77 (skipped) where POV-Ray is absent (Debian: povray).
"""
import json
import pathlib
import random
import re
import shutil
import subprocess
import sys
import tempfile

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "support"))
from png import png_pixels  # noqa: E402

SEED, ORDERS = 1, 12
SIZE = (32, 18)
VERSIONS = ["", "#version 3.5;", "#version 3.6;", "#version 3.7;", "#version unofficial 3.7;"]
GAMMAS = ["", "assumed_gamma 1", "assumed_gamma 1.8", "assumed_gamma 2.2", "assumed_gamma srgb", "assumed_gamma 2.2 assumed_gamma 1"]
CAMERA = "camera { location <0, 0, -3> right -x*16 up y*9 angle 60 look_at 0 }"
FLAT = """background { rgb <0.2, 0.3, 0.5> }
sphere { 0, 0.5 pigment { rgb <0.03, 0.6, 0.9> } finish { ambient 0.5 diffuse 0 } }"""
SHADED = """background { rgb <0.2, 0.3, 0.5> }
light_source { <3, 5, -6>, rgb <1, 0.9, 0.8> }
sphere { 0, 0.8 pigment { rgb <0.9, 0.4, 0.2> } finish { ambient 0 diffuse 0.8 } }
plane { y, -0.8 pigment { rgb 0.6 } finish { ambient 0 diffuse 0.8 } }"""
WORDS = ["location <1, 2, -7>", "look_at <0.5, 0.25, 0>", "angle 42", "right <-16, 0, 0>", "up <0, 9, 0>", "sky <0.25, 1, 0>",
         "direction <0, 0, 2>"]
EXPRESSIONS = 150
HEAD = """#version 3.7; global_settings { assumed_gamma 1 } #default { finish { ambient 0.2 diffuse 0.6 } }
light_source { <4, 7, -9>, rgb 1 } background { rgb <0.1, 0.2, 0.3> }
"""
VIEW = "camera { location <1, 2, -9> right x*16/9 up y angle 55 look_at <0, 0.5, 0> }\n"
PROGRAMS = {
    "transformations": VIEW + """
#declare Red = pigment { rgb <0.8, 0.2, 0.1> }
sphere { 0, 1 scale <1.5, 0.5, 1> rotate 30*z translate <-2.5, 1, 0> pigment { rgb <0.2, 0.7, 0.3> } }
cylinder { 0, 1.5*y, 0.5 rotate <20, 30, 40> scale 0.8 translate 2.5*x pigment { Red } }
cone { 0, 0.8, 1.5*y, 0.2 scale <1, 1, 2> matrix <1, 0.3, 0, 0, 1, 0, 0.2, 0, 1, 0, -0.5, 0> pigment { rgb <0.3, 0.3, 0.9> } }
disc { 0, y, 0.7 rotate -70*x translate <0, 2.2, 1> pigment { rgb 0.9 } }
plane { y, 0 rotate 5*z translate -y pigment { rgb <0.6, 0.6, 0.5> } }
union { triangle { 0, x, y } triangle { x, x + y, y } rotate 45*y scale <2, 0.5, 1> translate <-3, -0.5, -2> pigment { Red } }
""",
    "solids": VIEW + """
#declare Bitten = difference { box { -1, 1 } sphere { 0, 1.25 } }
object { Bitten rotate <20, 40, 0> translate <-2, 0.6, 0> pigment { rgb <0.9, 0.7, 0.2> } }
intersection { sphere { 0, 1 scale <1, 2, 1> } box { <-1, -1, -1>, <1, 1, 1> rotate 45*y } translate <1.5, 0.5, 0> pigment { rgb <0.2, 0.6, 0.8> } }
merge { sphere { 0, 0.5 } cylinder { 0, x, 0.2 } scale 1.5 translate <2.5, 2, 1> pigment { rgb 0.7 } }
box { <-4, -1.2, -2>, <4, -1, 4> pigment { rgb 0.5 } }
""",
    "loops": """
#declare Eye = <0, 3, -9>;
#macro Ring(N, R, What) #local I = 0; #while (I < N) object { What rotate 360*I/N*y translate R*vrotate(x, 360*I/N*y) } #local I = I + 1; #end #end
#declare Post = union { cylinder { 0, y, 0.2 } #for (K, 1, 3) sphere { K/3*y, 0.3 - K/20 } #end }
#declare Colors = array[3] { rgb x, rgb <0.2, 0.9, 0.3>, rgb <0.2, 0.4, 1> }
#declare S = seed(7);
camera { location Eye right -x*16/9 up y angle 50 look_at 0 }
union { Ring(8, 3, Post) pigment { Colors[1] } }
#for (J, 0, 20)
  sphere { <rand(S)*4 - 2, rand(S)*2, rand(S)*4 - 2>, 0.1 + rand(S)*0.3
    pigment { #switch (mod(J, 3)) #case (0) color Colors[0] #break #case (1) color Colors[1] #break #else color Colors[2] #end } }
#end
#if (defined(Post) & vlength(Eye) > 9) plane { y, 0 pigment { rgb 0.8 } } #else sphere { 0, 5 } #end
""",
    "a mesh and a moved camera": """
camera { location <0, 0, -6> right -x*16/9 up y angle 50 look_at 0 rotate <20, 30, 0> translate <0.5, 0.2, 0> }
mesh2 {
  vertex_vectors { 5, <-1, 0, -1>, <1, 0, -1>, <1, 0, 1>, <-1, 0, 1>, <0, 1.5, 0> }
  face_indices { 6, <0, 1, 4>, <1, 2, 4>, <2, 3, 4>, <3, 0, 4>, <0, 1, 2>, <0, 2, 3> }
  pigment { rgb <0.9, 0.6, 0.3> } rotate 20*y
}
union { light_source { 0, rgb 0.5 } sphere { 2*y, 0.3 pigment { rgb 1 } } translate <2, 1, -2> }
plane { y, -0.5 pigment { rgb 0.7 } }
""",
}
durero, failures = sys.argv[1], 0


def fail(what):
    global failures
    failures += 1
    print("FAILED:", what)


def by_povray(text, folder):
    (folder / "text.pov").write_text(text)
    call = ["povray", "+Itext.pov", "+Othere.ppm", "+FP8", f"+W{SIZE[0]}", f"+H{SIZE[1]}", "-A", "-D", "File_Gamma=sRGB"]
    said = subprocess.run(call, cwd=folder, capture_output=True, text=True)
    if said.returncode != 0:
        sys.exit(f"povray refuses\n{text}\n{said.stderr[-2000:]}")
    return (folder / "there.ppm").read_bytes()[-3 * SIZE[0] * SIZE[1] :]


def by_durero(text, folder):
    (folder / "text.pov").write_text(text)
    subprocess.run([durero, "import", folder / "text.pov", "-o", folder / "scene.json"], check=True, capture_output=True)
    size = "x".join(map(str, SIZE))
    subprocess.run([durero, "render", folder / "scene.json", "-o", folder / "here.png", "--size", size], check=True, capture_output=True)
    return png_pixels((folder / "here.png").read_bytes())[2], (folder / "scene.json").read_text()


def off(a, b):
    return [abs(x - y) for x, y in zip(a, b, strict=True)]


def colours(folder):
    for version in VERSIONS:
        for gamma in GAMMAS:
            text = f"{version}\n{f'global_settings {{ {gamma} }}' if gamma else ''}\n{CAMERA}\n{FLAT}\n"
            there, (here, _) = by_povray(text, folder), by_durero(text, folder)
            # The ball's outline is not compared: a corner and the middle are.
            middle = 3 * (SIZE[1] // 2 * SIZE[0] + SIZE[0] // 2)
            for at, what in ((0, "the background"), (middle, "the ball")):
                if max(off(here[at : at + 3], there[at : at + 3])) > 1:
                    fail(f"{version} {gamma}: {what} is {tuple(here[at:at + 3])}, of POV-Ray {tuple(there[at:at + 3])}")


def shading(folder):
    for gamma in ("", "global_settings { assumed_gamma 2.2 }"):
        text = f"{gamma}\n{CAMERA}\n{SHADED}\n"
        there = by_povray(text, folder)
        here = sum(off(by_durero(text, folder)[0], there))
        linear = sum(off(by_durero(f"#version 3.7; {CAMERA}\n{SHADED}", folder)[0], there))
        print(f"{gamma or 'no gamma'}: off by {here / len(there):.1f} of 255 in the mean, and by {linear / len(there):.1f} as linear light")
        if 2 * here > linear:
            fail(f"{gamma}: no nearer to POV-Ray's picture than linear light")


def cameras(folder):
    rng, words = random.Random(SEED), list(WORDS)
    first = None
    for _ in range(ORDERS):
        text = f"#version 3.7;\ncamera {{ {' '.join(words)} }}\n{SHADED}\n"
        there, (_, scene) = by_povray(text, folder), by_durero(text, folder)
        first = first or (there, scene)
        if sum(x > 2 for x in off(there, first[0])) > 6:
            fail(f"seed {SEED}: POV-Ray sees another picture by {' '.join(words)}")
        if scene != first[1]:
            fail(f"seed {SEED}: another scene by {' '.join(words)}")
        rng.shuffle(words)


def expression(rng, depth):
    """Of a number, whose value is neither huge nor close to where a function jumps."""
    if depth == 0:
        return rng.choice([f"{rng.uniform(0.1, 4):.3f}", f"{rng.randint(1, 9)}", "pi", f"({rng.uniform(-4, -0.1):.2f})"])
    a, b = expression(rng, depth - 1), expression(rng, rng.randrange(depth))
    return rng.choice([f"{a} + {b}", f"({a} - {b})", f"({a})*({b})", f"({a})/(2 + abs({b}))", f"-({a})", f"sin({a})", f"sqrt(abs({a}))",
                       f"<{a}, {b}, 2>.y", f"vlength(<{a}, {b}, 1>)", f"vdot(<1, {a}, 2>, <{b}, 3, 4>)", f"vcross(<{a}, 1, 2>, <3, {b}, 4>).z",
                       f"vrotate(<1, 2, 3>, <{a}, {b}, 5>).x", f"vaxis_rotate(<1, 2, 3>, <1, {b}, 1>, {a}).y", f"select({a}, {b}, 3)",
                       f"({a} > {b} ? {a} : 2)", f"atan2({a}, 2 + abs({b}))", f"pow(1.5, sin({a}))", f"max({a}, {b}, 1)",
                       f"strlen(str({a}, 0, 3))"])


def expressions(folder):
    rng = random.Random(SEED)
    asked = [expression(rng, 3) for _ in range(EXPRESSIONS)]
    debug = "".join(f'#debug concat(str({e}, 0, 17), "\n")\n' for e in asked)
    (folder / "text.pov").write_text(f"#version 3.7;\n{debug}sphere {{ 0, 1 }} camera {{ }}")
    said = subprocess.run(["povray", "+Itext.pov", "-D", "-F", "+W4", "+H4"], cwd=folder, capture_output=True, text=True).stderr
    there = [float(line) for line in said.splitlines() if re.fullmatch(r"-?\d+\.\d{17}", line)]
    if len(there) != len(asked):
        sys.exit(f"POV-Ray says {len(there)} of {len(asked)} values\n{said[-2000:]}")
    balls = "".join(f"sphere {{ <{e}, 0, 0>, 1 }}\n" for e in asked)
    (folder / "text.pov").write_text(balls)
    subprocess.run([durero, "import", folder / "text.pov", "-o", folder / "scene.json"], check=True, capture_output=True)
    by_name = {e["id"]: e["centro"][0] for e in json.loads((folder / "scene.json").read_text())["elementos"]}
    for i, (e, value) in enumerate(zip(asked, there, strict=True)):
        if abs(by_name[f"s{i + 1}"] - value) > 1e-9 * max(1, abs(value)):
            fail(f"seed {SEED}: {e} is {by_name[f's{i + 1}']}, of POV-Ray {value}")


def programs(folder):
    global SIZE
    SIZE = (160, 90)
    for name, text in PROGRAMS.items():
        there, (here, _) = by_povray(HEAD + text, folder), by_durero(HEAD + text, folder)
        wrong = sum(max(off(here[i : i + 3], there[i : i + 3])) > 12 for i in range(0, len(there), 3))
        print(f"{name}: {wrong} of {SIZE[0] * SIZE[1]} pixels differ by more than 12 of 255")
        if wrong > 60 or len(set(zip(there[::3], there[1::3], there[2::3]))) < 20:
            fail(f"{name}: another picture")


if shutil.which("povray") is None:
    print("skipped: POV-Ray is absent (Debian: povray)")
    sys.exit(77)
with tempfile.TemporaryDirectory() as name:
    for check in (colours, shading, cameras, expressions, programs):
        check(pathlib.Path(name))
print(f"{len(VERSIONS) * len(GAMMAS)} gammas, {ORDERS} orders, {EXPRESSIONS} expressions, {len(PROGRAMS)} programs, {failures} failures")
sys.exit(failures > 0)
