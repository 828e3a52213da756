// Calls for whoever answers them, one a line: rays at the cases of a suite, scenes, edits, texts of Z right and wrong,
// expressions, and calls that are none.
//   node calls.js ROOT SUITE
"use strict";
const fs = require("fs"), path = require("path");
const [root, suite] = process.argv.slice(2);
const read = (...parts) => fs.readFileSync(path.join(...parts), "utf8");
const files = (folder, end) => fs.readdirSync(path.join(root, folder)).filter(name => name.endsWith(end)).sort()
  .map(name => path.join(folder, name));
const ask = call => process.stdout.write(JSON.stringify(call) + "\n");

// Every ray of the suite, and of some cases one ray alone, with every crossing and its shadows.
for (const family of fs.readdirSync(suite).filter(name => !name.includes(".")).sort())
  for (const name of fs.readdirSync(path.join(suite, family)).filter(name => name.endsWith(".scene.json")).sort()) {
    const scene = read(suite, family, name), rays = read(suite, family, name.replace("scene.json", "rays.txt"));
    ask({ call: "trace", scene, rays });
    if (!/[05]\.scene/.test(name)) continue;
    const [numbers, ...on] = rays.split("\n").find(line => /^[-0-9]/.test(line)).split(" @");
    const of = numbers.trim().split(/ +/).map(Number);
    for (const call of ["ray", "light"]) ask({ call, scene, p: of.slice(0, 3), v: of.slice(3), on });
  }

// What there is, and what the program carries.
for (const call of ["version", "text", "labels", "errata", "operations"]) ask({ call });
for (const file of files("spec", ".tex")) ask({ call: "text", file });

for (const file of ["demo/still-life.json", "demo/mirrors.json", ...files("demo/gallery", ".json")]) {
  const scene = read(root, file);
  ask({ call: "check", scene });
  ask({ call: "render_shader", scene, writes: "color" });
  ask({ call: "ray", scene, p: [0.1, 0.2, 9], v: [0, 0, -1] });
}
ask({ call: "edit", scene: read(root, "demo/still-life.json"),
  operations: read(root, "demo/edits.txt").split("\n").filter(line => line && !line.startsWith("#")) });

for (const file of [...files("tests/zed/corpus/right", ".tex"), ...files("tests/zed/corpus/wrong", ".tex"), ...files("spec", ".tex"),
  "demo/birthday_book.tex"]) ask({ call: "zed.check", name: file, text: read(root, file) });
ask({ call: "zed.run", text: read(root, "demo/birthday_book.tex"), setup: { given: { NAME: ["ann", "bob"], DATE: 2 } } });
for (const file of files("demo/surfaces", ".tex")) ask({ call: "surface", with: read(root, file) });
for (const name of ["cubic", "ellipsoid", "hyperboloid", "torus"])
  ask({ call: "surface", with: read(root, "demo/surfaces", name + ".tex"), scene: read(root, "demo/surfaces", name + ".json"),
    width: 24, height: 18 });

// Numbers: small and great, quotients to both sides, roots; sets, sequences and bags; what is not decided, and what is wrong.
const great = "123456789012345678901234567890";
for (const expression of [`${great} * ${great} * ${great}`, `${great} div 9876543210987`, `(-${great}) div 9876543210987`,
  `${great} mod 9876543210987`, `(-${great}) mod 9876543210987`, "-7 div 2", "7 div (-2)", "-7 mod 2", "0.1 + 0.2 = 0.3", "1 / 3 + 1 / 6",
  "(1 / 3) * (3 / 7) - 1", "1 / 0", "7 div 0", "{ x : 1 .. 30 | x mod 3 = 1 @ x * x }", "# (1 .. 1000)", "(1 .. 50) \\ (20 .. 70)",
  "rev ⟨3, 1, 2⟩ ⌢ ⟨4⟩", "(λ n : 0 .. 9 @ n * n) (7)", "∃ x : ℕ @ x * x = 1764", "∀ x : 0 .. 40 @ x * x ≥ x", "∃ x : ℕ @ x * x = 2",
  "μ x : 1 .. 9 | x * x = 49 @ x", "{1, 2} × {3, 4}", "ℙ {1, 2, 3}", "dom {1 ↦ 2, 3 ↦ 4}", "items ⟨1, 2, 1⟩", "1 +", "foo", "(1, 2).3",
  "{ x : ℤ | x > 0 }", "(".repeat(450) + "1" + ")".repeat(450)]) {
  ask({ call: "eval", expression });
  ask({ call: "eval", expression, explain: true });
}
ask({ call: "eval", expression: "elementos", scene: read(root, "demo/still-life.json") });

process.stdout.write("[]\nnull\n{\n{\"call\":\"nothing\"}\n{\"call\":\"trace\",\"sceen\":1}\n" + "[".repeat(100000) + "\n");
ask({ call: "eval", expression: "(".repeat(100000) });
ask({ call: "trace", scene: "{\"format\":\"durero-scene\",\"version\":1,\"elementos\":[{\"id\":\"a\",\"tipo\":\"esfera\",\"centro\":[0,0,1e999],\"radio\":-1}]}",
  rays: "0 0 0 0 0 1" });
for (const digits of ["1e-400", "2.4703282292062327e-324", "2.4703282292062328e-324", "1.7976931348623158e308", "1.7976931348623159e308", "0x1.8p-1074",
  "0x1p1024", "9007199254740993", "9007199254740992.99999999999999999999999", "1e23", "nan", "inf", "-0", "1e", "0x", ".5", "5.", "1e+5"])
  ask({ call: "trace", scene: read(root, "demo/still-life.json"), rays: `${digits} 0 0 0 0 1\n0 0 -5 ${digits} 0 1\n` });
