// Surfaces of revolution: a lathe of lines is three elements, a sor two lids and a Z text, and a lathe of curves a Z text.
#version 3.7;
#default { pigment { rgb 1 } }
lathe { linear_spline 4, <0, 0>, <2, 2>, <2, 3>, <0, 3> }
sor { 5, <1, -1>, <1, 0>, <2, 1>, <1, 3>, <0, 4> translate 5 * x }
lathe { cubic_spline 4, <1, 0>, <1, 1>, <2, 2>, <1, 3> translate 10 * x }
lathe { 2, <-1, 0>, <1, 2> translate 15 * x }
