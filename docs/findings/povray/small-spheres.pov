// POV-Ray 3.7.0.10.unofficial: missed
// Expected e0 at t = 1.4579108576679422e-05, point (-4.248003036378612e-07, 8.496006072757224e-08, 8.496006072757224e-07); got a miss.
// the exact answer: e0 at t = 1.4579108576679422e-05
// e0:
//   t = 0.00001457910857667942203601950713887595234794
//     = 1/65536 − 32/63·√(63/35184372088832)
// e0:
//   t = 0.00001593846954832057796398049286112404765206
//     = 1/65536 + 32/63·√(63/35184372088832)
// the first point:
//   x = -4.2480030363786122748780803820252978254e-7
//   y = 8.4960060727572245497561607640505956508e-8
//   z = 8.4960060727572245497561607640505956508e-7
//
// povray small-spheres.pov +W1 +H1 -D -F && cat answer
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location 0 }

#declare P = <-9.5367431640625e-06, 1.9073486328125e-06, 1.9073486328125e-05>;
#declare V = <0.625, -0.125, -1.25>;
#declare Found = 0;
#declare Nearest = 0;
#declare Got = "miss";
#macro Ask(Name, Object)
  #local Normal = <0, 0, 0>;
  #local Point = trace(Object, P, V, Normal);
  #if (vlength(Normal) != 0)
    #if (Found = 0 | vlength(Point - P) < Nearest)
      #declare Found = 1;
      #declare Nearest = vlength(Point - P);
      #declare Got = concat("hit ", Name, " - ", vstr(3, Point, " ", 0, 25));
    #end
  #end
#end

Ask("e0", object { sphere { <0.0, 0.0, 0.0>, 9.5367431640625e-07 } })

#fopen Answer "answer" write
#write (Answer, "got: ", Got, "\nexpected: hit e0 - -4.248003036378612e-07 8.496006072757224e-08 8.496006072757224e-07\n")
#fclose Answer
