// Parallel rollers between two plates, in structured hexahedra. Every body has nodes of its own; the
// interfaces just touch.
//
// z is up, the origin is the middle of the rollers, which lie along y, side by side along x. Rollers
// are numbered from the lowest x on.
//
// Lengths in one unit. The constants below make one solid roller; set others with
//     gmsh line-bearing.geo -setnumber Rollers 3 -setnumber Spacing 300 -3 -o bearing.msh

DefineConstant[
  // The bearing.
  Rollers = {1, Name "Bearing/Rollers"}
  Spacing = {0, Name "Bearing/Distance between roller axes"}
  Diameter = {200, Name "Bearing/Roller diameter"}
  Wall = {0, Name "Bearing/Roller wall (0: solid)"}
  RollerLength = {500, Name "Bearing/Roller length"}
  UpperThickness = {60, Name "Bearing/Upper plate thickness"}
  LowerThickness = {60, Name "Bearing/Lower plate thickness"}
  UpperX = {300, Name "Bearing/Upper plate along x"}
  UpperY = {500, Name "Bearing/Upper plate along y"}
  LowerX = {300, Name "Bearing/Lower plate along x"}
  LowerY = {500, Name "Bearing/Lower plate along y"}
  // 1: the half x >= 0, the half y >= 0; both: the quarter.
  MirrorX = {1, Choices{0, 1}, Name "Mesh/Half along x"}
  MirrorY = {1, Choices{0, 1}, Name "Mesh/Half along y"}

  // Element size across the contact lines, on the rollers and on the plates: a little unlike, so
  // that the nodes of the two sides do not meet.
  RollerSize = {0.5, Name "Mesh/Size across contact lines, rollers"}
  PlateSize = {0.53, Name "Mesh/Size across contact lines, plates"}
  // Elements of that size on either side of a contact line, and below a contact face.
  FineElements = {5, Name "Mesh/Fine elements each side"}
  FineLayers = {3, Name "Mesh/Fine layers"}
  // Element size along a roller at its ends.
  EndSize = {10, Name "Mesh/Size at the roller ends"}
  // Radius of rounded ends, 0: sharp. They begin at a line of nodes.
  EndRadius = {0, Name "Mesh/Radius of rounded ends"}
  // A line of nodes at that distance from sharp ends that carry, and from where a fillet begins; 0: none.
  EdgeReach = {0, Name "Mesh/Reach of the stress of loaded ends"}
  // Largest ratio of neighbouring elements: across the lines, into the depth, along the rollers.
  Growth = {2.5, Name "Mesh/Growth across"}
  DepthGrowth = {2.5, Name "Mesh/Growth into the depth"}
  AlongGrowth = {2, Name "Mesh/Growth along"}
  // Largest elements: around, along and through the wall of the rollers; of the plates in plan and
  // through the thickness.
  AroundCap = {20, Name "Mesh/Largest around"}
  AlongCap = {40, Name "Mesh/Largest along"}
  WallCap = {11, Name "Mesh/Largest through the wall"}
  PlanCap = {30, Name "Mesh/Largest in plan, plates"}
  DepthCap = {20, Name "Mesh/Largest through the plates"}
  // Fewest elements: through the wall, through each plate, along half a roller.
  WallLeast = {9, Name "Mesh/Fewest through the wall"}
  DepthLeast = {5, Name "Mesh/Fewest through the plates"}
  AlongLeast = {8, Name "Mesh/Fewest along half a roller"}
];

Include "spacing.geo";
Include "roller.geo";
Include "slab.geo";

Geometry.AutoCoherence = 1;
// Touching surfaces of different bodies must keep their own nodes.
Geometry.ExactExtrusion = 1;
Mesh.ElementOrder = 1;
Mesh.SaveAll = 0;
Mesh.Optimize = 0;
Mesh.MshFileVersion = 4.1;
Mesh.Binary = 1;

Radius = Diameter / 2;
Solid = (Wall <= 0);
Half = Pi * Radius;
sp_uniform = 0;

// --- rollers ---------------------------------------------------------------------------------

