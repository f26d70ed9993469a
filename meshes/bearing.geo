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
  // Element size across the contact lines, on the roller and on the plates.
  RollerSize = {0.025, Name "Mesh/Size across contact lines, rollers"}
  PlateSize = {0.0265, Name "Mesh/Size across contact lines, plates"}
  // Elements of that size on either side of a contact line.
  FineElements = {2, Name "Mesh/Fine elements each side"}
  // Largest ratio of neighbouring elements: across the lines, into the depth, along the rollers.
  Growth = {1.7, Name "Mesh/Growth across"}
  DepthGrowth = {1.8, Name "Mesh/Growth into the depth"}
  AlongGrowth = {1.4, Name "Mesh/Growth along"}
  // Element size along a roller where the other one crosses, and at its ends.
  CrossingSize = {0.1, Name "Mesh/Size at the crossing"}
  EndSize = {0.15, Name "Mesh/Size at the roller ends"}
  // Largest elements: around and along the rollers, in plan, through the wall and the plates.
  AroundCap = {0.5, Name "Mesh/Largest around"}
  AlongCap = {0.5, Name "Mesh/Largest along"}
  PlanCap = {0.8, Name "Mesh/Largest in plan"}
  WallCap = {0.15, Name "Mesh/Largest through the wall"}
  DepthCap = {0.25, Name "Mesh/Largest through the plates"}
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
Quarter = Half / 2;
sp_least[] = {};
If (!Solid)
  If (Uniform)
    If (Whole)
      sp_at[] = {-Half, 0, Half};
      Blocks[] = {0, 1, 2};
    Else
      sp_at[] = {0, Half};
      Blocks[] = {0, 1};
    EndIf
    sp_size[] = {AroundCap, AroundCap, AroundCap};
  ElseIf (!Whole)
    sp_at[] = {0, Contact, Half};
    sp_size[] = {AroundCap, RollerSize, RollerSize};
    Blocks[] = {0, 2};
  ElseIf (Centred)
    sp_at[] = {-Half, -Contact, 0, Contact, Half};
    sp_size[] = {RollerSize, RollerSize, AroundCap, RollerSize, RollerSize};
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
EndIf

// Through the wall, from the inside out.
ro_inner = Solid ? 0.5 * Radius : Radius - Wall;
sp_at[] = {ro_inner, Radius};
sp_size[] = {WallCap, RollerSize};
sp_fine[] = {1, 1};
sp_least[] = {1};
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
If (Centred && Whole)
  sp_at[] = {-RollerLength / 2, 0, RollerLength / 2};
  sp_size[] = {EndSize, CrossingSize, EndSize};
ElseIf (Centred)
  sp_at[] = {0, RollerLength / 2};
  sp_size[] = {CrossingSize, EndSize};
ElseIf (Uniform)
  sp_at[] = {-RollerLength / 2, 0, RollerLength / 2};
  sp_size[] = {EndSize, CrossingSize, EndSize};
Else
  sp_at[] = {-RollerLength / 2, Offset, RollerLength / 2};
  sp_size[] = {EndSize, CrossingSize, EndSize};
EndIf
sp_fine[] = {1, 1, 1};
sp_least[] = {1, 1};
Call Spacing;
ro_c[] = sp_node[];

ro_solid = Solid;
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
    sp_size[] = {PlateSize, PlanCap};
  ElseIf (Uniform)
    sp_at[] = {CentreAcross - PlanAcross / 2, CentreAcross, CentreAcross + PlanAcross / 2};
    sp_size[] = {PlanCap, PlanCap, PlanCap};
  Else
    sp_at[] = {CentreAcross - PlanAcross / 2, Offset, CentreAcross + PlanAcross / 2};
    sp_size[] = {PlanCap, PlateSize, PlanCap};
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
  sp_at[] = {};
  sp_size[] = {};
  If (Whole)
    If (Outside)
      sp_at[] += -PlanAlong / 2;
      sp_size[] += PlanCap;
    EndIf
    sp_at[] += -Far;
    sp_size[] += EndSize;
  EndIf
  sp_at[] += Uniform ? 0 : Offset;
  sp_size[] += CrossingSize;
  sp_at[] += Far;
  sp_size[] += EndSize;
  If (Outside)
    sp_at[] += PlanAlong / 2;
    sp_size[] += PlanCap;
  EndIf
  sp_fine[] = {1, 1, 1, 1, 1};
  sp_least[] = {1, 1, 1, 1};
  Call Spacing;
  Along[] = sp_node[];

  // Through the thickness, from the contact face.
  sp_at[] = {0, Thickness};
  sp_size[] = {PlateSize, DepthCap};
  sp_fine[] = {1, 1};
  sp_least[] = {1};
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
  sp_cap = PlanCap;
  sp_growth = Growth;
  If (Uniform)
    sp_at[] = {0, Plan / 2};
    sp_size[] = {PlanCap, PlanCap};
    sp_fine[] = {1, 1};
    Ridge = 0;
    If (Whole)
      sp_at[] = {-Plan / 2, 0, Plan / 2};
      sp_size[] += PlanCap;
      sp_fine[] += 1;
      Ridge = 1;
    EndIf
  ElseIf (Centred)
    sp_at[] = {0, VLine, Plan / 2};
    sp_size[] = {PlanCap, PlateSize, PlanCap};
    sp_fine[] = {1, FineElements, 1};
    Ridge = 0;
    If (Whole)
      sp_at[] = {-Plan / 2, -VLine, 0, VLine, Plan / 2};
      sp_size[] = {PlanCap, PlateSize, PlanCap, PlateSize, PlanCap};
      sp_fine[] = {1, FineElements, 1, FineElements, 1};
      Ridge = 2;
    EndIf
  Else
    // The rollers bear on one slope near their far ends: refined there too.
    Outside = (Plan / 2 > RollerLength / 2 * (1 + 1e-9)) && (RollerLength / 2 > VLine * (1 + 1e-9));
    sp_at[] = {-Plan / 2, 0, VLine};
    sp_size[] = {PlanCap, PlanCap, PlateSize};
    sp_fine[] = {1, 1, FineElements};
    If (Outside)
      sp_at[] += {RollerLength / 2, Plan / 2};
      sp_size[] += {EndSize, PlanCap};
      sp_fine[] += {1, 1};
    Else
      sp_at[] += Plan / 2;
      sp_size[] += EndSize;
      sp_fine[] += 1;
    EndIf
    Ridge = 1;
  EndIf
  sp_least[] = {1, 1, 1, 1};
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

sp_at[] = {0, MiddleThickness};
sp_size[] = {PlateSize, PlateSize};
sp_fine[] = {1, 1};
sp_least[] = {1};
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
