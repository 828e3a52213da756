# How the program is called: help, version, and one line for every bad call.
. "$(dirname "$0")/harness.sh"
sample >scene.json

run 0 --help
has out '  check '
empty err
run 0 edit --help
has out --script
# help is --help, of the program and of every command.
run 0 --help
cp out program
run 0 help
same out program
run 0 conform run --help
cp out command
run 0 help conform run
same out command
refused 'help: tarce: no such command; expected trace — did you mean it?' help tarce
refused 'help: more: no such command; expected none below trace' help trace more
# A name of the Z text is told of by itself and by its English, in any case.
run 0 help radio?
has out 'radio?: radius'
has out '  text      spec/operaciones.tex:'
has out '  program   include/durero/model/tipo/esfera.hpp:'
for word in radio radius; do
  run 0 help $word
  has out 'radio?: radius'
  grep -vE '^  ' out >$word
done
same radio radius
run 0 help Sphere
has out 'esfera: sphere'
has out 'Agregar_Esfera'
cp out sphere
run 0 help esfera
same out sphere
run 0 help truncated cone
has out 'tronco: truncated_cone'
run 0 help TruncatedCone
has out 'tronco: truncated_cone'
run 0 help Escena
has out 'spec/escena.tex:'
has out 'include/durero/model/escena.hpp:'
run 0 help ojo
has out '  Ventana'
run 0 help Point
has out 'program   include/durero/model/tipos.hpp:'
empty err
run 0 help check  # the command, not what a name may mean
has out '--format'
refused 'help: raido: no such command and no such name of the text; expected radio — did you mean it?' help raido
refused 'help: xyzzy: no such command; expected one of check, edit, ' help xyzzy
run 0 --version
lines out 1
has out 'durero '

# Every bad call is told by what is wrong in it, and what is expected there: the near word where one is near.
refused 'no command; expected one of check, edit, ' 
refused 'frobnicate: no such command; expected one of check, edit, ' frobnicate
refused 'tarce: no such command; expected trace — did you mean it?' tarce scene.json rays
refused 'tarce: no such command; expected trace — did you mean it?' tarce --help
refused 'conform: jugde: no such command; expected judge' conform jugde --help
refused 'conform: jugde: no such command; expected judge' conform jugde suite hits
refused 'conform: no command; expected one of list, make, ' conform
refused 'conform: trace: no such command here; expected durero trace' conform trace
refused 'judge: no such command here; expected durero conform judge' judge suite hits
refused 'trace: --enginee: no such option; expected --engine — did you mean it?' trace scene.json rays --enginee exact
refused 'trace: --enginee: no such option; expected --engine' trace --enginee=exact
refused 'conform run: --timeuot: no such option; expected --timeout' conform run glm --timeuot 3
refused 'check: --frobnicate: no such option; expected one of -h, --help' check scene.json --frobnicate
refused 'check: -x: no such option; expected ' check -x scene.json
refused 'check: --fineness: no option of this command; expected it with durero agree' check scene.json --fineness 1
refused 'render: --audit: no option of this command; expected it with one of durero edit, durero store edit, durero store verify' render scene.json --audit
refused 'check: SCENE: it is missing; expected durero check [OPTION]... SCENE' check
refused 'trace: RAYS: it is missing; expected durero trace [OPTION]... SCENE RAYS' trace scene.json
refused 'export: --output: it is missing; expected durero export [OPTION]... --output FILE SCENE' export scene.json
refused 'trace: --engine: its value is missing; expected --engine ENGINE' trace scene.json rays --engine
refused 'trace: --threads: its value is missing; expected --threads N' trace scene.json rays --threads
refused 'check: other.json: an argument too many; expected durero check [OPTION]... SCENE' check scene.json other.json
refused 'check: check: an argument too many; expected ' check scene.json check other.json
refused 'conform run: --continue: it says nothing alone; expected --report with it' conform run glm --continue
refused 'trace: --engine magic: no such engine; expected one of sampled, exact, analytic, ' \
  trace scene.json rays --engine magic
refused 'trace: --engine exat: no such engine; expected exact' trace scene.json rays --engine exat
refused 'conform make: --family tinny: no such family; expected tiny' conform make new --family generic,tinny
refused 'conform make: --types esfea: no such type; expected esfera' conform make new --types esfea
refused 'conform make: --numbers binary46: no such format; expected binary64' conform make new --numbers binary46
refused 'no system "embre"; expected embree' conform run embre
refused 'completion: SHELL csh: no such shell; expected zsh' completion csh
refused 'man: rnu: no such command; expected run' man conform rnu
absent new

# An option that takes one value is given once; what may be given again is a list, or says the same.
refused 'trace: --engine: it is given 2 times; expected once' trace scene.json rays --engine exact --engine exact
refused 'agree: --seed: it is given 3 times; expected once' agree scene.json --seed 1 --seed 2 --seed 3
refused 'render: --output: it is given 2 times; expected once' render scene.json -o a.png --output b.png
refused 'edit: --audit: it takes no value; expected --audit alone' edit scene.json --audit=no
run 0 conform list --json --json
cp out once
run 0 conform list --json
same out once

refused 'nowhere.json: cannot be read: No such file or directory' check nowhere.json
refused '.: cannot be read: Is a directory' check .
refused 'scene.step: a format that is not known by this name' export scene.json -o scene.step
refused 'scene.step: a format that is not known by this name' import scene.step -o out.json
absent scene.step

# Whatever the bytes of an argument, of a file's name or of a file: a terminal prints the message and does not obey it.
escape=$(printf '\033[2J\233\n.')
escape=${escape%.}
refused '\x1b[2J\x9b\x0a: no such command; expected ' "$escape"
refused '\x1b[2J\x9b: cannot be read: No such file or directory' check "${escape%?}"
refused '\x1b[2J\x9b\x0a: cannot be read: No such file or directory' check "$escape"
refused 'trace: --engine \x1b[2J\x9b\x0a: no such engine; expected ' trace scene.json rays --engine "$escape"
refused 'scene\x1b[2J\x9b\x0a: a format that is not known' export scene.json -o "scene$escape"
cp scene.json "$(printf 'a\033b')"
run 0 check "$(printf 'a\033b')"
has out 'a\x1bb: 3 elementos'
printf '{"\033[2J\302\233' >bad
refused 'bad:1:3: "\x1b" stands here inside a string' check bad
finish
