// povray +W320 +H180 -A File_Gamma=sRGB
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 15 adc_bailout 0 }
camera { location <0, 2, -6> direction <0.030754675786973946, -0.38443344733717444, 0.9226402736092187> right <-1.2933980335266335, 0, 0.0431132677842212> up <0.009322977465145613, 0.6720002156876959, 0.2796893239543684> }
background { rgb <0.6, 0.7, 0.9> }
light_source { <-3, 9, -6>, rgb <1, 1, 1> }
object { sphere { <0.7, -0.9, 0.3>, 0.8 } texture { pigment { rgb <0.8, 0.8, 0.8> } finish { ambient 0 diffuse 1 } } }  // boulder
union {
object { sphere { <-0.9, 0, 0.7>, 0.2 } texture { pigment { rgb <0.8, 0.8, 0.8> } finish { ambient 0 diffuse 1 } } }  // left-1
object { sphere { <-0.4, 0.1, -0.5>, 0.3 } texture { pigment { rgb <0.8, 0.8, 0.8> } finish { ambient 0 diffuse 1 } } }  // left-2
}  // left
union {
object { sphere { <1, -0.8, -0.2>, 0.1 } texture { pigment { rgb <0.8, 0.8, 0.8> } finish { ambient 0 diffuse 1 } } }  // right-1
object { sphere { <0.9, -0.1, -0.3>, 0.3 } texture { pigment { rgb <0.8, 0.8, 0.8> } finish { ambient 0 diffuse 1 } } }  // right-2
object { sphere { <0.9, 0.4, -0.4>, 0.1 } texture { pigment { rgb <0.8, 0.8, 0.8> } finish { ambient 0 diffuse 1 } } }  // right-3
}  // right
