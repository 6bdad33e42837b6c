// A shell with two nozzles, and a tube through it [mm], by gmsh's OpenCASCADE.
// Triangles of faces between two solids are written once.
SetFactory("OpenCASCADE");

// Shell and nozzles
Cylinder(1) = {0, 0, 0, 100, 0, 0, 15};
Cylinder(2) = {16, 0, 0, 0, 0, 25, 5};
Cylinder(3) = {84, 0, 0, 0, 0, -25, 5};
BooleanUnion(10) = { Volume{1}; Delete; }{ Volume{2, 3}; Delete; };

// The tube, and what flows in it
Cylinder(20) = {0, 0, 0, 100, 0, 0, 5};
Cylinder(30) = {0, 0, 0, 100, 0, 0, 4};
BooleanFragments{ Volume{10}; Delete; }{ Volume{20, 30}; Delete; }

// Patches, by what is in boxes around the axis
e = 0.01;
r = 4 + e;
hotInlet() = Surface In BoundingBox{-e, -r, -r, e, r, r};
hotOutlet() = Surface In BoundingBox{100 - e, -r, -r, 100 + e, r, r};
hotEnds() = {hotInlet(), hotOutlet()};
tubeInside() = Surface In BoundingBox{-e, -r, -r, 100 + e, r, r};
tubeInside() -= hotEnds();

r = 5 + e;
tubeEnds() = Surface In BoundingBox{-e, -r, -r, e, r, r};
tubeEnds() += Surface In BoundingBox{100 - e, -r, -r, 100 + e, r, r};
tubeEnds() -= hotEnds();
tubeOutside() = Surface In BoundingBox{-e, -r, -r, 100 + e, r, r};
tubeOutside() -= {hotEnds(), tubeEnds(), tubeInside()};

coldInlet() = Surface In BoundingBox{0, -r, 25 - e, 100, r, 25 + e};
coldOutlet() = Surface In BoundingBox{0, -r, -25 - e, 100, r, -25 + e};
shell() = Surface{:};
shell() -= {hotEnds(), tubeEnds(), tubeInside(), tubeOutside()};
shell() -= {coldInlet(), coldOutlet()};

Physical Surface("hotInlet") = hotInlet();
Physical Surface("hotOutlet") = hotOutlet();
Physical Surface("tubeEnds") = tubeEnds();
Physical Surface("tubeInside") = tubeInside();
Physical Surface("tubeOutside") = tubeOutside();
Physical Surface("coldInlet") = coldInlet();
Physical Surface("coldOutlet") = coldOutlet();
Physical Surface("shell") = shell();

// Lengths of edges
Characteristic Length{ PointsOf{ Surface{:}; } } = 2.5;
tube() = {tubeInside(), tubeOutside()};
Characteristic Length{ PointsOf{ Surface{tube()}; } } = 1.4;

// In the file lengths are in m
Mesh.ScalingFactor = 0.001;
