# durero fractal: the same bytes at every call, and calls that are refused.
. "$(dirname "$0")/harness.sh"
for kind in menger julia; do
  run 0 fractal $kind -o one.png --size 24x15 --samples 2 --threads 1
  empty out
  empty err
  run 0 fractal $kind -o four.png --size 24x15 --samples 2 --threads 4
  same one.png four.png
  run 0 fractal $kind -o more.png --size 24x15 --samples 3
  cmp -s one.png more.png && fail "$kind: more samples change nothing"
done
run 0 fractal menger --level 1 -o coarse.png --size 24x15 --samples 2
run 0 fractal menger --level 2 -o fine.png --size 24x15 --samples 2
cmp -s coarse.png fine.png && fail 'another level changes nothing'
refused 'fractal: KIND sierpinski: no such fractal; expected one of menger, julia' fractal sierpinski -o new.png
refused 'fractal: --size 0x9: no size; expected WxH' fractal menger -o new.png --size 0x9
refused 'new.jpg: ' fractal menger -o new.jpg
refused 'fractal: --level 13: no whole number from 0 to 12' fractal menger -o new.png --level 13
absent new.png
absent new.jpg
finish
