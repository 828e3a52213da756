// +W4 -h3
camera { location <0, 0, -5> right -x up y angle 40 look_at 0 }
plane { <1, 2, 2>, 3 pigment { checker rgb 1 rgb 0 } }
object { sphere { 0, 1 } pigment { rgbt <1, 1, 0, 0.5> } interior { ior 2 } no_shadow }
object { sphere { 0, 1 } no_image no_reflection }
