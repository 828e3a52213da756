// Transformations: one stays a sphere, one becomes a copy by a map, a cylinder turns, a plane moves.
#version 3.7;
#declare Aside = transform { rotate 90 * y translate 3 * x };
sphere { 0, 1 scale 2 translate <1, 2, 3> }
sphere { 0, 1 scale <1, 2, 1> }
cylinder { 0, y, 0.5 open transform { Aside } }
plane { y, 1 matrix <1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 2, 0> }
