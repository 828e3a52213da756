// POV-Ray 3.7.0.10.unofficial: missed
// Expected e0 at t = 1183474333897076.2, point (-28787213527226.184, -127943171232116.36, 19191475684817.453); got a miss.
// Hits beyond 10⁷ are not reported.
// the exact answer: e0 at t = 1183474333897076.2
// e0:
//   t = 1183474333897076.363636363636363636363636
//     = 13018217672867840/11
// the first point:
//   x = -28787213527226.18181818181818181818181818
//   y = -127943171232116.3636363636363636363636364
//   z = 19191475684817.45454545454545454545454545
//
// povray distance-limit.pov +W1 +H1 -D -F && cat answer
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location 0 }

#declare P = <562949953421312.0, 1055531162664960.0, 1794402976530432.0>;
#declare V = <-0.5, -1.0, -1.5>;
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

Ask("e0", object { cone { <0.0, 0.0, 0.0>, 140737488355328.0, <0.0, 0.0, 140737488355328.0>, 70368744177664.0 open } })

#fopen Answer "answer" write
#write (Answer, "got: ", Got, "\nexpected: hit e0 - -28787213527226.184 -127943171232116.36 19191475684817.453\n")
#fclose Answer
