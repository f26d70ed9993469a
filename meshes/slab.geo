// Slab: a plate of hexahedra over a rectangle, in one or more blocks, with node lines at given
// positions. Both faces may be roofs: the bottom at z = sl_bottom - sl_bottom_slope |y|, the top
// at z = sl_top + sl_top_slope |x|.
//
//   in   sl_x[], sl_y[]    node positions
//        sl_ix[], sl_iy[]  indices of the positions where blocks begin and end; a roof needs
//                          its ridge among them
//        sl_w[]            node positions through the thickness, from 0 (bottom) to 1 (top)
//        sl_bottom, sl_bottom_slope, sl_top, sl_top_slope
//   out  sl_volumes[], sl_faces_bottom[], sl_faces_top[], sl_faces_x[], sl_faces_y[]
//        (the last two: the faces of the lowest x and of the lowest y)
//
// Every element edge on the edges of a block is a straight curve of its own. This makes the
// spacing free: transfinite surfaces and volumes take several curves a side. Blocks share their
// points and curves by construction and nothing is merged afterwards: merging would also weld
// the plate to the roller that touches it.

// Sl_Edge: a chain of one-element lines over the points sl_p[]; appends to sl_curve[].
Macro Sl_Edge
  sl_from[] += #sl_curve[];
  sl_count[] += #sl_p[] - 1;
  For sl_m In {0 : #sl_p[] - 2}
    sl_c = newl;
    Line(sl_c) = {sl_p[sl_m], sl_p[sl_m + 1]};
    sl_curve[] += sl_c;
  EndFor
Return

// Sl_Face: the face between the edges sl_e0, sl_e1 (from corner 0 to 1 to 2) and sl_e3, sl_e2
// (from corner 0 to 3 to 2), with corners sl_q0 .. sl_q3.
Macro Sl_Face
  sl_loop[] = {};
  For sl_m In {0 : sl_count[sl_e0] - 1}
    sl_loop[] += sl_curve[sl_from[sl_e0] + sl_m];
  EndFor
  For sl_m In {0 : sl_count[sl_e1] - 1}
    sl_loop[] += sl_curve[sl_from[sl_e1] + sl_m];
  EndFor
  For sl_m In {sl_count[sl_e2] - 1 : 0 : -1}
    sl_loop[] += -sl_curve[sl_from[sl_e2] + sl_m];
  EndFor
  For sl_m In {sl_count[sl_e3] - 1 : 0 : -1}
    sl_loop[] += -sl_curve[sl_from[sl_e3] + sl_m];
  EndFor
  sl_l = newll;
  Curve Loop(sl_l) = sl_loop[];
  sl_f = news;
  Plane Surface(sl_f) = {sl_l};
  Transfinite Surface {sl_f} = {sl_q0, sl_q1, sl_q2, sl_q3};
  Recombine Surface {sl_f};
Return

Macro Slab
  sl_nx = #sl_ix[] - 1;
  sl_ny = #sl_iy[] - 1;
  sl_nw = #sl_w[] - 1;
  sl_curve[] = {};
  sl_from[] = {};
  sl_count[] = {};

  // Corners of the blocks: index (j (nx + 1) + i) 2 + k, k = 0 at the bottom.
  sl_corner[] = {};
  For sl_j In {0 : sl_ny}
    For sl_i In {0 : sl_nx}
      For sl_k In {0 : 1}
        sl_px = sl_x[sl_ix[sl_i]];
        sl_py = sl_y[sl_iy[sl_j]];
        sl_pz = sl_k ? sl_top + sl_top_slope * Fabs(sl_px)
                     : sl_bottom - sl_bottom_slope * Fabs(sl_py);
        sl_n = newp;
        Point(sl_n) = {sl_px, sl_py, sl_pz};
        sl_corner[] += sl_n;
      EndFor
    EndFor
  EndFor

  // Edges along x: index (j nx + i) 2 + k.
  For sl_j In {0 : sl_ny}
    For sl_i In {0 : sl_nx - 1}
      For sl_k In {0 : 1}
        sl_a = (sl_j * (sl_nx + 1) + sl_i) * 2 + sl_k;
        sl_p[] = {sl_corner[sl_a]};
        sl_py = sl_y[sl_iy[sl_j]];
        For sl_m In {sl_ix[sl_i] + 1 : sl_ix[sl_i + 1] - 1}
          sl_pz = sl_k ? sl_top + sl_top_slope * Fabs(sl_x[sl_m])
                       : sl_bottom - sl_bottom_slope * Fabs(sl_py);
          sl_n = newp;
          Point(sl_n) = {sl_x[sl_m], sl_py, sl_pz};
          sl_p[] += sl_n;
        EndFor
        sl_p[] += sl_corner[sl_a + 2];
        Call Sl_Edge;
      EndFor
    EndFor
  EndFor

  // Edges along y: index sl_ey + (j (nx + 1) + i) 2 + k.
  sl_ey = #sl_from[];
  For sl_j In {0 : sl_ny - 1}
    For sl_i In {0 : sl_nx}
      For sl_k In {0 : 1}
        sl_a = (sl_j * (sl_nx + 1) + sl_i) * 2 + sl_k;
        sl_p[] = {sl_corner[sl_a]};
        sl_px = sl_x[sl_ix[sl_i]];
        For sl_m In {sl_iy[sl_j] + 1 : sl_iy[sl_j + 1] - 1}
          sl_pz = sl_k ? sl_top + sl_top_slope * Fabs(sl_px)
                       : sl_bottom - sl_bottom_slope * Fabs(sl_y[sl_m]);
          sl_n = newp;
          Point(sl_n) = {sl_px, sl_y[sl_m], sl_pz};
          sl_p[] += sl_n;
        EndFor
        sl_p[] += sl_corner[sl_a + (sl_nx + 1) * 2];
        Call Sl_Edge;
      EndFor
    EndFor
  EndFor

  // Edges through the thickness: index sl_ez + j (nx + 1) + i.
  sl_ez = #sl_from[];
  For sl_j In {0 : sl_ny}
    For sl_i In {0 : sl_nx}
      sl_a = (sl_j * (sl_nx + 1) + sl_i) * 2;
      sl_p[] = {sl_corner[sl_a]};
      sl_px = sl_x[sl_ix[sl_i]];
      sl_py = sl_y[sl_iy[sl_j]];
      sl_z0 = sl_bottom - sl_bottom_slope * Fabs(sl_py);
      sl_z1 = sl_top + sl_top_slope * Fabs(sl_px);
      For sl_m In {1 : sl_nw - 1}
        sl_n = newp;
        Point(sl_n) = {sl_px, sl_py, sl_z0 + (sl_z1 - sl_z0) * sl_w[sl_m]};
        sl_p[] += sl_n;
      EndFor
      sl_p[] += sl_corner[sl_a + 1];
      Call Sl_Edge;
    EndFor
  EndFor
  Transfinite Curve {sl_curve[]} = 2;

  // Level faces: index (j nx + i) 2 + k.
  sl_faces_bottom[] = {};
  sl_faces_top[] = {};
  sl_level[] = {};
  For sl_j In {0 : sl_ny - 1}
    For sl_i In {0 : sl_nx - 1}
      For sl_k In {0 : 1}
        sl_e0 = (sl_j * sl_nx + sl_i) * 2 + sl_k;
        sl_e1 = sl_ey + (sl_j * (sl_nx + 1) + sl_i + 1) * 2 + sl_k;
        sl_e2 = ((sl_j + 1) * sl_nx + sl_i) * 2 + sl_k;
        sl_e3 = sl_ey + (sl_j * (sl_nx + 1) + sl_i) * 2 + sl_k;
        sl_a = (sl_j * (sl_nx + 1) + sl_i) * 2 + sl_k;
        sl_b = sl_a + (sl_nx + 1) * 2;
        sl_q0 = sl_corner[sl_a];
        sl_q1 = sl_corner[sl_a + 2];
        sl_q2 = sl_corner[sl_b + 2];
        sl_q3 = sl_corner[sl_b];
        Call Sl_Face;
        sl_level[] += sl_f;
        If (sl_k)
          sl_faces_top[] += sl_f;
        Else
          sl_faces_bottom[] += sl_f;
        EndIf
      EndFor
    EndFor
  EndFor

  // Faces of constant y: index j nx + i.
  sl_faces_y[] = {};
  sl_wall_y[] = {};
  For sl_j In {0 : sl_ny}
    For sl_i In {0 : sl_nx - 1}
      sl_e0 = (sl_j * sl_nx + sl_i) * 2;
      sl_e1 = sl_ez + sl_j * (sl_nx + 1) + sl_i + 1;
      sl_e2 = sl_e0 + 1;
      sl_e3 = sl_e1 - 1;
      sl_a = (sl_j * (sl_nx + 1) + sl_i) * 2;
      sl_q0 = sl_corner[sl_a];
      sl_q1 = sl_corner[sl_a + 2];
      sl_q2 = sl_corner[sl_a + 3];
      sl_q3 = sl_corner[sl_a + 1];
      Call Sl_Face;
      sl_wall_y[] += sl_f;
      If (sl_j == 0)
        sl_faces_y[] += sl_f;
      EndIf
    EndFor
  EndFor

  // Faces of constant x: index j (nx + 1) + i.
  sl_faces_x[] = {};
  sl_wall_x[] = {};
  For sl_j In {0 : sl_ny - 1}
    For sl_i In {0 : sl_nx}
      sl_e0 = sl_ey + (sl_j * (sl_nx + 1) + sl_i) * 2;
      sl_e1 = sl_ez + (sl_j + 1) * (sl_nx + 1) + sl_i;
      sl_e2 = sl_e0 + 1;
      sl_e3 = sl_ez + sl_j * (sl_nx + 1) + sl_i;
      sl_a = (sl_j * (sl_nx + 1) + sl_i) * 2;
      sl_b = sl_a + (sl_nx + 1) * 2;
      sl_q0 = sl_corner[sl_a];
      sl_q1 = sl_corner[sl_b];
      sl_q2 = sl_corner[sl_b + 1];
      sl_q3 = sl_corner[sl_a + 1];
      Call Sl_Face;
      sl_wall_x[] += sl_f;
      If (sl_i == 0)
        sl_faces_x[] += sl_f;
      EndIf
    EndFor
  EndFor

  sl_volumes[] = {};
  For sl_j In {0 : sl_ny - 1}
    For sl_i In {0 : sl_nx - 1}
      sl_k = sl_j * sl_nx + sl_i;
      sl_m = sl_j * (sl_nx + 1) + sl_i;
      sl_l = newsl;
      Surface Loop(sl_l) = {sl_level[sl_k * 2], sl_level[sl_k * 2 + 1],
                            sl_wall_y[sl_k], sl_wall_y[sl_k + sl_nx],
                            sl_wall_x[sl_m], sl_wall_x[sl_m + 1]};
      sl_v = newv;
      Volume(sl_v) = {sl_l};
      sl_a = sl_m * 2;
      sl_b = sl_a + (sl_nx + 1) * 2;
      Transfinite Volume {sl_v} = {sl_corner[sl_a], sl_corner[sl_a + 2],
                                   sl_corner[sl_b + 2], sl_corner[sl_b],
                                   sl_corner[sl_a + 1], sl_corner[sl_a + 3],
                                   sl_corner[sl_b + 3], sl_corner[sl_b + 1]};
      sl_volumes[] += sl_v;
    EndFor
  EndFor
Return
