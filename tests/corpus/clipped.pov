// Clips and bounds: what is clipped takes a Z text, and a bound that may cut is told of.
#version 3.7;
#default { pigment { rgb 1 } }
sphere { 0, 1 clipped_by { plane { y, 0 } } }
box { -1, 1 clipped_by { sphere { 0, 1.25 } } translate 4 * x }
disc { 0, y, 2, 1 translate 8 * x }
sphere { 0, 1 bounded_by { box { -1, 1 } } translate 12 * x }
sphere { 0, 1 bounded_by { box { -1, 0.5 } } translate 16 * x }
sphere { 0, 1 clipped_by { union { plane { y, 0 } plane { x, 0 } } } translate 20 * x }
