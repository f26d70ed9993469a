// The rolling bearing: upper plate, upper roller, intermediate plate, lower roller, lower plate,
// in structured hexahedra. Every body has nodes of its own; the interfaces just touch.
//
// z is up, the origin is the centre of the intermediate plate. The upper roller lies along y at
// x = Offset, the lower roller along x at y = Offset; the upper plate is centred on
// x = 2 Offset, the lower plate on y = 2 Offset. The intermediate plate has a valley along y on
// top and an inverted valley along x below.
//
// Lengths in one unit, the angle in radians. The constants below make the reference bearing
// with elements of 0.025 in across the contact lines; set others with
//     gmsh bearing.geo -setnumber Offset 2.5 -setnumber Full 1 -3 -o bearing.msh

DefineConstant[
  // The bearing.
  Diameter = {3, Name "Bearing/Roller diameter"}
  Wall = {0.75, Name "Bearing/Roller wall (0: solid)"}
  RollerLength = {8, Name "Bearing/Roller length"}
  Slope = {4 * Pi / 180, Name "Bearing/Slope (rad)"}
  Offset = {0, Name "Bearing/Offset"}
  UpperThickness = {1, Name "Bearing/Upper plate thickness"}
  MiddleThickness = {1, Name "Bearing/Intermediate plate thickness"}
  LowerThickness = {1, Name "Bearing/Lower plate thickness"}
  PlanX = {8, Name "Bearing/Plates along x"}
  PlanY = {8, Name "Bearing/Plates along y"}
  // 0: the quarter x >= 0, y >= 0 of a centred bearing; 1: all of it.
  Full = {0, Choices{0, 1}, Name "Mesh/Full model"}

  // 1: equal elements of the largest sizes, and node rows only on the centre lines.
  Uniform = {0, Choices{0, 1}, Name "Mesh/Uniform"}
  // Element size across the contact lines, on the rollers and on the plates: a little unlike, so
  // that the nodes of the two sides do not meet.
  RollerSize = {0.025, Name "Mesh/Size across contact lines, rollers"}
  PlateSize = {0.0265, Name "Mesh/Size across contact lines, plates"}
  // Elements of that size on either side of a contact line, and below a contact face.
  FineElements = {2, Name "Mesh/Fine elements each side"}
  FineLayers = {1, Name "Mesh/Fine layers"}
  // Element size along a roller where the other one crosses, and at its ends.
  CrossingSize = {0.1, Name "Mesh/Size at the crossing"}
  EndSize = {0.15, Name "Mesh/Size at the roller ends"}
  // Radius of rounded ends, 0: sharp. They begin at a line of nodes.
  EndRadius = {0, Name "Mesh/Radius of rounded ends"}
  // A line of nodes at that distance from sharp ends that carry, and from where a fillet begins; 0: none.
  EdgeReach = {0, Name "Mesh/Reach of the stress of loaded ends"}
  // Half of the length of plates that end on the straight part of a roller, and of longer ones on the other roller; 0: none.
  PlateEdge = {0, Name "Mesh/Edge of short plates"}
  PlateEdgeFar = {0, Name "Mesh/Edge of short plates, the longer ones"}
  // Largest ratio of neighbouring elements: across the lines, into the depth, along the rollers.
  Growth = {2, Name "Mesh/Growth across"}
  DepthGrowth = {2, Name "Mesh/Growth into the depth"}
  AlongGrowth = {1.5, Name "Mesh/Growth along"}
  // Largest elements: around, along and through the wall of the rollers; in plan in the flat and
  // in the intermediate plates; through the plates.
  AroundCap = {0.5, Name "Mesh/Largest around"}
  AlongCap = {0.5, Name "Mesh/Largest along"}
  WallCap = {0.2, Name "Mesh/Largest through the wall"}
  PlanCap = {1, Name "Mesh/Largest in plan, flat plates"}
  MiddleCap = {0.7, Name "Mesh/Largest in plan, intermediate plate"}
  DepthCap = {0.3, Name "Mesh/Largest through the plates"}
  // Fewest elements: through the wall, through each plate, along half a roller (centred).
  WallLeast = {5, Name "Mesh/Fewest through the wall"}
  DepthLeast = {5, Name "Mesh/Fewest through the plates"}
  AlongLeast = {12, Name "Mesh/Fewest along half a roller"}
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
Centred = (Offset == 0);
Whole = (Full || !Centred);
// Distance of the roller axes from the plane z = 0, and of the V lines from the centre planes.
AxisHeight = MiddleThickness / 2 + Offset * Tan(Slope) + Radius / Cos(Slope);
VLine = Offset + Radius * Sin(Slope);
FlatFace = AxisHeight + Radius;

sp_uniform = Uniform;

// --- rollers ---------------------------------------------------------------------------------

// Around, as arc lengths from the bottom (the V side).
sp_growth = Growth;
sp_cap = AroundCap;
Half = Pi * Radius;
Contact = Slope * Radius;
If (!Solid)
  If (Uniform)
    If (Whole)
      sp_at[] = {-Half, 0, Half};
      Blocks[] = {0, 1, 2};
    Else
      sp_at[] = {0, Half};
      Blocks[] = {0, 1};
    EndIf
    sp_size[] = {sp_any, sp_any, sp_any};
  ElseIf (!Whole)
    sp_at[] = {0, Contact, Half};
    sp_size[] = {sp_any, RollerSize, RollerSize};
    Blocks[] = {0, 2};
  ElseIf (Centred)
    sp_at[] = {-Half, -Contact, 0, Contact, Half};
    sp_size[] = {RollerSize, RollerSize, sp_any, RollerSize, RollerSize};
    Blocks[] = {0, 2, 4};
  Else
    sp_at[] = {-Half, Contact, Half};
    sp_size[] = {RollerSize, RollerSize, RollerSize};
    Blocks[] = {0, 1, 2};
  EndIf
  sp_fine[] = {FineElements, FineElements, FineElements, FineElements, FineElements};
  sp_least[] = {1, 1, 1, 1};
  Call Spacing;
  ro_phi[] = {};
  For i In {0 : #sp_node[] - 1}
    ro_phi[] += sp_node[i] / Radius;
  EndFor
  ro_block[] = {};
  For i In {0 : #Blocks[] - 1}
    ro_block[] += sp_stop[Blocks[i]];
  EndFor
Else
  // The core of a solid roller has four sides: bottom, right, top and left, which meet at 45
  // degrees. The right and left sides hold no contact lines.
  If (Uniform)
    BottomAt[] = {-Half / 4, 0, Half / 4};
    BottomSize[] = {sp_any, sp_any, sp_any};
    TopSize[] = {sp_any, sp_any, sp_any};
  ElseIf (Centred)
    BottomAt[] = {-Half / 4, -Contact, 0, Contact, Half / 4};
    BottomSize[] = {sp_any, RollerSize, sp_any, RollerSize, sp_any};
    TopSize[] = {sp_any, RollerSize, sp_any};
  Else
    BottomAt[] = {-Half / 4, Contact, Half / 4};
    BottomSize[] = {sp_any, RollerSize, sp_any};
    TopSize[] = {sp_any, RollerSize, sp_any};
  EndIf
  TopAt[] = {3 * Half / 4, Half, 5 * Half / 4};
  If (!Whole)
    // The half from the bottom round to the top.
    First = (#BottomAt[] - 1) / 2;
    BottomAt[] = BottomAt[{First : #BottomAt[] - 1}];
    BottomSize[] = BottomSize[{First : #BottomSize[] - 1}];
    TopAt[] = {TopAt[0], TopAt[1]};
    TopSize[] = {TopSize[0], TopSize[1]};
  EndIf
  BottomLeast[] = {1, 1, 1, 1};
  TopLeast[] = {1, 1, 1, 1};
  sp_fine[] = {FineElements, FineElements, FineElements, FineElements, FineElements};

  // Bottom and top face each other across the core and need as many elements as each other:
  // the one with fewer gets more in its outer intervals in the second pass.
  For Pass In {0 : 1}
    sp_at[] = BottomAt[];
    sp_size[] = BottomSize[];
    sp_least[] = BottomLeast[];
    Call Spacing;
    Bottom[] = sp_node[];
    BottomStop[] = sp_stop[];
    sp_at[] = TopAt[];
    sp_size[] = TopSize[];
    sp_least[] = TopLeast[];
    Call Spacing;
    Top[] = sp_node[];
    TopStop[] = sp_stop[];
    If (Pass == 0)
      BottomLast = #BottomStop[] - 2;
      TopLast = #TopStop[] - 2;
      For i In {0 : BottomLast}
        BottomLeast[i] = BottomStop[i + 1] - BottomStop[i];
      EndFor
      For i In {0 : TopLast}
        TopLeast[i] = TopStop[i + 1] - TopStop[i];
      EndFor
      More = #Top[] - #Bottom[];
      Share = Whole ? Floor(Fabs(More) / 2) : 0;
      If (More > 0)
        BottomLeast[0] += Share;
        BottomLeast[BottomLast] += More - Share;
      ElseIf (More < 0)
        TopLeast[0] += Share;
        TopLeast[TopLast] += -More - Share;
      EndIf
    EndIf
  EndFor
  sp_at[] = {Half / 4, 3 * Half / 4};
  sp_size[] = {sp_any, sp_any};
  sp_least[] = {1};
  Call Spacing;
  Side[] = sp_node[];

  ro_phi[] = {};
  For i In {0 : #Bottom[] - 1}
    ro_phi[] += Bottom[i] / Radius;
  EndFor
  ro_block[] = {0, #ro_phi[] - 1};
  For i In {1 : #Side[] - 1}
    ro_phi[] += Side[i] / Radius;
  EndFor
  ro_block[] += #ro_phi[] - 1;
  For i In {1 : #Top[] - 1}
    ro_phi[] += Top[i] / Radius;
  EndFor
  ro_block[] += #ro_phi[] - 1;
  If (Whole)
    For i In {1 : #Side[] - 1}
      ro_phi[] += Side[i] / Radius + Pi;
    EndFor
    ro_block[] += #ro_phi[] - 1;
  EndIf
EndIf

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

// Along the axis.
sp_cap = AlongCap;
sp_growth = AlongGrowth;
Least = Centred ? AlongLeast : 1;
en_radius = EndRadius;
sp_at[] = {};
sp_size[] = {};
sp_fine[] = {};
sp_least[] = {};
// Where plates end on a roller their edges press, and not its ends.
Ends = (PlateEdge == 0);
If (!Ends)
  en_radius = 0;
EndIf
If (Whole)
  If (!Ends)
    sp_at[] += -RollerLength / 2;
    sp_size[] += sp_any;
    sp_fine[] += 1;
    sp_least[] += 1;
    If (PlateEdgeFar > 0)
      sp_at[] += -PlateEdgeFar;
      sp_size[] += EndSize;
      sp_fine[] += 1;
      sp_least[] += 1;
    EndIf
  EndIf
  en_at = Ends ? -RollerLength / 2 : -PlateEdge;
  Call End;
  sp_least[] += Least;
EndIf
sp_at[] += Uniform ? 0 : Offset;
sp_size[] += CrossingSize;
sp_fine[] += 1;
sp_least[] += Least;
en_at = Ends ? RollerLength / 2 : PlateEdge;
Call End;
If (!Ends)
  If (PlateEdgeFar > 0)
    sp_at[] += PlateEdgeFar;
    sp_size[] += EndSize;
    sp_fine[] += 1;
    sp_least[] += 1;
  EndIf
  sp_at[] += RollerLength / 2;
  sp_size[] += sp_any;
  sp_fine[] += 1;
  sp_least[] += 1;
EndIf
Call Spacing;
ro_c[] = sp_node[];

ro_solid = Solid;
ro_split = Centred && Whole;
ro_radius = Radius;
ro_a = Offset;
ro_z = AxisHeight;

ro_turned = 0;
Call Roller;
UpperRoller[] = ro_volumes[];
UpperRollerSurface[] = ro_outer[];
UpperRollerBore[] = ro_bore[];
SymmetryX[] = ro_cut[];
SymmetryY[] = ro_start[];

ro_turned = 1;
Call Roller;
LowerRoller[] = ro_volumes[];
LowerRollerSurface[] = ro_outer[];
LowerRollerBore[] = ro_bore[];
SymmetryY[] += ro_cut[];
SymmetryX[] += ro_start[];

// --- plates ----------------------------------------------------------------------------------

// The flat plates, as the upper one: x across its roller, y along it; the lower one is its image
// under (x, y, z) -> (y, x, -z). PlanAcross and PlanAlong are the lengths in these directions.
For Plate In {0 : 1}
  PlanAcross = Plate ? PlanY : PlanX;
  PlanAlong = Plate ? PlanX : PlanY;
  Thickness = Plate ? LowerThickness : UpperThickness;
  CentreAcross = 2 * Offset;

  sp_cap = PlanCap;
  sp_growth = Growth;
  If (!Whole)
    sp_at[] = {0, PlanAcross / 2};
    sp_size[] = {PlateSize, sp_any};
  ElseIf (Uniform)
    sp_at[] = {CentreAcross - PlanAcross / 2, CentreAcross, CentreAcross + PlanAcross / 2};
    sp_size[] = {sp_any, sp_any, sp_any};
  Else
    sp_at[] = {CentreAcross - PlanAcross / 2, Offset, CentreAcross + PlanAcross / 2};
    sp_size[] = {sp_any, PlateSize, sp_any};
  EndIf
  sp_fine[] = {FineElements, FineElements, FineElements};
  sp_least[] = {1, 1};
  Call Spacing;
  Across[] = sp_node[];

  // Along the roller: refined at the crossing and where the roller ends.
  sp_cap = Uniform ? PlanCap : AlongCap;
  sp_growth = AlongGrowth;
  Outside = (PlanAlong > RollerLength * (1 + 1e-9)) && !Uniform;
  Far = Outside ? RollerLength / 2 : PlanAlong / 2;
  // A plate that is shorter than the roller has a sharp edge there.
  en_radius = Far < RollerLength / 2 * (1 - 1e-9) ? 0 : EndRadius;
  sp_at[] = {};
  sp_size[] = {};
  sp_fine[] = {};
  sp_least[] = {1, 1, 1, 1};
  If (Whole)
    If (Outside)
      sp_at[] += -PlanAlong / 2;
      sp_size[] += sp_any;
      sp_fine[] += 1;
    EndIf
    en_at = -Far;
    Call End;
  EndIf
  sp_at[] += Uniform ? 0 : Offset;
  sp_size[] += CrossingSize;
  sp_fine[] += 1;
  en_at = Far;
  Call End;
  If (Outside)
    sp_at[] += PlanAlong / 2;
    sp_size[] += sp_any;
    sp_fine[] += 1;
  EndIf
  Call Spacing;
  Along[] = sp_node[];

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
    sl_x[] = Along[];
    sl_y[] = Across[];
    sl_bottom = -FlatFace - Thickness;
    sl_top = -FlatFace;
    For i In {#sp_node[] - 1 : 0 : -1}
      sl_w[] += 1 - sp_node[i] / Thickness;
    EndFor
  Else
    sl_x[] = Across[];
    sl_y[] = Along[];
    sl_bottom = FlatFace;
    sl_top = FlatFace + Thickness;
    For i In {0 : #sp_node[] - 1}
      sl_w[] += sp_node[i] / Thickness;
    EndFor
  EndIf
  sl_ix[] = {0, #sl_x[] - 1};
  sl_iy[] = {0, #sl_y[] - 1};
  Call Slab;
  SymmetryX[] += sl_faces_x[];
  SymmetryY[] += sl_faces_y[];
  If (Plate)
    LowerPlate[] = sl_volumes[];
    LowerPlateBottom[] = sl_faces_bottom[];
    LowerPlateTop[] = sl_faces_top[];
  Else
    UpperPlate[] = sl_volumes[];
    UpperPlateBottom[] = sl_faces_bottom[];
    UpperPlateTop[] = sl_faces_top[];
  EndIf
EndFor

// The intermediate plate. Its two directions play the same parts, so one rule serves both.
For Direction In {0 : 1}
  Plan = Direction ? PlanY : PlanX;
  sp_cap = MiddleCap;
  sp_growth = Growth;
  If (Uniform)
    sp_at[] = {0, Plan / 2};
    sp_size[] = {sp_any, sp_any};
    sp_fine[] = {1, 1};
    Ridge = 0;
    If (Whole)
      sp_at[] = {-Plan / 2, 0, Plan / 2};
      sp_size[] += sp_any;
      sp_fine[] += 1;
      Ridge = 1;
    EndIf
  ElseIf (Centred)
    sp_at[] = {0, VLine, Plan / 2};
    sp_size[] = {sp_any, PlateSize, sp_any};
    sp_fine[] = {1, FineElements, 1};
    Ridge = 0;
    If (Whole)
      sp_at[] = {-Plan / 2, -VLine, 0, VLine, Plan / 2};
      sp_size[] = {sp_any, PlateSize, sp_any, PlateSize, sp_any};
      sp_fine[] = {1, FineElements, 1, FineElements, 1};
      Ridge = 2;
    EndIf
  Else
    // The rollers bear on one slope near their far ends: refined there too.
    Outside = (Plan / 2 > RollerLength / 2 * (1 + 1e-9)) && (RollerLength / 2 > VLine * (1 + 1e-9));
    sp_at[] = {-Plan / 2, 0, VLine};
    sp_size[] = {sp_any, sp_any, PlateSize};
    sp_fine[] = {1, 1, FineElements};
    Far = Outside ? RollerLength / 2 : Plan / 2;
    en_radius = Far < RollerLength / 2 * (1 - 1e-9) ? 0 : EndRadius;
    en_at = Far;
    Call End;
    If (Outside)
      sp_at[] += Plan / 2;
      sp_size[] += sp_any;
      sp_fine[] += 1;
    EndIf
    Ridge = 1;
  EndIf
  sp_least[] = {1, 1, 1, 1, 1, 1};
  Call Spacing;
  Index[] = {0};
  If (Whole)
    Index[] += sp_stop[Ridge];
  EndIf
  Index[] += #sp_node[] - 1;
  If (Direction)
    sl_y[] = sp_node[];
    sl_iy[] = Index[];
  Else
    sl_x[] = sp_node[];
    sl_ix[] = Index[];
  EndIf
EndFor

// A layer of nodes half-way: turned by half about x = y it is its own image.
If (Uniform)
  sp_at[] = {0, MiddleThickness};
  sp_size[] = {sp_any, sp_any};
  sp_fine[] = {1, 1};
  sp_least[] = {DepthLeast};
Else
  sp_at[] = {0, MiddleThickness / 2, MiddleThickness};
  sp_size[] = {PlateSize, sp_any, PlateSize};
  sp_fine[] = {FineLayers, 1, FineLayers};
  sp_least[] = {Ceil(DepthLeast / 2), Ceil(DepthLeast / 2)};
EndIf
sp_cap = DepthCap;
sp_growth = DepthGrowth;
Call Spacing;
sl_w[] = {};
For i In {0 : #sp_node[] - 1}
  sl_w[] += sp_node[i] / MiddleThickness;
EndFor
sl_bottom = -MiddleThickness / 2;
sl_top = MiddleThickness / 2;
sl_bottom_slope = Tan(Slope);
sl_top_slope = Tan(Slope);
Call Slab;
SymmetryX[] += sl_faces_x[];
SymmetryY[] += sl_faces_y[];

// --- names -----------------------------------------------------------------------------------

Physical Volume("upper_plate") = UpperPlate[];
Physical Volume("upper_roller") = UpperRoller[];
Physical Volume("intermediate_plate") = sl_volumes[];
Physical Volume("lower_roller") = LowerRoller[];
Physical Volume("lower_plate") = LowerPlate[];

Physical Surface("upper_plate_top") = UpperPlateTop[];
Physical Surface("upper_plate_bottom") = UpperPlateBottom[];
Physical Surface("upper_roller_surface") = UpperRollerSurface[];
Physical Surface("intermediate_plate_top") = sl_faces_top[];
Physical Surface("intermediate_plate_bottom") = sl_faces_bottom[];
Physical Surface("lower_roller_surface") = LowerRollerSurface[];
Physical Surface("lower_plate_top") = LowerPlateTop[];
Physical Surface("lower_plate_bottom") = LowerPlateBottom[];
If (!Solid)
  Physical Surface("upper_roller_bore") = UpperRollerBore[];
  Physical Surface("lower_roller_bore") = LowerRollerBore[];
EndIf
If (!Whole)
  Physical Surface("x_symmetry") = SymmetryX[];
  Physical Surface("y_symmetry") = SymmetryY[];
EndIf
