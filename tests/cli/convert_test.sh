# durero import and export: NFF there and back, and what is lost on the way.
. "$(dirname "$0")/harness.sh"
cat >scene.nff <<'TEXT'
b 0.1 0.2 0.3
v
from 0 0 -5
at 0 0 0
up 0 1 0
angle 45
hither 0
resolution 64 48
l 1 2 3 1 1 1
f 1 0.5 0 1 0 0 0 1
s 1 2 3 4
c 0 0 0 2 0 0 3 2
c 1 2 3 0.5 1 6 3 0
TEXT
run 0 import scene.nff -o scene.json
empty out
empty err
run 0 check scene.json
has out '3 elementos: 1 esfera, 1 cilindro, 1 cono, 0 tronco, 0 plano, 0 disco, 0 triangulo'
run 0 export scene.json -o back.nff
lines err 2
has err 'durero: back.nff: 3 names of elements left out: NFF has none'
run 0 import back.nff -o back.json
same scene.json back.json
run 0 export scene.json -o copy.json
same scene.json copy.json
empty err

# What a scene cannot hold is named; the rest is kept.
printf 'p 3\n0 0 0 1 0 0 0 1 0\nc 0 0 0 2 0 0 3 1\ns 0 0 0 1\n' >more.nff
run 0 import more.nff -o more.json
lines err 1
has err 'durero: more.nff: 1 polygon left out: a scene has none'
run 0 check more.json
has out '2 elementos: 1 esfera, 0 cilindro, 0 cono, 1 tronco, 0 plano, 0 disco, 0 triangulo'

printf 's 0 0 0 1\ns 0 0 0 0\n' >bad.nff
refused 'bad.nff:2:9: radio_no_positivo; expected radio? ∈ Rmas (Agregar_Esfera.pre.2)' import bad.nff -o bad.json
absent bad.json
finish
