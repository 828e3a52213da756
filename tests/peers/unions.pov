// povray +W320 +H180 -A File_Gamma=sRGB
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 8 adc_bailout 0 }
camera { location <0, 4, -9> right <-16, 0, 0> up <0, 9, 0> angle 55 look_at <0, 0.75, 0> }
background { rgb <0.2, 0.3, 0.5> }
light_source { <5, 9, -6>, rgb 0.75 }
light_source { <-6, 8, -2>, rgb <0.25, 0.25, 0.5> parallel point_at <0, 0, 0> }
plane { <0, 2, 0>, 0 pigment { rgb 0.75 } finish { ambient 0.125 diffuse 0.5 } }
union {  // solids: of the look of the union, but for one of them
  cylinder { <-3, 0, 0>, <-3, 1.5, 0>, 0.75 }
  cone { <-1, 0, 0>, 0.75, <-1, 1.75, 0.25>, 0.25 }
  union {
    cone { <1, 0, -1>, 0, <1, 1.5, -1>, 0.75 }
    sphere { <1, 2, -1>, 0.5 pigment { rgb <0.75, 0.75, 0.25> } }
  }
  pigment { rgb <0.75, 0.25, 0.25> }
  finish { diffuse 0.75 phong 0.25 phong_size 20 }
}
union {  // tubes, seen from within
  cylinder { <3, 0.75, -1>, <3, 0.75, 1.5>, 0.75 open texture { pigment { rgb <0.25, 0.5, 0.75> } finish { ambient rgb <0, 0.25, 0> reflection 0.25 } } }
  cone { <3, 2.5, 0>, 0.25, <3, 1.75, 0>, 0.75 open pigment { color rgb <0.5, 0.75, 0.5> } }
}
object { sphere { <0.25, 0.75, -3>, 0.75 } texture { pigment { rgb <0.75, 1, 0.75> filter 0.75 } finish { ambient 0 diffuse 0 phong 0.5 } } interior { ior 1.25 } no_shadow }
object { sphere { <0.25, 0.75, -3>, 0.75 } no_image no_reflection }
mesh {
  triangle { <-5, 0, 3>, <-3, 0, 3>, <-4, 2, 2> }
  triangle { <-3, 0, 3>, <-1, 0, 3>, <-2, 2, 2> }
  pigment { rgb <0.75, 0.5, 0.75> }
}
disc { <1.5, 1.5, 3>, <0, 1, -2>, 1.5 texture { average texture_map {
  [1 pigment { rgb <1, 0.5, 0.25> } finish { ambient 0 diffuse 0.5 }] [1 pigment { rgb <0, 0.25, 0.5> } finish { ambient 0 diffuse 0 emission 1 }] } } }
