// An aircraft with a ring wing on two struts, genus 2:
//     gmsh -2 -format stl ringPlane.geo && surfaceConvert ringPlane.stl ringPlane.obj.gz
SetFactory("OpenCASCADE");

// Fuselage along x, its nose at 0
Cylinder(1) = {1.2, 0, 0, 4.3, 0, 0, 0.5};
Sphere(2) = {0, 0, 0, 1};
Dilate {{0, 0, 0}, {1.2, 0.5, 0.5}} { Volume{2}; }
Translate {1.2, 0, 0} { Volume{2}; }
Cone(3) = {5.5, 0, 0, 2, 0, 0, 0.5, 0.15};

// Wings and fin
Box(4) = {2.6, -3.2, -0.1, 1.2, 6.4, 0.16};
Box(5) = {6.2, -0.05, 0.2, 0.9, 0.1, 1.2};

// The ring around the tail, and its struts beside it
Cylinder(6) = {5.4, 0, 0, 1.4, 0, 0, 1.7};
Cylinder(7) = {5.3, 0, 0, 1.6, 0, 0, 1.56};
BooleanDifference(8) = { Volume{6}; Delete; }{ Volume{7}; Delete; };
Box(9) = {5.7, 0.2, -0.06, 0.8, 1.4, 0.12};
Box(10) = {5.7, -1.6, -0.06, 0.8, 1.4, 0.12};
BooleanUnion(20) = { Volume{1}; Delete; }{ Volume{2:5, 8:10}; Delete; };

Mesh.MeshSizeMin = 0.05;
Mesh.MeshSizeMax = 0.09;
Mesh.MeshSizeFromCurvature = 40;
Mesh.Algorithm = 6;
