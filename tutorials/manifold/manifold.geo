// An intake manifold [mm], by gmsh's OpenCASCADE: fluid.step is what flows in it,
// body.step its metal
SetFactory("OpenCASCADE");

// Solid v: a plenum of radius R with a domed end, and two runners of radius r
// whose junctions are rounded
Macro Manifold
  Cylinder(v + 1) = {-40, 0, 0, 220, 0, 0, R};
  Sphere(v + 2) = {180, 0, 0, R};
  Cylinder(v + 3) = {60, 0, 0, 0, 100, 0, r};
  Cylinder(v + 4) = {140, 0, 0, 0, 100, 0, r};
  BooleanUnion(v) = { Volume{v + 1}; Delete; }{ Volume{v + 2 : v + 4}; Delete; };

  junctions[] = {};
  curves[] = Abs(Unique(Boundary{ Surface{ Boundary{ Volume{v}; } }; }));
  For i In {0 : #curves[] - 1}
    box[] = BoundingBox Curve{ curves[i] };
    If (Abs(box[3] - box[0] - 2*r) < 1e-3 && box[4] - box[1] > 1e-3)
      junctions[] += curves[i];
    EndIf
  EndFor
  made[] = Fillet{ v }{ junctions[] }{ 6 };
  solid = made[0];
Return

v = 10; R = 20; r = 13;
Call Manifold;
Save "fluid.step";
fluid = solid;

v = 20; R = 24; r = 17;
Call Manifold;

// The flange with four holes
Cylinder(30) = {-40, 0, 0, 8, 0, 0, 44};
For i In {0 : 3}
  Cylinder(31 + i) = {-50, 34*Cos(Pi*(i + 0.5)/2), 34*Sin(Pi*(i + 0.5)/2), 30, 0, 0, 5};
EndFor
BooleanUnion(40) = { Volume{solid}; Delete; }{ Volume{30}; Delete; };
BooleanDifference(41) = { Volume{40}; Delete; }{ Volume{fluid, 31 : 34}; Delete; };
Save "body.step";
