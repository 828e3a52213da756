// What no scene has: each is named with its number, and one sphere is kept.
#version 3.7;
sphere { 0, 1 pigment { marble } normal { bumps 0.5 } }
torus { 2, 0.5 }
poly { 5, <0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1> }
blob { threshold 0.5 sphere { 0, 1, 1 scale <1, 2, 1> } }
superellipsoid { <0.3, 0.7> }
ovus { 1, 0.5 }
isosurface { function { sin(x) } contained_by { box { -1, 1 } } }
sphere { 0, 2 clipped_by { plane { y, 0 } } }
fog { distance 9 rgb 1 }
text { ttf "none.ttf" "A" 1, 0 }
