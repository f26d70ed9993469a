// A cantilever in two parts that are meshed apart: 4 x 4 elements across the root, 3 x 3 across the end.
// They meet at x = 170. Coincident points stay two, so that no node is shared.
Geometry.AutoCoherence = 0;
For part In {0 : 1}
  x = 170 * part; long = part ? 230 : 170; n = part ? 3 : 4; layers = part ? 15 : 14;
  p = newp;
  Point(p) = {x, -25, -25}; Point(p + 1) = {x, 25, -25}; Point(p + 2) = {x, 25, 25}; Point(p + 3) = {x, -25, 25};
  l = newl;
  Line(l) = {p, p + 1}; Line(l + 1) = {p + 1, p + 2}; Line(l + 2) = {p + 2, p + 3}; Line(l + 3) = {p + 3, p};
  Curve Loop(l + 4) = {l : l + 3}; Plane Surface(l + 5) = {l + 4};
  Transfinite Curve {l : l + 3} = n + 1; Transfinite Surface {l + 5}; Recombine Surface {l + 5};
  out[] = Extrude {long, 0, 0} { Surface{l + 5}; Layers{layers}; Recombine; };
  If (part == 0)
    Physical Volume("root") = {out[1]}; Physical Surface("wall") = {l + 5}; Physical Surface("root_end") = {out[0]};
  Else
    Physical Volume("end") = {out[1]}; Physical Surface("end_root") = {l + 5}; Physical Surface("tip") = {out[0]};
  EndIf
EndFor
