# durero shader: shaders of each output and a page, the same bytes at every call; the page in a browser, where there is one;
# the refusals.
. "$(dirname "$0")/harness.sh"
cp "$(dirname "$0")/../../demo/gallery/shader.json" "$(dirname "$0")/../../demo/gallery/still-life-in-a-room.json" .
run 0 shader shader.json -o one.frag
empty out
empty err
run 0 shader shader.json -o two.frag --writes color
same one.frag two.frag
has one.frag '#version 300 es'
has one.frag '// 0 mirror'
for output in answer doubts; do
  run 0 shader shader.json -o other.frag --writes $output
  diff one.frag other.frag >difference
  lines difference 4
done
run 0 shader shader.json -o page.html
has page.html '<title>shader.json</title>'

# A browser draws by the page, and counts doubtful pixels; in an address without what the shader needs it would say so.
chromium=$(command -v chromium || command -v chromium-browser) || chromium=
if [ -n "$chromium" ]; then
  timeout 200 "$chromium" --headless --no-sandbox --use-gl=angle --use-angle=swiftshader --enable-unsafe-swiftshader \
    --user-data-dir="$PWD/profile" --window-size=320,240 --virtual-time-budget=20000 --dump-dom \
    "file://$PWD/page.html#show-doubts" >drawn.html 2>err
  called="$chromium page.html"
  has drawn.html 'pixels doubtful</output>'
  has drawn.html '<div id="trouble" role="alert" hidden=""></div>'
else
  echo 'no chromium: the page is opened by no browser'
fi

sed 's/"color":\[0.82/"gloss":20,&/' shader.json >gloss.json
refused 'gloss.json: material red has a gloss; expected none in a shader' shader gloss.json -o new.frag
refused "still-life-in-a-room.json: the environment is a picture" shader still-life-in-a-room.json -o new.html
refused 'new.glsl: not a shader' shader shader.json -o new.glsl
refused 'shader: --writes answer: a page' shader shader.json -o new.html --writes answer
refused 'shader: --writes normals: no such output' shader shader.json -o new.frag --writes normals
refused 'absent.json: cannot be read' shader absent.json -o new.frag
absent new.frag
absent new.html
finish
