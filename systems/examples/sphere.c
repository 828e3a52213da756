// A system that knows spheres: it reads the rays of `durero conform run` and writes its hits.
#include <math.h>
#include <stdio.h>
#include <string.h>

int main(void) {
  static char word[256], name[256], names[1000][256];
  static double s[1000][4];  // centre and radius
  int spheres = 0, rays;
  for (puts("system example-c 1"); fflush(stdout), scanf("%255s %255s", word, name) == 2;) {
    if (!strcmp(word, "scene")) spheres = 0;
    for (int i = 0; i < 4 && !strcmp(word, "esfera"); ++i) scanf("%lf", &s[spheres][i]);
    if (!strcmp(word, "esfera")) strcpy(names[spheres++], name);
    if (strcmp(word, "rays") || sscanf(name, "%d", &rays) != 1) continue;
    for (double x[6], nearest = INFINITY; rays-- > 0; nearest = INFINITY) {
      for (int i = 0; i < 6; ++i) scanf("%lf", &x[i]);
      for (int e = 0; e < spheres; ++e) {
        double A = 0, B = 0, C = -s[e][3] * s[e][3];
        for (int i = 0; i < 3; ++i)
          A += x[3 + i] * x[3 + i], B += (x[i] - s[e][i]) * x[3 + i], C += pow(x[i] - s[e][i], 2);
        for (int side = -1; side <= 1; side += 2) {
          double t = (-B + side * sqrt(B * B - A * C)) / A;  // NaN where there is no root
          if (t > 0 && t < nearest) nearest = t, strcpy(name, names[e]);
        }
      }
      nearest < INFINITY ? printf("hit %s %.17g\n", name, nearest) : puts("miss");
    }
  }
}
