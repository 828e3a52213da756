union {
  sphere { 0, 1 }
  union {
    cone { 0, 1, x, 0 }
