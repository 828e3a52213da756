camera { location -5*z angle 40 look_at 0 }
sphere { 0, 1 rotate x }
