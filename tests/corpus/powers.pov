// Superellipsoids, blobs and isosurfaces take a Z text, as far as they are algebraic.
#version 3.7;
#default { pigment { rgb 1 } }
superellipsoid { <0.5, 0.25> }
superellipsoid { <1, 2> translate 3 * x }
blob { threshold 0.5 sphere { 0, 2, 1 } cylinder { 0, x, 1, strength 1 pigment { rgb y } } translate 6 * x }
#declare R = 1.5;
isosurface { function { x*x*y + z - R*x } contained_by { sphere { 0, 1 } } translate 9 * x }