// Through the wall, from the inside out.
ro_inner = Solid ? 0.5 * Radius : Radius - Wall;
sp_at[] = {ro_inner, Radius};
sp_size[] = {sp_any, RollerSize};
sp_fine[] = {1, FineLayers};
sp_least[] = {WallLeast};
sp_cap = WallCap;
sp_growth = DepthGrowth;
Call Spacing;
ro_w[] = {};
For i In {0 : #sp_node[] - 1}
  ro_w[] += (sp_node[i] - ro_inner) / (Radius - ro_inner);
EndFor

// Along the axis: refined at the ends.
sp_cap = AlongCap;
sp_growth = AlongGrowth;
en_radius = EndRadius;
sp_at[] = {};
sp_size[] = {};
sp_fine[] = {};
sp_least[] = {};
If (!MirrorY)
  en_at = -RollerLength / 2;
  Call End;
  sp_least[] += AlongLeast;
EndIf
sp_at[] += 0;
sp_size[] += sp_any;
sp_fine[] += 1;
sp_least[] += AlongLeast;
en_at = RollerLength / 2;
Call End;
Call Spacing;
ro_c[] = sp_node[];

ro_solid = Solid;
ro_turned = 0;
ro_radius = Radius;
ro_z = 0;

// Of the half around, from the bottom (the lower line) to the top (the upper line): the same for
// all rollers. A solid one has a core of four sides, which meet at 45 degrees.
sp_growth = Growth;
sp_cap = AroundCap;
If (Solid)
  sp_at[] = {0, Half / 4};
  sp_size[] = {RollerSize, sp_any};
  sp_fine[] = {FineElements, 1};
  sp_least[] = {1};
  Call Spacing;
  Bottom[] = sp_node[];
  sp_at[] = {Half / 4, 3 * Half / 4};
  sp_size[] = {sp_any, sp_any};
  sp_fine[] = {1, 1};
  sp_least[] = {1};
  Call Spacing;
  Side[] = sp_node[];
  // The quarter at the top is that at the bottom, turned over.
  HalfPhi[] = {};
  For i In {0 : #Bottom[] - 1}
    HalfPhi[] += Bottom[i] / Radius;
  EndFor
  First = #HalfPhi[] - 1;
  For i In {1 : #Side[] - 1}
    HalfPhi[] += Side[i] / Radius;
  EndFor
  Second = #HalfPhi[] - 1;
  For i In {#Bottom[] - 2 : 0 : -1}
    HalfPhi[] += Pi - Bottom[i] / Radius;
  EndFor
Else
  sp_at[] = {0, Half};
  sp_size[] = {RollerSize, RollerSize};
  sp_fine[] = {FineElements, FineElements};
  sp_least[] = {1};
  Call Spacing;
  HalfPhi[] = {};
  For i In {0 : #sp_node[] - 1}
    HalfPhi[] += sp_node[i] / Radius;
  EndFor
  First = 0;
  Second = #HalfPhi[] - 1;
EndIf
Last = #HalfPhi[] - 1;

SymmetryX[] = {};
SymmetryY[] = {};
For Roller_ In {1 : Rollers}
  Place = (Roller_ - 1 - (Rollers - 1) / 2) * Spacing;
  InMiddle = (2 * Roller_ == Rollers + 1);
  If (!MirrorX || InMiddle || Place > 0)
    ro_a = Place;
    ro_phi[] = {};
    ro_block[] = {};
    If (MirrorX && InMiddle)
      ro_phi[] = HalfPhi[];
      ro_block[] = {0};
      If (Solid)
        ro_block[] += {First, Second};
      EndIf
      ro_block[] += Last;
      ro_split = 0;
    ElseIf (Solid)
      // From the corner at the lower left round to itself.
      ro_split = 1;
      For i In {First : 1 : -1}
        ro_phi[] += -HalfPhi[i];
      EndFor
      Shift = #ro_phi[];
      For i In {0 : Last}
        ro_phi[] += HalfPhi[i];
      EndFor
      For i In {Last - 1 : First : -1}
        ro_phi[] += 2 * Pi - HalfPhi[i];
      EndFor
      ro_block[] = {0, Shift + First, Shift + Second, Shift + 2 * Last - Second,
                    Shift + 2 * Last - First};
    Else
      // From the top round to the top.
      ro_split = 0;
      For i In {Last : 1 : -1}
        ro_phi[] += -HalfPhi[i];
      EndFor
      For i In {0 : Last}
        ro_phi[] += HalfPhi[i];
      EndFor
      ro_block[] = {0, Last, 2 * Last};
    EndIf
    Call Roller;
    Body = StrChoice(Rollers == 1, "roller", Sprintf("roller_%g", Roller_));
    Physical Volume(Str(Body)) = ro_volumes[];
    Physical Surface(StrCat(Body, "_surface")) = ro_outer[];
    If (!Solid)
      Physical Surface(StrCat(Body, "_bore")) = ro_bore[];
    EndIf
    SymmetryX[] += ro_cut[];
    SymmetryY[] += ro_start[];
  EndIf
EndFor

// --- plates ----------------------------------------------------------------------------------

For Plate In {0 : 1}
  Thickness = Plate ? LowerThickness : UpperThickness;
  PlateX = Plate ? LowerX : UpperX;
  PlateY = Plate ? LowerY : UpperY;

  // Across: fine at every roller; parted half-way between rollers.
  sp_cap = PlanCap;
  sp_growth = Growth;
  sp_at[] = {};
  sp_size[] = {};
  sp_fine[] = {};
  Parts[] = {0};
  Names[] = {};
  If (!MirrorX)
    sp_at[] += -PlateX / 2;
    sp_size[] += sp_any;
    sp_fine[] += 1;
  EndIf
  For Roller_ In {1 : Rollers}
    Place = (Roller_ - 1 - (Rollers - 1) / 2) * Spacing;
    InMiddle = (2 * Roller_ == Rollers + 1);
    If (InMiddle)
      Place = 0;
    EndIf
    If (!MirrorX || InMiddle || Place > 0)
      Names[] += Roller_;
      If (MirrorX && !InMiddle && #sp_at[] == 0)
        // The plane between the two rollers in the middle.
        sp_at[] += 0;
        sp_size[] += sp_any;
        sp_fine[] += 1;
      EndIf
      sp_at[] += Place;
      sp_size[] += PlateSize;
      sp_fine[] += FineElements;
      If (Roller_ < Rollers)
        sp_at[] += (2 * Roller_ == Rollers) ? 0 : Place + Spacing / 2;
        Parts[] += #sp_at[] - 1;
      Else
        sp_at[] += PlateX / 2;
        Parts[] += #sp_at[] - 1;
      EndIf
      sp_size[] += sp_any;
      sp_fine[] += 1;
    EndIf
  EndFor
  sp_least[] = {};
  For i In {1 : #sp_at[] - 1}
    sp_least[] += 1;
  EndFor
  Call Spacing;
  sl_x[] = sp_node[];
  sl_ix[] = {};
  For i In {0 : #Parts[] - 1}
    sl_ix[] += sp_stop[Parts[i]];
  EndFor

  // Along: refined where the rollers end.
  sp_cap = AlongCap;
  sp_growth = AlongGrowth;
  Outside = (PlateY > RollerLength * (1 + 1e-9));
  Inside = (PlateY < RollerLength * (1 - 1e-9));
  Far = Inside ? PlateY / 2 : RollerLength / 2;
  en_radius = Inside ? 0 : EndRadius;
  sp_at[] = {};
  sp_size[] = {};
  sp_fine[] = {};
  sp_least[] = {1, 1, 1, 1};
  If (!MirrorY)
    If (Outside)
      sp_at[] += -PlateY / 2;
      sp_size[] += sp_any;
      sp_fine[] += 1;
    EndIf
    en_at = -Far;
    Call End;
  EndIf
  sp_at[] += 0;
  sp_size[] += sp_any;
  sp_fine[] += 1;
  en_at = Far;
  Call End;
  If (Outside)
    sp_at[] += PlateY / 2;
    sp_size[] += sp_any;
    sp_fine[] += 1;
  EndIf
  Call Spacing;
  sl_y[] = sp_node[];
  sl_iy[] = {0, #sl_y[] - 1};

  // Through the thickness, from the contact face.
  sp_at[] = {0, Thickness};
  sp_size[] = {PlateSize, sp_any};
  sp_fine[] = {FineLayers, 1};
  sp_least[] = {DepthLeast};
  sp_cap = DepthCap;
  sp_growth = DepthGrowth;
  Call Spacing;
  sl_bottom_slope = 0;
  sl_top_slope = 0;
  sl_w[] = {};
  If (Plate)
    sl_bottom = -Radius - Thickness;
    sl_top = -Radius;
    For i In {#sp_node[] - 1 : 0 : -1}
      sl_w[] += 1 - sp_node[i] / Thickness;
    EndFor
  Else
    sl_bottom = Radius;
    sl_top = Radius + Thickness;
    For i In {0 : #sp_node[] - 1}
      sl_w[] += sp_node[i] / Thickness;
    EndFor
  EndIf
  Call Slab;
  If (MirrorX)
    SymmetryX[] += sl_faces_x[];
  EndIf
  If (MirrorY)
    SymmetryY[] += sl_faces_y[];
  EndIf
  If (Plate)
    Physical Volume("lower_plate") = sl_volumes[];
    Physical Surface("lower_plate_bottom") = sl_faces_bottom[];
    For i In {0 : #Names[] - 1}
      Number = StrChoice(Rollers == 1, "", Sprintf("_%g", Names[i]));
      Physical Surface(StrCat("lower_plate_top", Number)) = sl_faces_top[i];
    EndFor
  Else
    Physical Volume("upper_plate") = sl_volumes[];
    Physical Surface("upper_plate_top") = sl_faces_top[];
    For i In {0 : #Names[] - 1}
      Number = StrChoice(Rollers == 1, "", Sprintf("_%g", Names[i]));
      Physical Surface(StrCat("upper_plate_bottom", Number)) = sl_faces_bottom[i];
    EndFor
  EndIf
EndFor

If (MirrorX)
  Physical Surface("x_symmetry") = SymmetryX[];
EndIf
If (MirrorY)
  Physical Surface("y_symmetry") = SymmetryY[];
EndIf
