// povray +W640 +H400 -A File_Gamma=sRGB
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 6 adc_bailout 0 }
camera { location <1, 5, -9> right <-1.6, 0, 0> up y angle 38 look_at <0, 0.8, 0> }
background { rgb <0.3, 0.4, 0.6> }
light_source { <-6, 9, -7>, rgb 1 }
plane { y, 0 pigment { rgb <0.5, 0.45, 0.4> } finish { ambient 0.1 diffuse 0.7 } }
// A box in a ball without three rods.
difference {
  intersection {
    box { <-1, 0, -1>, <1, 2, 1> }
    sphere { <0, 1, 0>, 1.3 }
  }
  union {
    cylinder { <-2, 1, 0>, <2, 1, 0>, 0.55 }
    cylinder { <0, -1, 0>, <0, 3, 0>, 0.55 }
    cylinder { <0, 1, -2>, <0, 1, 2>, 0.55 }
  }
  pigment { rgb <0.8, 0.5, 0.2> }
  finish { ambient 0.1 diffuse 0.6 phong 0.5 phong_size 40 }
}
// A rocket, without walls where its parts meet.
merge {
  cylinder { <-3, 0.5, 0>, <-3, 1.5, 0>, 0.6 }
  cone { <-3, 1.5, 0>, 0.6, <-3, 2.75, 0>, 0 }
  cone { <-3, 0, 0>, 0.9, <-3, 0.75, 0>, 0.25 }
  pigment { rgb <0.8, 0.2, 0.2> }
  finish { ambient 0.1 diffuse 0.7 }
}
// Half a ball, hollow, of a mirror.
difference {
  intersection {
    sphere { <3, 1, 0>, 1 }
    plane { y, 1 }
  }
  sphere { <3, 1, 0>, 0.875 }
  pigment { rgb <0.5, 0.6, 0.5> }
  finish { ambient 0.1 diffuse 0.4 reflection 0.4 }
}
