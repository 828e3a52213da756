# durero check: a good scene, summed up with every invariant.
. "$(dirname "$0")/harness.sh"
sample >scene.json
run 0 check scene.json
empty err
lines out 10
has out 'scene.json: 3 elementos: 1 esfera, 1 cilindro, 1 cono, 0 tronco, 0 plano, 0 disco, 0 triangulo'
for n in 1 2 3 4 5 6 7 8 9; do has out "Escena.inv.$n ok: "; done
"$durero" check - <scene.json >out || fail "check -"
has out '<stdin>: 3 elementos'
finish
