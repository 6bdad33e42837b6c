// A square duct with a corner, and three guide vanes of no thickness [m]: two
// stand on the floor and the ceiling, the third one on the floor alone.
h = 0.12;                   // length of edges
hVane = 0.06;

// The outline of the floor: from the inlet at x = -2 to the outlet at y = 3.
// The inner corner is at (0, 1), the outer one at (1, 0).
corners() = {};
x() = {-2, 1, 1, 0, 0, -2};
y() = { 0, 0, 3, 3, 1, 1};
For level In {0 : 1}
    For i In {0 : 5}
        p = newp; Point(p) = {x(i), y(i), level, h};
        corners() += p;
    EndFor
EndFor
around() = {};
For level In {0 : 1}
    For i In {0 : 5}
        c = newc;
        Line(c) = {corners(6*level + i), corners(6*level + (i + 1)%6)};
        around() += c;
    EndFor
EndFor
upright() = {};
For i In {0 : 5}
    c = newc; Line(c) = {corners(i), corners(6 + i)};
    upright() += c;
EndFor

// Vanes: quarters of circles about the inner corner, and their heights
radius() = {0.3, 0.55, 0.8};
height() = {1, 1, 0.6};
centres() = {};
For level In {0 : 1}
    p = newp; Point(p) = {0, 1, level, h};
    centres() += p;
EndFor
bottom() = {};
top() = {};
vanes() = {};
For i In {0 : 2}
    r = radius(i);
    z = height(i);
    centre = newp; Point(centre) = {0, 1, z, h};
    a = newp; Point(a) = {0, 1 - r, 0, hVane};
    b = newp; Point(b) = {r, 1, 0, hVane};
    c = newp; Point(c) = {0, 1 - r, z, hVane};
    d = newp; Point(d) = {r, 1, z, hVane};
    ab = newc; Circle(ab) = {a, centres(0), b};
    cd = newc; Circle(cd) = {c, centre, d};
    ac = newc; Line(ac) = {a, c};
    bd = newc; Line(bd) = {b, d};
    loop = newll; Curve Loop(loop) = {ab, bd, -cd, -ac};
    s = news; Surface(s) = {loop};
    bottom() += ab;
    top() += cd;
    vanes() += s;
EndFor

// Floor and ceiling, with the curves on which vanes stand
loop = newll; Curve Loop(loop) = {around(0), around(1), around(2), around(3),
    around(4), around(5)};
floor = news; Plane Surface(floor) = {loop};
Curve{bottom(0), bottom(1), bottom(2)} In Surface{floor};
loop = newll; Curve Loop(loop) = {around(6), around(7), around(8), around(9),
    around(10), around(11)};
ceiling = news; Plane Surface(ceiling) = {loop};
Curve{top(0), top(1)} In Surface{ceiling};

sides() = {};
For i In {0 : 5}
    loop = newll;
    Curve Loop(loop) = {around(i), upright((i + 1)%6), -around(6 + i),
        -upright(i)};
    s = news; Plane Surface(s) = {loop};
    sides() += s;
EndFor

Physical Surface("outlet") = {sides(2)};
Physical Surface("inlet") = {sides(5)};
Physical Surface("walls") = {floor, ceiling, sides(0), sides(1), sides(3),
    sides(4)};
Physical Surface("vanes") = {vanes()};
