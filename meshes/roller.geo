// Roller: a hollow or solid cylinder of hexahedra, extruded from its cross-section.
//
// The cross-section is described in local coordinates: a across, z up, the angle phi from the
// bottom towards +a, so that phi = 0 is the bottom and phi = Pi the top. The roller along y uses
// them as they are, (x, y, z) = (a, c, z) with c along the axis; the roller along x is the same
// body turned over: (x, y, z) = (c, a, -z).
//
//   in   ro_turned          0: along y, 1: along x
//        ro_a, ro_z         centre of the cross-section
//        ro_radius
//        ro_inner           radius of the bore; of a solid roller, the half-diagonal of the core
//        ro_solid           1: the inside is filled with a core of hexahedra
//        ro_split           1: the core of a solid whole is parted along the plane a = ro_a, so
//                           that each side is the mesh of a half; needs rows at 0 and Pi, and
//                           as many elements on either side of them
//        ro_phi[]           angles of the node rows: 0 to Pi for a half, else a full turn
//        ro_block[]         indices in ro_phi[] where blocks begin and end. A solid half has
//                           three blocks (meeting at 45 and 135 degrees), a solid whole has four
//        ro_w[]             node positions from the inside (0) to the outer surface (1)
//        ro_c[]             node positions along the axis
//   out  ro_volumes[], ro_outer[], ro_bore[],
//        ro_start[]         the end face of lowest c
//        ro_cut[]           of a half: the faces of the plane a = ro_a
//
// Points on the cylinder are placed one by one, so every node lies on the true cylinder.
// Extruding relies on Geometry.AutoCoherence and must come before any body that touches the
// roller is made: it would be welded to it.

// Ro_Point: the point ro_n at ro_rho, ro_t.
Macro Ro_Point
  ro_sin = Sin(ro_t);
  ro_cos = Cos(ro_t);
  // Exactly on the axes, so that symmetry planes are planes.
  If (Fabs(ro_sin) < 1e-12)
    ro_sin = 0;
  EndIf
  ro_n = newp;
  If (ro_turned)
    Point(ro_n) = {ro_c[0], ro_a + ro_rho * ro_sin, -(ro_z - ro_rho * ro_cos)};
  Else
    Point(ro_n) = {ro_a + ro_rho * ro_sin, ro_c[0], ro_z - ro_rho * ro_cos};
  EndIf
Return

// Ro_Inner: the radius ro_rho of the inside at the angle ro_t. The core of a solid roller is a
// square with bulging sides: half-way between a circle and the square in it.
Macro Ro_Inner
  ro_rho = ro_inner;
  If (ro_solid)
    ro_side = ro_t - Pi / 2 * Floor(ro_t / (Pi / 2) + 0.5);
    ro_rho = ro_inner * (1 + Cos(Pi / 4) / Cos(ro_side)) / 2;
  EndIf
Return

// Ro_Core: a face of the core inside the curves ro_loop[], with corners ro_q0 .. ro_q3.
Macro Ro_Core
  ro_sides[] += #ro_loop[];
  ro_l = newll;
  Curve Loop(ro_l) = ro_loop[];
  ro_f = news;
  Plane Surface(ro_f) = {ro_l};
  Transfinite Surface {ro_f} = {ro_q0, ro_q1, ro_q2, ro_q3};
  Recombine Surface {ro_f};
  ro_start[] += ro_f;
Return

