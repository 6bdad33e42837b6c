// Tetrahedra between the outside of the layers, whose triangles stay as they
// are, and a box

Merge "layerOuter.msh";         // surface 1

Point(10001) = {-9, -3, -3, 0.6};
Point(10002) = { 5, -3, -3, 0.6};
Point(10003) = { 5,  3, -3, 0.6};
Point(10004) = {-9,  3, -3, 0.6};
Point(10005) = {-9, -3,  3, 0.6};
Point(10006) = { 5, -3,  3, 0.6};
Point(10007) = { 5,  3,  3, 0.6};
Point(10008) = {-9,  3,  3, 0.6};

Line(101) = {10001, 10002};
Line(102) = {10002, 10003};
Line(103) = {10003, 10004};
Line(104) = {10004, 10001};
Line(105) = {10005, 10006};
Line(106) = {10006, 10007};
Line(107) = {10007, 10008};
Line(108) = {10008, 10005};
Line(109) = {10001, 10005};
Line(110) = {10002, 10006};
Line(111) = {10003, 10007};
Line(112) = {10004, 10008};

Curve Loop(201) = {101, 102, 103, 104};     Plane Surface(201) = {201};
Curve Loop(202) = {105, 106, 107, 108};     Plane Surface(202) = {202};
Curve Loop(203) = {101, 110, -105, -109};   Plane Surface(203) = {203};
Curve Loop(204) = {103, 112, -107, -111};   Plane Surface(204) = {204};
Curve Loop(205) = {102, 111, -106, -110};   Plane Surface(205) = {205};
Curve Loop(206) = {104, 109, -108, -112};   Plane Surface(206) = {206};

Surface Loop(301) = {201:206};
Surface Loop(302) = {1};
Volume(1) = {301, 302};

Physical Surface("farField") = {1};
Physical Surface("inlet") = {205};
Physical Surface("outlet") = {206};
Physical Surface("sides") = {201, 202, 203, 204};
Physical Volume("fluid") = {1};

// Sizes grow from those of the triangles to those of the box; smaller ones
// around the body and in its wake
Field[1] = Box;
Field[1].XMin = -3;
Field[1].XMax = 1.6;
Field[1].YMin = -0.3;
Field[1].YMax = 0.3;
Field[1].ZMin = -0.3;
Field[1].ZMax = 0.3;
Field[1].VIn = 0.07;
Field[1].VOut = 0.6;
Field[1].Thickness = 2;
Background Field = 1;

Mesh.Algorithm3D = 1;
Mesh.Optimize = 1;
Mesh.OptimizeThreshold = 0.5;
Mesh.MshFileVersion = 2.2;
Mesh.SaveAll = 0;
