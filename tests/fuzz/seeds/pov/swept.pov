#version 3.7;
prism { quadratic_spline 1, -1, 4, <2, -1>, <1, 0>, <1, 1>, <1, 0> open }
prism { bezier_spline 0, 1, 8, <1, 0>, <3, 0>, <3, 2>, <1, 2>, <1, 2>, <1, 1>, <1, 1>, <1, 0> open translate 5 * x }