Macro Roller
  ro_last = #ro_phi[] - 1;
  ro_half = (ro_phi[ro_last] - ro_phi[0] < 1.5 * Pi);
  ro_blocks = #ro_block[] - 1;
  ro_rho = 0;
  ro_t = 0;
  Call Ro_Point;
  ro_centre = ro_n;

  // Points and one-element curves around.
  ro_pin[] = {};
  ro_pout[] = {};
  For ro_i In {0 : ro_half ? ro_last : ro_last - 1}
    ro_t = ro_phi[ro_i];
    Call Ro_Inner;
    Call Ro_Point;
    ro_pin[] += ro_n;
    ro_rho = ro_radius;
    Call Ro_Point;
    ro_pout[] += ro_n;
  EndFor
  If (!ro_half)
    ro_pin[] += ro_pin[0];
    ro_pout[] += ro_pout[0];
  EndIf
  ro_lin[] = {};
  ro_lout[] = {};
  For ro_i In {0 : ro_last - 1}
    ro_l = newl;
    If (ro_solid)
      Line(ro_l) = {ro_pin[ro_i], ro_pin[ro_i + 1]};
    Else
      Circle(ro_l) = {ro_pin[ro_i], ro_centre, ro_pin[ro_i + 1]};
    EndIf
    ro_lin[] += ro_l;
    ro_l = newl;
    Circle(ro_l) = {ro_pout[ro_i], ro_centre, ro_pout[ro_i + 1]};
    ro_lout[] += ro_l;
  EndFor
  Transfinite Curve {ro_lin[], ro_lout[]} = 2;

  // Radial chains where blocks meet: nw curves each.
  ro_nw = #ro_w[] - 1;
  ro_rad[] = {};
  For ro_b In {0 : ro_half ? ro_blocks : ro_blocks - 1}
    ro_i = ro_block[ro_b];
    ro_t = ro_phi[ro_i];
    Call Ro_Inner;
    ro_low = ro_rho;
    ro_p = ro_pin[ro_i];
    For ro_m In {1 : ro_nw}
      If (ro_m < ro_nw)
        ro_rho = ro_low + (ro_radius - ro_low) * ro_w[ro_m];
        Call Ro_Point;
      Else
        ro_n = ro_pout[ro_i];
      EndIf
      ro_l = newl;
      Line(ro_l) = {ro_p, ro_n};
      ro_rad[] += ro_l;
      ro_p = ro_n;
    EndFor
  EndFor
  If (!ro_half)
    For ro_m In {0 : ro_nw - 1}
      ro_rad[] += ro_rad[ro_m];
    EndFor
  EndIf
  Transfinite Curve {ro_rad[]} = 2;

  // Faces of the cross-section; ro_kind[] says what the extrusion of each curve becomes:
  // 1 outer surface, 2 bore, 3 cut, 0 inside.
  ro_start[] = {};
  ro_kind[] = {};
  ro_sides[] = {};
  For ro_b In {0 : ro_blocks - 1}
    ro_loop[] = {};
    For ro_m In {0 : ro_nw - 1}
      ro_loop[] += ro_rad[ro_b * ro_nw + ro_m];
      ro_kind[] += (ro_half && ro_b == 0) ? 3 : 0;
    EndFor
    For ro_m In {ro_block[ro_b] : ro_block[ro_b + 1] - 1}
      ro_loop[] += ro_lout[ro_m];
      ro_kind[] += 1;
    EndFor
    For ro_m In {ro_nw - 1 : 0 : -1}
      ro_loop[] += -ro_rad[(ro_b + 1) * ro_nw + ro_m];
      ro_kind[] += (ro_half && ro_b == ro_blocks - 1) ? 3 : 0;
    EndFor
    For ro_m In {ro_block[ro_b + 1] - 1 : ro_block[ro_b] : -1}
      ro_loop[] += -ro_lin[ro_m];
      ro_kind[] += ro_solid ? 0 : 2;
    EndFor
    ro_sides[] += #ro_loop[];
    ro_l = newll;
    Curve Loop(ro_l) = ro_loop[];
    ro_f = news;
    Plane Surface(ro_f) = {ro_l};
    ro_p0 = ro_pin[ro_block[ro_b]];
    ro_p1 = ro_pout[ro_block[ro_b]];
    ro_p2 = ro_pout[ro_block[ro_b + 1]];
    ro_p3 = ro_pin[ro_block[ro_b + 1]];
    Transfinite Surface {ro_f} = {ro_p0, ro_p1, ro_p2, ro_p3};
    Recombine Surface {ro_f};
    ro_start[] += ro_f;
  EndFor

  If (ro_solid)
    If (ro_half || ro_split)
      // The diameter, from the top down, with as many elements as the side that faces it.
      ro_bottom = 0;
      ro_summit = 0;
      For ro_m In {0 : ro_last}
        If (Fabs(ro_phi[ro_m]) < 1e-9)
          ro_bottom = ro_m;
        ElseIf (Fabs(ro_phi[ro_m] - Pi) < 1e-9)
          ro_summit = ro_m;
        EndIf
      EndFor
      ro_n1 = ro_block[2] - ro_block[1];
      ro_t = 0;
      Call Ro_Inner;
      ro_low = ro_rho;
      ro_p = ro_pin[ro_summit];
      ro_diameter[] = {};
      For ro_m In {1 : ro_n1}
        If (ro_m < ro_n1)
          ro_rho = ro_low * (2 * ro_m / ro_n1 - 1);
          ro_t = 0;
          Call Ro_Point;
        Else
          ro_n = ro_pin[ro_bottom];
        EndIf
        ro_l = newl;
        Line(ro_l) = {ro_p, ro_n};
        ro_diameter[] += ro_l;
        ro_p = ro_n;
      EndFor
      Transfinite Curve {ro_diameter[]} = 2;

      // The half on the side of +a, and its mirror image. The spacing inside depends on
      // which sides come first: both begin with the diameter and the bottom.
      ro_loop[] = ro_diameter[];
      For ro_m In {0 : ro_n1 - 1}
        ro_kind[] += ro_half ? 3 : 0;
      EndFor
      For ro_m In {ro_bottom : ro_summit - 1}
        ro_loop[] += ro_lin[ro_m];
        ro_kind[] += 0;
      EndFor
      ro_q0 = ro_pin[ro_summit];
      ro_q1 = ro_pin[ro_bottom];
      ro_q2 = ro_pin[ro_block[1]];
      ro_q3 = ro_pin[ro_block[2]];
      Call Ro_Core;
      If (ro_split)
        ro_loop[] = ro_diameter[];
        For ro_m In {0 : ro_n1 - 1}
          ro_kind[] += 0;
        EndFor
        For ro_m In {ro_bottom - 1 : 0 : -1}
          ro_loop[] += -ro_lin[ro_m];
          ro_kind[] += 0;
        EndFor
        For ro_m In {ro_last - 1 : ro_summit : -1}
          ro_loop[] += -ro_lin[ro_m];
          ro_kind[] += 0;
        EndFor
        ro_q0 = ro_pin[ro_summit];
        ro_q1 = ro_pin[ro_bottom];
        ro_q2 = ro_pin[ro_block[0]];
        ro_q3 = ro_pin[ro_block[3]];
        Call Ro_Core;
      EndIf
    Else
      ro_loop[] = ro_lin[];
      For ro_m In {0 : #ro_lin[] - 1}
        ro_kind[] += 0;
      EndFor
      ro_q0 = ro_pin[ro_block[0]];
      ro_q1 = ro_pin[ro_block[1]];
      ro_q2 = ro_pin[ro_block[2]];
      ro_q3 = ro_pin[ro_block[3]];
      Call Ro_Core;
    EndIf
  EndIf

  // Along the axis.
  ro_nc = #ro_c[] - 1;
  ro_length = ro_c[ro_nc] - ro_c[0];
  ro_one[] = {};
  ro_part[] = {};
  For ro_m In {1 : ro_nc}
    ro_one[] += 1;
    ro_part[] += (ro_c[ro_m] - ro_c[0]) / ro_length;
  EndFor
  ro_part[ro_nc - 1] = 1;
  If (ro_turned)
    ro_out[] = Extrude {ro_length, 0, 0} {
      Surface {ro_start[]}; Layers {ro_one[], ro_part[]}; Recombine;
    };
  Else
    ro_out[] = Extrude {0, ro_length, 0} {
      Surface {ro_start[]}; Layers {ro_one[], ro_part[]}; Recombine;
    };
  EndIf

  ro_volumes[] = {};
  ro_outer[] = {};
  ro_bore[] = {};
  ro_cut[] = {};
  ro_o = 0;
  ro_k = 0;
  For ro_b In {0 : #ro_sides[] - 1}
    ro_volumes[] += ro_out[ro_o + 1];
    ro_o += 2;
    For ro_m In {1 : ro_sides[ro_b]}
      If (ro_kind[ro_k] == 1)
        ro_outer[] += ro_out[ro_o];
      ElseIf (ro_kind[ro_k] == 2)
        ro_bore[] += ro_out[ro_o];
      ElseIf (ro_kind[ro_k] == 3)
        ro_cut[] += ro_out[ro_o];
      EndIf
      ro_o += 1;
      ro_k += 1;
    EndFor
  EndFor
Return
